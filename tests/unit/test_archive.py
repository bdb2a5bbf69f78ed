"""A saved plan comes back with every number, and what cannot come back is told with its remedy."""

import json
import os
import re
import shutil
import signal
import subprocess
import sys
import time
from dataclasses import dataclass, fields, is_dataclass, replace
from pathlib import Path

import coal
import numpy as np
import pinocchio as pin
import pytest
from chains import chain, seeds
from examples import examples
from hypothesis import HealthCheck, Phase, given
from hypothesis import strategies as st

import manipplan as mp
from manipplan.cost.integral import PathIntegral
from manipplan.optimize.result import make_result
from manipplan.plans.archive import checksum, fingerprint
from manipplan.plans.measure import measure_plan
from manipplan.plans.result import Plan

#: What only the solvers need.
LEFT_OUT = {"history", "rivals", "search", "cache", "model", "geometry", "built"}


def assert_same(first, second, where=""):
    """Every field that is kept is equal to the last bit."""
    assert type(first) is type(second), where
    if isinstance(first, np.ndarray):
        np.testing.assert_array_equal(first, second, err_msg=where)
    elif isinstance(first, mp.Scene):
        assert first.names == second.names
        for one, other in zip(first.obstacles, second.obstacles, strict=True):
            assert_same(one if one.name else replace(one, name=other.name), other, where)
    elif is_dataclass(first):
        for each in fields(first):
            if each.name not in LEFT_OUT:
                assert_same(getattr(first, each.name), getattr(second, each.name), f"{where}.{each.name}")
    elif isinstance(first, dict):
        assert first.keys() == second.keys(), where
        for key in first:
            assert_same(first[key], second[key], f"{where}[{key}]")
    elif isinstance(first, tuple):
        assert len(first) == len(second), where
        for k, (one, other) in enumerate(zip(first, second, strict=True)):
            assert_same(one, other, f"{where}[{k}]")
    elif isinstance(first, float):
        np.testing.assert_equal(first, second, err_msg=where)  # nan is nan
    else:
        assert first == second, where


def made_plan(robot, path, *, scene=None, task=None, measure=None, power=1.0, metric=None, workspace_path=None):
    """A plan along a path that is given, without any search."""
    scene = scene or mp.Scene()
    model = scene.collision_model(robot)
    objective = PathIntegral(kinematics=robot.kinematics(task, measure=measure, compiled=False), power=power, metric=metric)
    cost = objective.cost(path)
    seed = mp.JointPath.through(path(np.linspace(0, 1, 5)))
    status = mp.Status.OPTIMAL
    result = make_result(
        path, objective, cost=cost, seed=seed, seed_cost=objective.cost(seed), model=model, clearance=0.0, status=status
    )
    trajectory = mp.retime(path, robot)
    report = measure_plan(trajectory, result, model, path.goal, clearance=0.0, torque=False)
    return Plan(
        robot=robot,
        scene=scene,
        status=status,
        path=path,
        trajectory=trajectory,
        report=report,
        result=result,
        workspace_path=workspace_path,
    )


@pytest.fixture(scope="module")
def small_plan(planar):
    scene = mp.Scene([mp.Cylinder(radius=0.1, length=1.0, position=(0.0, 2.5, 0.0), name="post")])
    return made_plan(planar, mp.JointPath.line([0.1, 0.5, 0.7], [0.9, 1.0, 0.4]), scene=scene)


def stored(folder):
    return json.loads((folder / "plan.json").read_text())


#: An octahedron around (0.1, 0, 0) with the bounding box of the block.
TIPS = np.array([0.1, 0, 0]) + np.array([[0.05, 0, 0], [-0.05, 0, 0], [0, 0.1, 0], [0, -0.1, 0], [0, 0, 0.05], [0, 0, -0.05]])
DIAMOND = TIPS[[[0, 2, 4], [2, 1, 4], [1, 3, 4], [3, 0, 4], [2, 0, 5], [1, 2, 5], [3, 1, 5], [0, 3, 5]]]


@pytest.fixture(scope="module")
def changed_plan(planar):
    pose = pin.SE3(pin.utils.rotate("z", 0.4), np.array([0.2, -0.1, 0.0]))
    robot = (
        planar.at(pose).with_tool(pose, name="nozzle").attach(mp.Box(size=(0.1, 0.2, 0.1), position=(0.1, 0, 0)), name="block")
    )
    robot = robot.with_tool(pose, name="tip")
    scene = mp.Scene([mp.Cylinder(radius=0.1, length=1.0, position=(0.0, 2.5, 0.0), name="post")], allowed=[("post", "block")])
    return made_plan(robot, mp.JointPath.line([0.1, 0.5, 0.7], [0.9, 1.0, 0.4]), scene=scene)


@pytest.mark.slow
def test_an_arm_with_another_base_tool_and_part_comes_back(changed_plan, tmp_path):
    changed_plan.save(tmp_path)
    again = mp.Plan.load(tmp_path)
    assert again.robot.tool == "tip" and list(again.robot.carried) == ["block"] and again.robot.planar
    assert again.scene.allowed == changed_plan.scene.allowed
    q = changed_plan.path(0.3)
    np.testing.assert_allclose(again.robot.kinematics().pose(q), changed_plan.robot.kinematics().pose(q), atol=1e-12)
    np.testing.assert_allclose(again.scene.distances(again.robot, q), changed_plan.scene.distances(changed_plan.robot, q))


@pytest.mark.slow
@pytest.mark.parametrize("other", ["tip", "block", "base", "shape"])
def test_an_arm_that_was_changed_otherwise_is_refused(changed_plan, planar, tmp_path, other):
    changed_plan.save(tmp_path)
    pose = planar.at(changed_plan.robot.base).base
    robot = planar.at(np.eye(4) if other == "base" else pose)
    if other in ("block", "shape"):
        robot = robot.with_tool(changed_plan.robot.added_frames[0].pose @ changed_plan.robot.added_frames[1].pose)
    if other == "shape":  # of the same bounding box
        place = np.linalg.inv(changed_plan.robot.added_frames[1].pose)
        robot = robot.attach(mp.Mesh(triangles=DIAMOND, name="block").at(place))
    with pytest.raises(mp.errors.FileFormatError, match="it is another robot"):
        mp.Plan.load(tmp_path, robot=robot)


@pytest.mark.slow
def test_a_part_of_an_unknown_class_needs_the_robot(planar, tmp_path):
    class Cube(mp.Box):
        pass

    class Own:
        name = "own"
        pose = pin.SE3.Identity()

        def shapes(self):
            return [coal.Sphere(0.1)]

        def at(self, pose):
            return self

    for part in (Cube(size=(0.1, 0.1, 0.1)), Own()):
        robot = planar.attach(part)
        made_plan(robot, mp.JointPath.line([0.1, 0.5, 0.7], [0.9, 1.0, 0.4])).save(tmp_path)
        with pytest.raises(
            mp.errors.FileFormatError, match=r"with its robot, but it has the part '(part|own)'.*(Cube|Own).*give robot="
        ):
            mp.Plan.load(tmp_path)
        assert mp.Plan.load(tmp_path, robot=robot).robot is robot


@pytest.mark.slow
def test_a_real_plan_comes_back(demo_plan, tmp_path):
    demo_plan.save(tmp_path / "first")
    again = mp.Plan.load(tmp_path / "first")
    assert_same(demo_plan, again)
    again.save(tmp_path / "second")
    for file in (tmp_path / "first").iterdir():
        assert file.read_bytes() == (tmp_path / "second" / file.name).read_bytes(), file.name


@pytest.mark.slow
def test_the_loaded_robot_moves_and_collides_as_the_first(demo_plan, tmp_path, rng):
    demo_plan.save(tmp_path)
    again = mp.Plan.load(tmp_path / "plan.json")
    for q in demo_plan.robot.random_configuration(rng, size=5):
        np.testing.assert_array_equal(
            again.robot.kinematics(compiled=False).pose(q), demo_plan.robot.kinematics(compiled=False).pose(q)
        )
        np.testing.assert_allclose(
            again.scene.distances(again.robot, q), demo_plan.scene.distances(demo_plan.robot, q), rtol=0, atol=1e-12
        )


@pytest.mark.slow
@examples(12, phases=[Phase.generate], suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(
    lengths=st.lists(st.floats(0.2, 2.0), min_size=2, max_size=4),
    power=st.floats(0.3, 3.0),
    measure=st.sampled_from(
        [
            None,
            "frobenius",
            mp.measures.JointLimitPenalised(measure=mp.measures.Isotropy(), k=3.0),
            mp.measures.LogDet(regularisation=0.3),
        ]
    ),
    size=st.floats(0.01, 0.3),
    turn=st.floats(-1.0, 1.0),
    weighed=st.booleans(),
)
def test_every_number_survives(tmp_path, lengths, power, measure, size, turn, weighed):
    arm = mp.planar_arm(lengths).with_limits(lower=-3.0, upper=3.1, velocity=2.0 + size)
    n = arm.n
    scene = mp.Scene(
        [
            mp.Box(size=(size, 0.1, 0.2), position=(9.0, 9.0 + turn, 0.0), rotation=(turn, 0.2, 0.1)),
            mp.Capsule(radius=size, length=0.3, position=(-12.0, 0.0, 0.0), name="rod"),
            mp.Plane(position=(0.0, 0.0, -1.0 - size)),
        ]
    )
    path = mp.JointPath.line(np.full(n, 0.4), np.full(n, 0.9 + size))
    metric = np.diag(np.linspace(1.0, 2.0 + size, n)) if weighed else None
    workspace = mp.CartesianPath.circle(pin.SE3.Identity(), (0.1, size, 0.0), (0.0, 0.0, 1.0), 1.0 + turn / 2, turning=weighed)
    if measure is not None and measure != "frobenius" and not measure.larger_is_better:
        measure = mp.measures.ForceTransmission(direction=[1.0, turn])
    plan = made_plan(arm, path, scene=scene, measure=measure, power=power, metric=metric, workspace_path=workspace)
    plan.save(tmp_path)
    assert_same(plan, mp.Plan.load(tmp_path))


@pytest.mark.slow
def test_a_followed_path_comes_back(planar, small_plan, tmp_path):
    poses = planar.kinematics(mp.Task.planar(), compiled=False).pose(small_plan.path(np.linspace(0, 1, 4)))
    for workspace in (mp.CartesianPath.through(list(poses)), mp.CartesianPath.line(poses[0], poses[-1])):
        refined = mp.results.Refinement(
            q=small_plan.path(np.linspace(0, 1, 4)), manipulability=np.arange(4.0), discrete=0.1, resampled=0.2, refined=0.3,
            bound=0.4, length=1.0, history=(0.1, 0.3),
        )  # fmt: skip
        deviation = mp.results.Deviation(position=1e-4, position_at=0.3, rotation=1e-3, rotation_at=0.7)
        report = replace(small_plan.report, deviation=deviation)
        followed = {"workspace_path": workspace, "refinement": refined, "report": report}
        plan = replace(small_plan, **followed, tolerance=mp.Tolerance(position=0.01), message="for a test")
        plan.save(tmp_path)
        again = mp.Plan.load(tmp_path)
        assert_same(plan, again)
        np.testing.assert_array_equal(workspace(0.37), again.workspace_path(0.37))


@pytest.mark.slow
def test_an_improved_recording_comes_back(planar, tmp_path):
    """Its files are the same again, the picture with its names among them."""
    slow = mp.retime(mp.JointPath.line([0.3, 0.5, 0.6], [0.8, 0.4, 0.8]), planar).slower(4.0)
    plan = mp.improve(planar, slow)
    nothing = replace(
        plan, status=mp.Status.NOT_BETTER, path=plan.result.seed, result=replace(plan.result, path=plan.result.seed)
    )
    for name, each in (("improved", plan), ("not_better", nothing)):
        each.save(tmp_path / name)
        again = mp.Plan.load(tmp_path / name)
        assert again.comparison == each.comparison
        assert (again.result.seed is again.path) == (each.result.seed is each.path)
        again.save(tmp_path / name / "again")
        for file in (tmp_path / name / "again").iterdir():
            assert file.read_bytes() == (tmp_path / name / file.name).read_bytes(), file.name


@pytest.mark.slow
def test_a_robot_file_moves_with_the_result(two_link_urdf, tmp_path):
    """Saved beside its URDF, both moved: the URDF is found from the result."""
    (tmp_path / "cell").mkdir()
    urdf = Path(shutil.copy(two_link_urdf(), tmp_path / "cell" / "arm.urdf"))
    arm = mp.Robot.from_urdf(urdf, tool="tip", locked={"finger": 0.02}, acceleration=[3.0, 2.0], name="mine")
    plan = made_plan(arm, mp.JointPath.line([0.1, 0.1], [0.6, 0.3]), task=mp.Task.direction((1.0, 0.0, 0.0)))
    plan.save(tmp_path / "cell" / "result")
    assert_same(plan, mp.Plan.load(tmp_path / "cell" / "result"))
    (tmp_path / "cell").rename(tmp_path / "elsewhere")
    again = mp.Plan.load(tmp_path / "elsewhere" / "result")
    assert again.robot.source.file == tmp_path / "elsewhere" / "arm.urdf"
    assert_same(plan.robot.limits, again.robot.limits)
    assert again.robot.locked == arm.locked


@pytest.mark.slow
def test_a_robot_file_that_is_gone_or_changed(two_link_urdf, tmp_path, caplog):
    urdf = Path(shutil.copy(two_link_urdf(), tmp_path / "arm.urdf"))
    arm = mp.Robot.from_urdf(urdf, tool="tip")
    made_plan(arm, mp.JointPath.line([0.1, 0.1], [0.6, 0.3]), task=mp.Task.direction((1.0, 0.0, 0.0))).save(tmp_path / "result")
    text = urdf.read_text()
    urdf.write_text(text.replace('xyz="0.5 0 0.2"', 'xyz="0.5 0 0.21"'))
    with pytest.raises(mp.errors.FileFormatError, match=r"robot: got .*changed, or it is another robot"):
        mp.Plan.load(tmp_path / "result")
    urdf.write_text(text.replace('"slide"', '"glide"'))
    with pytest.raises(mp.errors.FileFormatError, match=r"robot: got .*glide.*; allowed: the robot of .*slide"):
        mp.Plan.load(tmp_path / "result")
    urdf.write_text(text.replace('axis xyz="0 0 1"', 'axis xyz="0 1 0"'))
    with pytest.raises(mp.errors.FileFormatError, match="another robot"):
        mp.Plan.load(tmp_path / "result")
    for old, new in (('size="0.5 0.1 0.1"', 'size="0.5 0.1 0.2"'), ('xyz="0.25 0 0"', 'xyz="0.25 0.1 0"'), ("<collision>", "")):
        bodies = text.replace(old, new) if new else re.sub(r"<collision>.*?</collision>", "", text, count=1)
        assert bodies != text
        urdf.write_text(bodies)
        with pytest.raises(mp.errors.FileFormatError, match="changed, or it is another robot"):
            mp.Plan.load(tmp_path / "result")
    urdf.unlink()
    with pytest.raises(
        mp.errors.FileFormatError, match=r"arm.urdf'; allowed: an existing file.*put its files back, or give robot="
    ):
        mp.Plan.load(tmp_path / "result")
    assert mp.Plan.load(tmp_path / "result", robot=arm).robot is arm
    assert not caplog.records
    slow = arm.with_limits(velocity=0.1)
    assert mp.Plan.load(tmp_path / "result", robot=slow).robot is slow
    assert "the robot given has other limits (velocity) than the plan was made and checked for" in caplog.text
    with pytest.raises(mp.errors.FileFormatError, match="give the right"):
        mp.Plan.load(tmp_path / "result", robot=mp.planar_arm([1, 1]))


@given(seeds, st.lists(st.booleans(), min_size=2, max_size=6))
@examples(30)
def test_the_fingerprint_is_the_product_of_exponentials(seed, prismatic):
    """The tool's pose at any q comes from the screws alone, as Pinocchio has it."""
    arm = chain(seed, prismatic)
    [home], screws = fingerprint(arm)
    q = np.random.default_rng(seed).uniform(-3, 3, arm.n)
    pose = np.eye(4)
    for screw, each in zip(screws, q, strict=True):
        pose = pose @ pin.exp6(pin.Motion(screw * each)).homogeneous
    data = arm.model.createData()
    pin.framesForwardKinematics(arm.model, data, q)
    np.testing.assert_allclose(pose @ home, data.oMf[arm.model.getFrameId("tool")].homogeneous, atol=1e-9)


@pytest.mark.slow
def test_a_mesh_that_is_gone(planar, small_plan, tmp_path):
    mesh = tmp_path / "part.stl"
    corners = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]) * 0.1
    faces = [(0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3)]
    facets = "".join(
        "facet normal 0 0 0\nouter loop\n"
        + "".join(f"vertex {x} {y} {z}\n" for x, y, z in corners[list(f)])
        + "endloop\nendfacet\n"
        for f in faces
    )
    mesh.write_text(f"solid part\n{facets}endsolid part\n")
    scene = mp.Scene([mp.Mesh(file=mesh, position=(5.0, 5.0, 0.0), name="part")])
    plan = replace(small_plan, scene=scene)
    plan.save(tmp_path / "result")
    assert mp.Plan.load(tmp_path / "result").scene.distances(planar, [0, 0, 0]) == pytest.approx(
        scene.distances(planar, [0, 0, 0])
    )
    mesh.unlink()
    with pytest.raises(mp.errors.FileFormatError, match=r"part.stl.*put its files back, or give scene="):
        mp.Plan.load(tmp_path / "result")
    assert mp.Plan.load(tmp_path / "result", scene=mp.Scene()).scene.names == ()


@dataclass(frozen=True, kw_only=True)
class Doubled(mp.measures.Measure):
    """A measure of a user's own."""

    name = "doubled"
    formula = "2 sqrt(det(J Jᵀ))"
    source = "here"

    def unit(self, task):
        return task.unit

    def value(self, posture):
        return 2 * mp.measures.Yoshikawa().value(posture)


@pytest.mark.slow
def test_what_cannot_be_written_is_told_and_can_be_given(planar, small_plan, tmp_path, caplog):
    path = small_plan.path
    own = made_plan(planar, path, measure=Doubled())
    own.save(tmp_path / "own")
    assert "not written: measure, a measure of your own, Doubled" in caplog.text
    with pytest.raises(mp.errors.FileFormatError, match=r"a measure of your own, Doubled; give measure="):
        mp.Plan.load(tmp_path / "own")
    with pytest.raises(mp.errors.InvalidInputError, match="the measure of the plan, doubled"):
        mp.Plan.load(tmp_path / "own", measure=mp.measures.Yoshikawa())
    assert_same(own, mp.Plan.load(tmp_path / "own", measure=Doubled()))
    inside = made_plan(
        planar.with_limits(lower=-3.0, upper=3.0), path, measure=mp.measures.JointLimitPenalised(measure=Doubled())
    )
    inside.save(tmp_path / "inside")
    with pytest.raises(mp.errors.FileFormatError, match=r"Doubled; give measure="):
        mp.Plan.load(tmp_path / "inside")
    by_hand = replace(planar, source=None)
    replace(small_plan, robot=by_hand).save(tmp_path / "hand")
    assert "not written: robot, an arm that was put together by hand" in caplog.text
    with pytest.raises(mp.errors.FileFormatError, match=r"put together by hand; give robot="):
        mp.Plan.load(tmp_path / "hand")
    assert mp.Plan.load(tmp_path / "hand", robot=by_hand).robot is by_hand

    class Cone(mp.Sphere):
        """An obstacle of a user's own."""

    replace(small_plan, scene=mp.Scene([Cone(radius=0.1, position=(9, 9, 0), name="cone")])).save(tmp_path / "cone")
    with pytest.raises(mp.errors.FileFormatError, match=r"cone, a Cone.*give scene="):
        mp.Plan.load(tmp_path / "cone")


@pytest.mark.slow
@pytest.mark.parametrize(
    ("change", "message"),
    [
        (lambda text: text[: len(text) // 2], "it was truncated"),
        (lambda text: "", "it was truncated"),
        (lambda text: "[1, 2]", "an object with format 'manipplan-plan'"),
        (lambda text: json.dumps({"format": "manipplan-trajectory"}), "an object with format"),
        (
            lambda text: text.replace('"version": 3', '"version": 2'),
            rf"of version 3; this is version 2, written by manipplan '{re.escape(mp.__version__)}'",
        ),
        (lambda text: text.replace('"passed": false', '"passed": true'), "this one was changed since"),
        (lambda text: text.replace('"sha256"', '"sha"'), "this one was changed since"),
        (lambda text: "[" * 100_000, "it was truncated or is not a plan.json"),
    ],
)
def test_a_broken_file_is_told(small_plan, tmp_path, change, message):
    small_plan.save(tmp_path)
    file = tmp_path / "plan.json"
    changed = change(file.read_text())
    assert changed != file.read_text()
    file.write_text(changed)
    with pytest.raises(mp.errors.FileFormatError, match=message):
        mp.Plan.load(tmp_path)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("change", "message"),
    [
        (lambda text: text.replace('"path":', '"paths":'), r"written by Plan.save, unchanged since \(KeyError: 'path'\)"),
        (lambda text: text.replace('"passed": false', '"passed": "yes"'), "'yes' is not of type bool @ PlanReport.passed"),
        (
            lambda text: text.replace('"goal_error": ', '"goal_error": "nought", "x": '),
            "'nought' is not a number @ PlanReport.goal_error",
        ),
        (lambda text: text.replace('"power": 1.0', '"power": 1' + 400 * "0"), "int too large"),
        (lambda text: text.replace('"OPTIMAL"', '"PERFECT"'), "PERFECT"),
        (lambda text: text.replace('"breaks": [0.0', '"breaks": [0.5'), "breaks: got"),
        (lambda text: text.replace('"yoshikawa"', '"yoshi"'), "KeyError: 'yoshi'"),
        (lambda text: text.replace('"cylinder"', '"tube"'), r"scene can be built again .*tube"),
        (lambda text: text.replace('"planar", "name"', '"planet", "name"'), "kind of a robot's source: got 'planet'"),
    ],
)
def test_a_changed_file_with_its_checksum_is_told(small_plan, tmp_path, change, message):
    small_plan.save(tmp_path)
    file = tmp_path / "plan.json"
    changed = change(file.read_text())
    assert changed != file.read_text()
    data = json.loads(changed)
    del data["sha256"]
    file.write_text(json.dumps({**data, "sha256": checksum(data)}))
    with pytest.raises(mp.errors.FileFormatError, match=message):
        mp.Plan.load(tmp_path)


@pytest.mark.slow
@pytest.mark.parametrize("place", [("robot", "limits", "velocity", 0), ("trajectory", "q", 3, 1), ("report", "clearance")])
def test_no_number_can_be_changed_unnoticed(small_plan, tmp_path, place):
    small_plan.save(tmp_path)
    data = stored(tmp_path)
    inside = data
    for key in place[:-1]:
        inside = inside[key]
    inside[place[-1]] = np.nextafter(float(inside[place[-1]]), 1e3)
    (tmp_path / "plan.json").write_text(json.dumps(data))
    with pytest.raises(mp.errors.FileFormatError, match="changed since: save the plan again"):
        mp.Plan.load(tmp_path)


@pytest.mark.slow
def test_wrong_places_are_told(small_plan, tmp_path):
    with pytest.raises(mp.errors.FileFormatError, match="an existing file"):
        mp.Plan.load(tmp_path / "nowhere")
    with pytest.raises(mp.errors.FileFormatError, match=r"a folder written by Plan.save, with plan.json in it"):
        mp.Plan.load(tmp_path)
    with pytest.raises(mp.errors.InvalidInputError, match="the path of a file"):
        mp.Plan.load(7)
    small_plan.save(tmp_path)
    for wrong in ({"robot": "panda"}, {"scene": []}, {"measure": "yoshikawa"}):
        with pytest.raises(mp.errors.InvalidInputError, match=next(iter(wrong))):
            mp.Plan.load(tmp_path, **wrong)


@pytest.mark.slow
def test_the_catalogue_that_is_not_installed(demo_plan, tmp_path, monkeypatch):
    demo_plan.save(tmp_path)
    monkeypatch.setitem(sys.modules, "example_robot_data", None)
    with pytest.raises(mp.errors.MissingExtraError, match=r"manipplan\[robots\]"):
        mp.Plan.load(tmp_path)


@pytest.mark.slow
def test_no_path_of_this_machine_for_a_robot_of_the_catalogue(demo_plan, tmp_path):
    demo_plan.save(tmp_path)
    assert "/" not in json.dumps(stored(tmp_path)["robot"]["source"])


@pytest.mark.slow
def test_a_killed_save_leaves_the_old_file_whole(small_plan, tmp_path):
    """Killed again and again while it writes, at other times each: what is there can be read."""
    small_plan.save(tmp_path)
    script = (
        "import sys, manipplan as mp\n"
        "from manipplan.plans.archive import write_plan\n"
        "from pathlib import Path\n"
        "folder = Path(sys.argv[1]); plan = mp.Plan.load(folder)\n"
        "print('ready', flush=True)\n"
        "while True: write_plan(plan, folder / 'plan.json')\n"
    )
    for pause in (0.0, 0.003, 0.01):
        child = subprocess.Popen([sys.executable, "-c", script, str(tmp_path)], stdout=subprocess.PIPE, text=True)
        assert child.stdout.readline() == "ready\n"
        before = (tmp_path / "plan.json").stat().st_mtime_ns
        while (tmp_path / "plan.json").stat().st_mtime_ns == before:  # until it has been written once
            assert child.poll() is None
        time.sleep(pause)  # any moment of a later write
        os.kill(child.pid, signal.SIGKILL)
        child.wait()
        child.stdout.close()
        assert child.returncode == -signal.SIGKILL
        assert_same(small_plan, mp.Plan.load(tmp_path))


@pytest.mark.slow
def test_an_mjcf_with_a_floor_is_drawn_and_comes_back(tmp_path, caplog):
    """The floor belongs to the description, has no end, and no hull that could be drawn."""
    (tmp_path / "arm.xml").write_text("""<mujoco><worldbody><geom name="floor" type="plane" size="1 1 0.1" pos="0 0 -1"/>
      <body name="upper"><joint name="turn" axis="0 0 1"/><geom type="capsule" fromto="0 0 0 0.5 0 0" size="0.05"/>
      <body name="fore" pos="0.5 0 0"><joint name="lift" axis="0 1 0"/><geom type="box" size="0.2 0.05 0.05" pos="0.2 0 0"/>
      <body name="tip" pos="0.4 0 0"/></body></body></worldbody></mujoco>""")
    arm = mp.Robot.from_mjcf(tmp_path / "arm.xml", tool="tip", velocity=1.0)
    plan = made_plan(arm, mp.JointPath.line([0.1, 0.2], [0.5, 0.4]), task=mp.Task.direction((1.0, 0.0, 0.0)))
    assert "floor" in plan.report.nearest_pair
    around = mp.Avoidance(scene=mp.Scene([mp.Sphere(radius=0.1, position=(0.0, 0.8, 0.0))]))
    mp.Controller(arm, mp.formulations.LogDrive(), dt=0.01, task=plan.result.task, avoidance=around, compiled=False)
    assert "does not avoid floor; add a Plane to the scene" in caplog.text
    plan.save(tmp_path / "result")
    assert_same(plan, mp.Plan.load(tmp_path / "result"))
    lower = (tmp_path / "arm.xml").read_text().replace("0 0 -1", "0 0 -0.9")
    (tmp_path / "arm.xml").write_text(lower)
    with pytest.raises(mp.errors.FileFormatError, match="changed, or it is another robot"):
        mp.Plan.load(tmp_path / "result")
