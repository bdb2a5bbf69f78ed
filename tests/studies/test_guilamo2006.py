"""The figures of the study are those of expected.csv, and of its page."""

import csv
from pathlib import Path

import example_robot_data
import numpy as np
import pinocchio as pin
import pytest

import manipplan as mp
from studies.guilamo2006 import claims, config, courses, run, runs
from studies.report import study_text

FIGURES = {"circle.png", "line.png", "index.png", "search.png", "sampling.png", "joints.png"}


@pytest.mark.long  # the whole study runs the same stages
def test_the_quick_study_makes_what_is_expected(tmp_path):
    assert run.STUDY.main(["--quick", "--out", str(tmp_path)]) == []
    assert {file.name for file in tmp_path.glob("*.png")} == FIGURES


@pytest.mark.slow
def test_the_whole_study_makes_what_is_expected(tmp_path):
    assert run.STUDY.main(["--out", str(tmp_path)]) == []
    assert {file.name for file in tmp_path.iterdir()} == {
        file.name for file in config.PAGES.iterdir() if file.suffix in (".png", ".md", ".csv")
    }


def test_a_difference_is_told():
    found = [claims.Claim(text=text, paper="", value=value) for text, value, _ in claims.expected(quick=False)]
    assert claims.differences(found, quick=False) == []
    found[2] = claims.Claim(text=found[2].text, paper="", value=found[2].value + 1000)
    [line] = claims.differences(found, quick=False)
    assert found[2].text in line
    assert claims.differences(found[3:], quick=False)


def test_the_page_shows_what_is_expected():
    with (config.PAGES / "claims.csv").open(newline="") as file:
        rows = [claims.Claim(text=row["claim"], paper=row["paper"], value=float(row["ours"])) for row in csv.DictReader(file)]
    assert claims.differences(rows, quick=False) == []
    page = study_text(config.PAGES.with_suffix(".md"))
    assert {file.name for file in config.PAGES.glob("*.png")} == FIGURES
    for file in config.PAGES.iterdir():
        if file.suffix in (".png", ".md"):
            assert file.stat().st_size < 300_000
            assert f"guilamo2006/{file.name}" in page


def test_the_line_ends_where_reach_does():
    _, line = courses.courses()
    assert courses.furthest(line, config.SIDE, config.FULL) == config.LINE_END
    assert line.path.length == pytest.approx(config.LENGTH)
    _, second = courses.second_courses()
    assert courses.furthest(second, config.SECOND_SIDE, config.SECOND_SAMPLES) == config.SECOND_LINE_END
    assert second.path.length == pytest.approx(config.LENGTH * courses.second_scale(second.robot))


@pytest.mark.slow
def test_self_collisions_are_those_of_pinocchio_and_coal():
    """Candidates of the circle among TALOS' own meshes, with the pairs that its SRDF leaves, but for neighbours."""
    circle, _ = courses.courses()
    every, free = (
        np.concatenate(runs.Runs().sampled(circle, config.COARSE, collisions=each).layers.q) for each in (False, True)
    )
    kept = {each.tobytes() for each in np.round(free, 9)}
    talos = example_robot_data.load("talos")
    model, urdf = talos.model, Path(talos.urdf)
    bodies = pin.buildGeomFromUrdf(model, str(urdf), pin.GeometryType.COLLISION, package_dirs=[str(urdf.parents[4])])
    bodies.addAllCollisionPairs()
    pin.removeCollisionPairs(model, bodies, str(urdf.parents[1] / "srdf" / "talos.srdf"), False)
    joints = [[bodies.geometryObjects[k].parentJoint for k in (pair.first, pair.second)] for pair in bodies.collisionPairs]
    apart = [k for k, (a, b) in enumerate(joints) if a != b and model.parents[a] != b and model.parents[b] != a]
    moved = {model.getJointId(name) for name in circle.robot.joint_names}
    apart = [k for k in apart if any(set(model.supports[joint]) & moved for joint in joints[k])]
    q = talos.q0.copy()
    for name, value in circle.robot.locked.items():
        q[model.joints[model.getJointId(name)].idx_q] = value
    active = [model.joints[model.getJointId(name)].idx_q for name in circle.robot.joint_names]
    data, placed = model.createData(), pin.GeometryData(bodies)
    for candidate in np.random.default_rng(1).permutation(every)[:150]:
        q[active] = candidate
        pin.updateGeometryPlacements(model, data, bodies, placed, q)
        nearest = min(pin.computeDistance(bodies, placed, k).min_distance for k in apart)
        assert (nearest > 0) == (np.round(candidate, 9).tobytes() in kept)


def test_the_circle_is_that_of_the_paper():
    circle, _ = courses.courses()
    poses = circle.path.sample(50)
    centre = np.array(config.CENTRE)
    np.testing.assert_allclose(np.linalg.norm(poses[:, :3, 3] - centre, axis=1), config.DIAMETER / 2, atol=1e-12)
    np.testing.assert_allclose(poses[:, 0, 3], centre[0], atol=1e-12)
    np.testing.assert_allclose(poses[:, :3, :3], np.broadcast_to(poses[0, :3, :3], (50, 3, 3)), atol=1e-12)
    assert np.prod(config.FULL) == np.prod(config.UNEVEN) == config.CONSIDERED


def test_starts_that_are_needed_are_those_that_the_papers_search_takes():
    kept = runs.Runs()
    circle, _ = courses.courses()
    sampled = kept.sampled(circle, config.GRIDS[0])
    searched = kept.searched(sampled, 5.0, "first")
    restarted = kept.restarted(sampled, 5.0, memoised=True)
    assert restarted.ended
    assert restarted.found.new_starts == sampled.above(searched.found.minimum) + 1
    assert restarted.found.minimum == searched.found.minimum
    assert kept.sampled(circle, config.GRIDS[0]) is sampled
    kept.forget(sampled)
    assert not kept.kept


def test_perturbation_is_that_of_a_wave():
    places = np.linspace(0, 1, 40)
    index = 1 - places**2
    assert runs.perturbation(index) < 1e-12
    index[20] += 0.01
    assert runs.perturbation(index) == pytest.approx(0.01, rel=0.2)


def test_layers_without_collisions_hold_every_answer():
    circle, _ = courses.courses()
    sampled = runs.Runs().sampled(circle, (4, 3, 4))
    answers = mp.inverse_kinematics(circle.robot, circle.path(0.0), samples=(4, 3, 4))
    assert len(answers) == sampled.layers.sizes[0]


def test_the_circle_against_all_pairs():
    """The exact search on the study's coarse circle against a dynamic programme over all pairs of neighbouring layers."""
    robot = mp.load_robot("talos_torso_right_arm")
    start = np.array([[0.0, 0.0, -1.0, 0.45], [-1.0, 0.0, 0.0, -0.25], [0.0, 1.0, 0.0, 0.25], [0.0, 0.0, 0.0, 1.0]])
    circle = mp.CartesianPath.circle(start, start[:3, 3] - [0.0, 0.0, 0.1], (1.0, 0.0, 0.0))
    layers = mp.sample_layers(robot, circle, 50, samples=(28, 18, 28), collisions=False)
    for degrees in (3.0, 5.0):
        epsilon = np.deg2rad(degrees)
        value = layers.m[0]
        for q, following, m in zip(layers.q, layers.q[1:], layers.m[1:], strict=False):
            near = np.ones((len(following), len(q)), dtype=bool)
            for joint in range(layers.n):
                near &= np.abs(following[:, joint, None] - q[None, :, joint]) < epsilon
            value = np.minimum(m, np.where(near, value, -np.inf).max(axis=1))
        assert mp.max_min_search(layers, epsilon).minimum == value.max() > 0
