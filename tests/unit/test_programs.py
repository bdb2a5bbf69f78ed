"""Programs of moves: choice, parts, blends, stops, speeds, bad input."""

import re
import time
from dataclasses import replace
from itertools import pairwise

import numpy as np
import pinocchio as pin
import pytest
from program_cell import DOWN, pose_at

import manipplan as mp
from manipplan.paths.joint import cut
from manipplan.paths.tolerance import BETWEEN
from manipplan.programs.assemble import assemble
from manipplan.programs.blend import is_corner
from manipplan.programs.leg_motions import RawMotion
from manipplan.programs.legs import State, read_steps
from manipplan.timing.constant_speed import check_corners, most_acceleration
from manipplan.tool_path.engine import outside_limits
from manipplan.tool_path.transit import STRAIGHT_EPSILON, straight_on, straight_planner


@pytest.mark.slow
def test_a_part_is_picked_carried_and_placed(hand, cell, program):
    assert program.passed
    assert [mark.name for mark in program.marks] == [
        "MoveTo", "Attach", "MoveAlong", "MoveTo", "Detach", "MoveAlong", "Wait", "MoveTo",
    ]  # fmt: skip
    assert [list(part.robot.carried) for part in program.parts] == [[], ["part"], [], []]
    assert ["part" in part.scene.names for part in program.parts] == [True, False, True, True]
    for part in program.parts:
        report = mp.check(part.robot, part.trajectory, part.scene)
        assert report.passed, report.faults
    _, scene, q = program.final_state
    np.testing.assert_allclose(q, hand.neutral, atol=1e-9)
    placed = scene.obstacles[scene.names.index("part")]
    np.testing.assert_allclose(placed.pose.translation, [0.45, -0.3, 0.051], atol=1e-4)


@pytest.mark.slow
def test_one_trajectory_with_marks(program):
    assert program.trajectory.duration == pytest.approx(sum(p.trajectory.duration for p in program.parts) + 0.5)
    for part, begin in zip(program.parts, program.begins, strict=True):
        np.testing.assert_allclose(
            program.trajectory(begin + part.trajectory.duration / 3), part.trajectory(part.trajectory.duration / 3), atol=1e-9
        )
    waiting = next(mark.begin for mark in program.marks if mark.name == "Wait")
    assert np.abs(program.trajectory(waiting + 0.25, order=1)).max() == 0.0
    assert [mark.begin for mark in program.marks] == sorted(mark.begin for mark in program.marks)


@pytest.mark.slow
def test_approach_and_retreat_are_straight(hand, program):
    """The tool stays on the vertical line over the part while it approaches, but for the blend at its upper end."""
    kinematics = hand.kinematics()
    last = kinematics.pose(program.parts[0].trajectory(np.linspace(0, program.parts[0].trajectory.duration, 4000)))
    near = last[last[:, 2, 3] < 0.09 + 0.04]
    assert np.abs(near[:, :2, 3] - [0.45, 0.3]).max() < 2e-4
    first = kinematics.pose(program.parts[2].trajectory(np.linspace(0, program.parts[2].trajectory.duration, 2000)))
    low = first[first[:, 2, 3] < 0.09 + 0.04]
    assert len(low) > 10
    assert np.abs(low[:, :2, 3] - [0.45, -0.3]).max() < 2e-4


@pytest.mark.slow
def test_blends_leave_out_stops_and_stay_near_corners(hand, cell, steps, program):
    sharp = mp.sequence(hand, "default", steps, cell)
    assert not program.stops
    assert len(sharp.stops) == 3
    assert program.duration < sharp.duration
    for stop in sharp.stops:
        assert np.abs(sharp.trajectory(stop, order=1)).max() < 1e-3
        corner = hand.kinematics().pose(sharp.trajectory(stop))[:3, 3]
        t = np.linspace(0, program.duration, 20_000)
        way = hand.kinematics().pose(program.trajectory(t))[:, :3, 3]
        assert np.linalg.norm(way - corner, axis=1).min() <= 0.05
    moving = np.abs(program.trajectory(np.linspace(0.05, program.parts[0].trajectory.duration - 0.05, 500), order=1)).max(
        axis=1
    )
    assert moving.min() > 0.01


@pytest.mark.slow
def test_the_choice_is_that_of_all_choices(planar):
    """Of a planar arm with two grasps at each of two places: the program with the largest minimum of all four that are possible."""
    start = np.array([0.4, 0.6, 0.8])
    kinematics = planar.kinematics()
    goals = [[np.array([0.9, 0.9, 0.9]), np.array([1.0, -0.3, 0.25])], [np.array([1.4, 1.2, -0.5]), np.array([1.2, -0.4, 2.0])]]
    whole = mp.sequence(planar, start, [mp.MoveTo(each) for each in goals])
    least = []
    for one in goals[0]:
        for other in goals[1]:
            first = mp.plan(planar, start, one, mp.Scene())
            second = mp.plan(planar, one, other, mp.Scene())
            least.append(min(first.report.min_manipulability, second.report.min_manipulability))
    assert whole.min_manipulability >= max(least) * 0.99
    assert set(whole.goals) == {0, 1}
    assert kinematics.manipulability(whole.trajectory.q[-1]) == pytest.approx(
        kinematics.manipulability(goals[1][whole.goals[1]])
    )


def seam_steps(speed):
    seam = mp.CartesianPath.line(pose_at(0.4, -0.2, 0.3), pose_at(0.4, 0.2, 0.3))
    return [mp.MoveAlong(seam, tool_speed=speed), mp.MoveAlong([0, 0, -0.1], tool_speed=0.05), mp.MoveTo("default")]


@pytest.mark.slow
@pytest.mark.parametrize("blend", [0.0, 0.02])
def test_the_tool_speed_is_constant(hand, blend, tmp_path):
    made = mp.sequence(hand, "default", seam_steps(0.1), blend=blend)
    assert made.passed
    assert len(made.stops) == (3 if blend == 0 else 0)
    assert made.marks[2].tool_speed is None
    for mark, asked in zip(made.marks[:2], (0.1, 0.05), strict=True):
        told = mark.tool_speed
        assert told.asked == asked
        assert max(told.ramps) < 0.1 * told.length
        t = np.linspace(told.begin, told.end, 4000)  # measured again, by finite differences
        way = hand.kinematics().pose(made.trajectory(t))[:, :3, 3]
        speed = np.linalg.norm(np.diff(way, axis=0), axis=1) / np.diff(t)
        assert 0.99 * asked * (1 - 1e-4) <= speed.min() <= speed.max() <= asked * (1 + 1e-4)
        assert told.length > (0.39 if asked == 0.1 else 0.09) - 2 * blend
    assert f"tool speed   {made.marks[0].tool_speed}" in str(made)
    made.save(tmp_path / "made")
    assert mp.Program.load(tmp_path / "made").marks[:2] == made.marks[:2]


@pytest.mark.slow
def test_a_tool_speed_that_is_not_possible_is_refused_with_the_fastest(hand):
    steps = seam_steps(3.0)
    with pytest.raises(
        mp.errors.InvalidInputError, match=r"steps\[0\]\.tool_speed: got 3\.0; allowed: at most [\d.]+ m/s"
    ) as caught:
        mp.sequence(hand, "default", steps)
    fastest = float(caught.value.allowed.split()[2])
    made = mp.sequence(hand, "default", seam_steps(fastest))
    assert made.marks[0].tool_speed.is_steady
    with pytest.raises(mp.errors.InvalidInputError, match=r"steps\[0\]\.tool_speed"):
        mp.sequence(hand, "default", seam_steps(1.1 * fastest))


@pytest.mark.slow
def test_constraints_of_a_move(hand):
    level = mp.TiltLimit((0, 0, 1), (0, 0, -1), 0.1)
    steps = [mp.MoveTo(pose_at(0.2, 0.45, 0.35), constraints=[level]), mp.MoveTo(pose_at(0.4, -0.3, 0.4))]
    made = mp.sequence(hand, "default", steps, blend=0.05)
    end = made.marks[1].begin / made.duration
    path = cut(made.trajectory.path(), 0.0, end)
    axes = hand.kinematics().pose(path(np.linspace(0, 1, 3000)))[:, :3, 2]
    assert np.arccos(np.clip(-axes[:, 2], -1, 1)).max() <= 0.1 + 1e-6


def test_torque_limits_hold_in_a_program(panda):
    goal = panda.neutral + [0.4, 0.3, 0.0, 0.2, 0.0, 0.0, 0.0]
    program = mp.sequence(panda, panda.neutral, [mp.MoveTo(goal)], torque=True)
    model, data = panda.model, panda.model.createData()
    t = np.linspace(0.0, program.trajectory.duration, 500)
    motion = zip(*(program.trajectory(t, order) for order in (0, 1, 2)), strict=True)
    torques = np.array([pin.rnea(model, data, *each).copy() for each in motion])
    assert (np.abs(torques) <= panda.limits.effort * (1 + 1e-6)).all()
    weak = panda.with_limits(effort=5.0)
    assert mp.sequence(weak, weak.neutral, [mp.MoveTo(goal)]).passed
    with pytest.raises(mp.errors.PlanningError, match="no program was found: .*gravity alone loads panda_joint4 with"):
        mp.sequence(weak, weak.neutral, [mp.MoveTo(goal)], torque=True)


def test_cutting_a_path():
    rng = np.random.default_rng(0)
    path = mp.JointPath.spline([0.0, 0.3, 0.7, 1.0], rng.normal(size=(4, 7)))
    for begin, end in ((0.1, 0.2), (0.1, 0.5), (0.35, 0.95), (0.0, 0.7), (0.3, 1.0), (0.0, 1.0)):
        part = cut(path, begin, end)
        s = np.linspace(0.001, 0.999, 50)
        np.testing.assert_allclose(part(s), path(begin + s * (end - begin)), atol=1e-12)


def test_corners():
    line = mp.JointPath.line([0, 0], [1, 0])
    assert is_corner(line, mp.JointPath.line([1, 0], [1, 1]))
    assert not is_corner(line, mp.JointPath.line([1, 0], [3, 0]))


@pytest.mark.slow
def test_a_part_let_go_in_the_air_is_told(hand, cell, steps):
    high = [*steps[:3], mp.MoveTo(pose_at(0.45, -0.3, 0.3)), mp.Detach("part"), mp.MoveTo("default")]
    scene = mp.Scene(cell.obstacles)  # nothing may touch: the part keeps its distance to the table
    lifted = mp.Box(size=(0.04, 0.04, 0.1), position=(0.45, 0.3, 0.053), name="part")
    scene = scene.without("part") + mp.Scene([lifted])
    made = mp.sequence(hand, "default", high, scene)
    assert any("let go in the air" in each for each in made.warnings)


def test_constraints_are_in_the_report(hand):
    level = mp.TiltLimit((0, 0, 1), (0, 0, -1), 0.1)
    made = mp.sequence(hand, "default", [mp.MoveTo(pose_at(0.2, 0.45, 0.35), constraints=[level])])
    (figure,) = made.parts[0].report.constraints
    assert figure.proven
    assert figure.name.startswith("steps[0], tilt of tool axis")
    assert "constraint   steps[0]" in str(made)


def test_a_motion_there_and_back_stops_between(hand):
    """A blend cannot round a turn back; a goal where the arm is already is no motion."""
    near = hand.neutral + 0.2
    made = mp.sequence(hand, "default", [mp.MoveTo(near), mp.MoveTo(near), mp.MoveTo("default")], blend=0.05)
    assert made.passed
    assert len(made.stops) == 1


@pytest.mark.slow
def test_marks_tell_when_a_path_begins(hand):
    path = mp.CartesianPath.line(pose_at(0.4, -0.2, 0.3), pose_at(0.4, 0.2, 0.3))
    made = mp.sequence(hand, "default", [mp.MoveAlong(path)])
    (mark,) = made.marks
    assert mark.begin == 0.0
    assert 0 < mark.path_begin < made.duration
    np.testing.assert_allclose(hand.kinematics().pose(made.trajectory(mark.path_begin)), path(0.0), atol=2e-4)


@pytest.mark.slow
def test_parts_far_from_a_hand_are_told(hand, cell):
    steps = [mp.MoveTo(pose_at(0.45, 0.3, 0.3)), mp.Attach("part"), mp.MoveTo("default")]
    made = mp.sequence(hand, "default", steps, cell)
    assert any("steps[1]: part is taken up" in each for each in made.warnings)
    ball = mp.Sphere(radius=0.02, position=(0, 0, 0.04), name="ball")
    let_go = [mp.MoveTo(hand.neutral + 0.1), mp.Attach(ball), mp.Detach("ball"), mp.MoveTo("default")]
    assert any("steps[2]: ball is let go in the air" in each for each in mp.sequence(hand, "default", let_go).warnings)


BAD = {
    "no motion": ([mp.MoveTo("default")], r"steps: got \['MoveTo'\]; allowed: steps with at least one motion"),
    "no motion but a part": ([mp.Attach("part"), mp.Wait(1)], "steps with at least one motion"),
    "no steps": ([], "steps: got"),
    "no step": ([3], r"steps\[0\]: got 3"),
    "unknown part": ([mp.Attach("prt")], r"steps\[0\]\.part: got 'prt'; allowed: did you mean part"),
    "nothing to put down": ([mp.Detach("part")], r"steps\[0\]\.name: got 'part'"),
    "taken twice": ([mp.Attach("part"), mp.Attach("part")], r"steps\[1\]\.part"),
    "out of reach": (
        [mp.MoveTo("default"), mp.MoveTo(pose_at(2.0, 0.0, 0.3))],
        r"steps\[1\]\.goal: .*out of reach: the nearest configuration found leaves the tool",
    ),
    "no part": (
        [mp.MoveTo(mp.PoseGoal(DOWN, of="part"))],
        r"steps\[0\]\.goal\.of: got 'part'; allowed: none: the arm carries nothing then",
    ),
    "part put down": (
        [mp.Attach("part"), mp.Detach("part"), mp.MoveTo(["default", mp.PoseGoal(DOWN, of="part")])],
        r"steps\[2\]\.goal\[1\]\.of: got 'part'",
    ),
    "another part": (
        [mp.Attach("part"), mp.MoveTo(mp.PoseGoal(DOWN, of="prat"))],
        r"steps\[1\]\.goal\.of: got 'prat'; allowed: did you mean part",
    ),
    "turn in the hand not known": (
        [
            mp.MoveAlong(
                mp.CartesianPath.line(pose_at(0.45, 0.3, 0.3), pose_at(0.45, 0.3, 0.2)), task=mp.Task.pointing([0, 0, 1])
            ),
            mp.MoveAlong([0, 0, 0.1]),
            mp.Attach("part"),
            mp.MoveTo(mp.PoseGoal(DOWN, of="part")),
        ],
        r"steps\[3\]\.goal\.of: got 'part'; allowed: a part that was taken up and put down after a MoveTo",
    ),
    "unknown state": ([mp.MoveTo("redy")], r"steps\[0\]\.goal: got 'redy'"),
    "approach to a configuration": ([mp.MoveTo("default", approach=0.1)], "a pose of the tool, since there is an approach"),
    "turns in place": (
        [
            mp.MoveTo("default"),
            mp.MoveAlong(mp.CartesianPath.line(pose_at(0.4, 0.3, 0.4), pose_at(0.4, 0.3, 0.4, 1)), tool_speed=0.1),
        ],
        r"steps\[1\]\.tool_speed: got 0.1; allowed: a path that moves the tool all along: at s = .*, it turns the tool in place",
    ),
    "path out of reach": (
        [mp.MoveAlong(mp.CartesianPath.line(pose_at(0.5, 0.3, 0.4), pose_at(1.5, 0.3, 0.4)))],
        r"steps\[0\]\.path, position \d+ of 0 to \d+ \(s = [\d.]+\): .* the arm stays [\d.]+ mm and [\d.]+° away",
    ),
}


@pytest.mark.slow
@pytest.mark.parametrize("name", BAD)
def test_bad_programs(hand, cell, name):
    given, message = BAD[name]
    with pytest.raises(mp.errors.InvalidInputError, match=message):
        mp.sequence(hand, "default", given, cell)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("steps", "message"),
    [
        (
            [mp.MoveTo(pose_at(0.5, 0.3, 0.4)), mp.MoveAlong([0.6, 0, 0])],
            r"steps\[1\]: path, position \d+ of 0 to 39 .* is not a pose within reach and joint limits; the arm stays [\d.]+ mm",
        ),
        (
            [mp.MoveTo(pose_at(0.5, 0.3, 0.4), approach=[1.2, 0, 0])],
            r"steps\[0\]: no straight approach: path, position .* the arm stays [\d.]+ mm",
        ),
        (
            [mp.MoveTo(pose_at(0.5, 0.3, 0.2)), mp.MoveAlong([0, 0, 0.3])],
            r"steps\[1\]: path, position .* in the best of them panda_(left|right)finger_\d and table overlap by [\d.]+ mm",
        ),
    ],
)
def test_ways_that_do_not_exist_are_told(hand, cell, steps, message):
    with pytest.raises(mp.errors.PlanningError, match=message):
        mp.sequence(hand, "default", steps, cell)


@pytest.mark.slow
def test_blends_never_overlap(hand, cell, steps):
    made = mp.sequence(hand, "default", steps, cell, blend=2.0)
    assert made.passed
    placed = hand.kinematics().pose(made.parts[1].trajectory.q[-1])
    np.testing.assert_allclose(placed[:3, 3], [0.45, -0.3, 0.09], atol=1e-5)


@pytest.mark.slow
def test_blends_keep_the_clearance():
    """A ball inside the corner: the wide blend would touch it, and is halved."""
    hand = mp.load_robot("panda")  # its hand is closed
    corner = [pose_at(0.55, -0.2, 0.4), pose_at(0.55, 0.25, 0.4), pose_at(0.2, 0.25, 0.4)]
    steps = [mp.MoveAlong(mp.CartesianPath.line(one, other)) for one, other in pairwise(corner)]
    free = mp.sequence(hand, "default", steps, blend=0.15)
    cut_off = hand.kinematics().pose(free.trajectory(np.linspace(0, free.duration, 8000)))[:, :3, 3]
    away = np.linalg.norm(cut_off - corner[1][:3, 3], axis=1)
    ball = mp.Sphere(radius=0.005, position=cut_off[away.argmin()] + [0, 0, -0.006], name="ball")
    made = mp.sequence(hand, "default", steps, mp.Scene([ball]), blend=0.15, clearance=0.005)
    assert made.passed and made.parts[0].report.proven_clearance >= 0.005
    way = hand.kinematics().pose(made.trajectory(np.linspace(0, made.duration, 8000)))[:, :3, 3]
    assert np.linalg.norm(way - corner[1][:3, 3], axis=1).min() < 0.5 * away.min()


@pytest.mark.slow
@pytest.mark.parametrize(
    ("picked", "placed", "message"),
    [
        (0.049, 0.1, r"steps\[1\]: part and table overlap by 1 mm; scene.allow"),
        (0.05, 0.1, r"steps\[1\]: part and table touch; scene.allow"),  # rounding would decide
        (0.051, 0.089, r"steps\[3\]: part and table touch"),
    ],
)
def test_a_part_that_touches_is_told(hand, cell, picked, placed, message):
    scene = cell.without("part") + mp.Scene([mp.Box(size=(0.04, 0.04, 0.1), position=(0.45, 0.3, picked), name="part")])
    steps = [mp.MoveTo(pose_at(0.45, 0.3, 0.09), approach=0.1), mp.Attach("part")]
    steps += [mp.MoveTo(pose_at(0.45, -0.3, placed), approach=0.1), mp.Detach("part"), mp.MoveTo("default")]
    with pytest.raises(mp.errors.PlanningError, match=message):
        mp.sequence(hand, "default", steps, scene, seeding=mp.Seeding(time_limit=2.0))


@pytest.mark.parametrize("step", [mp.MoveTo(pose_at(0.45, 0.3, 0.3)), mp.MoveTo("default"), "along"])
def test_a_motion_that_does_not_do_its_step_fails_the_check(hand, step):
    state, start = State(robot=hand, scene=mp.Scene()), hand.neutral
    motion = RawMotion(step=0, path=mp.JointPath.line(start, start + 0.1), state=state)
    if step == "along":
        begin, end = hand.kinematics().pose(np.array([start, start + 0.1]))
        begin[2, 3] += 0.01
        step = mp.MoveAlong(mp.CartesianPath.line(begin, end))
        motion = replace(motion, workspace_path=step.path, task=mp.Task.pose(), tolerance=BETWEEN)
    legs = {leg.number: leg for leg in read_steps([step], hand, start)}
    made = assemble(
        [motion],
        state,
        state,
        [step],
        legs,
        goals={k: 0 for k, leg in legs.items() if leg.targets},
        blend=0.0,
        objective=mp.PathObjective(),
        clearance=0.0,
        torque=False,
    )
    assert not made.passed
    (fault,) = made.parts[0].report.faults
    assert fault.startswith("steps[0]: ")


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (lambda: mp.Wait(0), "seconds"),
        (lambda: mp.Wait("long"), "seconds"),
        (lambda: mp.Attach(3), "the name of an obstacle, or a shape"),
        (lambda: mp.MoveAlong([0, 0, 0]), "a way that is not zero"),
        (lambda: mp.MoveAlong("poses.csv"), "path"),
        (lambda: mp.MoveAlong([0, 0, 0.1], tool_speed=-1), "tool_speed"),
        (lambda: mp.MoveTo("default", approach=-0.1), "approach"),
        (lambda: mp.MoveTo("default", constraints=mp.HeldJoints("a")), "constraints"),
    ],
)
def test_bad_steps(make, message):
    with pytest.raises(mp.errors.InvalidInputError, match=message):
        make()


def poses_around_a_corner(apart):
    """Poses every few millimetres, with a turn by 90° without a radius."""
    count = round(0.2 / apart)
    there = [pose_at(0.4, -0.1 + apart * k, 0.3) for k in range(count + 1)]
    return there + [pose_at(0.4 + apart * k, 0.1, 0.3) for k in range(1, count // 2 + 1)]


@pytest.mark.slow
@pytest.mark.parametrize("blend", [0.0, 0.02])
def test_the_fastest_speed_around_a_sharp_corner(hand, blend):
    """It is found soon, also where the corner is a short piece of a long motion."""
    path = mp.CartesianPath.through(poses_around_a_corner(0.005))

    def weld(speed):
        return mp.sequence(hand, "default", [mp.MoveAlong(path, tool_speed=speed), mp.MoveTo("default")], blend=blend)

    began = time.process_time()
    with pytest.raises(
        mp.errors.InvalidInputError, match=r"steps\[0\]\.tool_speed: got 0\.3; allowed: at most [\d.]+ m/s"
    ) as caught:
        weld(0.3)
    assert time.process_time() - began < 20  # 80 s before
    fastest = float(caught.value.allowed.split()[2])
    assert 0.03 < fastest < 0.2
    assert weld(fastest).marks[0].tool_speed.is_steady


@pytest.mark.slow
def test_each_given_pose_of_a_path_is_met(hand):
    """A wave of 6 mm, of which 20 positions would see little."""
    poses = [pose_at(0.4 + 0.003 * (-1) ** k, -0.2 + 0.01 * k, 0.3) for k in range(41)]
    made = mp.sequence(hand, "default", [mp.MoveAlong(mp.CartesianPath.through(poses)), mp.MoveTo("default")])
    way = hand.kinematics().pose(made.trajectory(np.linspace(made.marks[0].path_begin, made.marks[1].begin, 40_000)))
    for pose in poses:
        assert np.linalg.norm(way[:, :3, 3] - pose[:3, 3], axis=1).min() < 1.2e-4


def test_a_corner_that_no_motion_takes_is_refused_before_work_starts(hand, monkeypatch):
    poses = poses_around_a_corner(0.001)
    path = mp.CartesianPath.through(poses)
    monkeypatch.setattr("manipplan.jobs.sequence.nodes_of", None)  # where work starts
    with pytest.raises(
        mp.errors.InvalidInputError, match=r"steps\[1\]\.tool_speed: got 0\.6; .* at s = 0\.66\d, x y z = .*, the path turns"
    ) as caught:
        mp.sequence(hand, "default", [mp.Wait(0.1), mp.MoveAlong(path, tool_speed=0.6)])
    assert "split the path there" in caught.value.allowed


def test_the_bound_on_corners_is_none_of_motions(hand):
    """The tool's acceleration on random motions at the limits is below the bound, and a gentle path is not refused."""
    rng, model = np.random.default_rng(0), hand.model
    data, bound, largest = model.createData(), most_acceleration(hand), 0.0
    frame = model.getFrameId(hand.tool)
    for _ in range(2000):
        q, signs = hand.random_configuration(rng), rng.choice([-1.0, 1.0], (2, hand.n))
        pin.forwardKinematics(model, data, q, signs[0] * hand.limits.velocity, signs[1] * hand.limits.acceleration)
        moved = pin.getFrameClassicalAcceleration(model, data, frame, pin.ReferenceFrame.LOCAL_WORLD_ALIGNED).linear
        largest = max(largest, float(np.linalg.norm(moved)))
    assert 0.2 * bound < largest < bound
    arc = mp.CartesianPath.circle(pose_at(0.5, 0.0, 0.3), (0.45, 0.0, 0.3), (0, 0, 1))
    check_corners(np.sqrt(0.9 * bound * 0.05), arc, hand, position=1e-4)
    with pytest.raises(mp.errors.InvalidInputError, match="turns a corner"):
        check_corners(np.sqrt(1.2 * bound * 0.05), arc, hand, position=1e-4)


def test_a_straight_way_stays_inside_the_limits(hand):
    """Its configurations are inside at the positions that are searched; between them their spline may bow outwards."""
    q, way = hand.neutral, np.array([0.0, 0.0, -0.1])
    path = straight_on(hand.kinematics().pose(q), way)
    finder = straight_planner(hand, mp.Scene(), path, measure=None, clearance=0.0)
    made = finder.best_from(q, STRAIGHT_EPSILON)
    assert isinstance(made, mp.JointPath)
    narrow = hand.with_limits(upper=np.maximum(made.start, made.goal) - 1e-3)
    assert re.fullmatch(r"panda_joint\d is 0\.001\d* outside its limits", outside_limits(made, narrow))
    blocked = mp.Scene([mp.Box(size=(0.5, 0.5, 0.02), position=path(1.0)[:3, 3] + [0, 0, 0.15], name="lid")])
    with pytest.raises(mp.errors.InvalidInputError, match="lid"):
        straight_planner(hand, blocked, path, measure=None, clearance=0.0)


@pytest.mark.slow
def test_a_configuration_is_reached_as_it_was_given(ur5):
    """A pose may be reached at any full turn of the joints; a configuration may not."""
    start, goal = np.array([0.0, -1.5, 1.5, -1.5, 4.6, 6.0]), np.array([0.2, -1.4, 1.4, -1.5, -1.6, 0.0])
    program = mp.sequence(ur5, start, [mp.MoveTo(goal), mp.MoveTo(ur5.kinematics().pose(start))])
    ends = [program.trajectory(mark.begin) for mark in program.marks[1:]]
    np.testing.assert_allclose(ends[0], goal, atol=1e-5)
    assert np.abs(program.trajectory.q[-1] - goal).max() < np.pi


@pytest.mark.slow
def test_paths_whose_orientation_is_free_follow_each_other(panda):
    """The second path begins in the configuration in which the first one ended, which is no sample of it."""
    points = [[0.4, 0.2, 0.3], [0.4, 0.3, 0.3], [0.5, 0.3, 0.35]]
    poses = np.tile(np.diag([1.0, -1.0, -1.0, 1.0]), (3, 1, 1))
    poses[:, :3, 3] = points
    lines = [mp.CartesianPath.line(*poses[k : k + 2]) for k in (0, 1)]
    program = mp.sequence(panda, "default", [mp.MoveAlong(line, task=mp.Task.position()) for line in lines])
    assert program.passed
    times = [program.marks[0].path_begin, program.marks[1].begin, program.duration]
    reached = panda.kinematics().pose(program.trajectory(np.array(times)))[:, :3, 3]
    np.testing.assert_allclose(reached, points, atol=2e-4)


# ---- the time limit


def test_a_program_that_is_not_found_in_time_is_refused_with_the_step(hand, cell, steps):
    with pytest.raises(
        mp.errors.PlanningError, match="no program was proven within time_limit = 0.01 s; the last step was"
    ) as caught:
        mp.sequence(hand, "default", steps, cell, time_limit=0.01)
    assert caught.value.result.status is mp.Status.NOT_IN_TIME


@pytest.mark.slow
def test_a_time_limit_that_is_not_reached_changes_no_program(hand, cell, steps, program):
    again = mp.sequence(hand, "default", steps, cell, blend=0.05, time_limit=600.0)
    np.testing.assert_array_equal(again.trajectory.q, program.trajectory.q)


@pytest.mark.parametrize("limit", [0.0, -1.0, np.inf, np.nan, "1"])
def test_a_time_limit_of_a_program_that_is_none_is_refused(hand, limit):
    with pytest.raises(mp.errors.InvalidInputError, match="^time_limit: got"):
        mp.sequence(hand, "default", [mp.MoveTo("default")], time_limit=limit)


def turned_line(robot, start):
    """A path in place from the tool at a start (n,), which turns the tool by 1 rad about its axis."""
    begin = robot.kinematics().pose(start)
    turn = np.eye(4)
    turn[:2, :2] = [[np.cos(1), -np.sin(1)], [np.sin(1), np.cos(1)]]
    return mp.CartesianPath.line(begin, begin @ turn)


@pytest.mark.parametrize("before", [[], [mp.Wait(0.1)]])
def test_where_no_motion_leads_on_from_the_start_the_path_begins_in_another_configuration(before):
    robot = mp.load_robot("ur5_limited")
    start = np.array([0.3, -1.2, 1.4, -1.7, -1.5, robot.limits.upper[5]])
    program = mp.sequence(robot, start, [*before, mp.MoveAlong(turned_line(robot, start))])
    mark = program.marks[-1]
    q = program.trajectory(np.array([0.0, mark.path_begin, program.trajectory.duration]))
    assert program.passed and mark.path_begin > 1.0
    np.testing.assert_array_equal(q[0], start)
    assert start[5] - q[1, 5] > 1.0  # the joint that stood at its limit
    expected = turned_line(robot, start)
    np.testing.assert_allclose(robot.kinematics().pose(q[1:]), [expected(0.0), expected(1.0)], atol=1e-4)


def test_a_start_from_which_a_motion_leads_on_is_kept():
    robot = mp.load_robot("ur5_limited")
    start = np.array([0.3, -1.2, 1.4, -1.7, -1.5, robot.limits.upper[5] - 2.0])
    program = mp.sequence(robot, start, [mp.MoveAlong(turned_line(robot, start))])
    assert program.passed and len(program.parts) == 1 and program.marks[0].path_begin == 0.0
