"""A recorded motion followed again with a higher index."""

import numpy as np
import pinocchio as pin
import pytest

import manipplan as mp


@pytest.fixture(scope="module")
def recording(panda):
    """A motion that passes near the arm's stretched elbow."""
    waypoints = np.array(
        [[0.0, -0.3, 0.0, -2.2, 0.0, 2.0, 0.785], [0.3, 0.3, 0.1, -0.6, 0.1, 1.2, 0.9], [0.6, 0.4, 0.3, -1.5, 0.0, 1.9, 0.5]]
    )
    path = mp.JointPath.through(waypoints)
    t = np.linspace(0.0, 4.0, 201)
    u = t / 4.0
    s = 10 * u**3 - 15 * u**4 + 6 * u**5
    q = path(s)
    qd = path(s, 1) * ((30 * u**2 - 60 * u**3 + 30 * u**4) / 4.0)[:, None]
    return mp.Trajectory(t=t, q=q, qd=qd, joint_names=panda.joint_names)


def test_the_index_rises_and_the_last_pose_is_reached(panda, recording):
    plan = mp.improve(panda, recording, tolerance=mp.Tolerance(position=0.03, rotation=0.2))
    assert plan.tolerance == mp.Tolerance(position=0.03, rotation=0.2)
    assert plan.status is mp.Status.IMPROVED and plan.report.passed
    assert plan.report.min_manipulability > 1.1 * plan.report.seed_min_manipulability
    kinematics = panda.kinematics()
    wanted, got = kinematics.pose(recording.q[-1]), kinematics.pose(plan.trajectory.q[-1])
    np.testing.assert_allclose(got[:3, 3], wanted[:3, 3], atol=1e-4)
    assert np.linalg.norm(pin.log3(wanted[:3, :3].T @ got[:3, :3])) < 1e-3
    assert plan.tracking.deviation.max() < 0.03 * 1.02
    assert all(use.ratio <= 1 + 1e-9 for use in mp.limit_use(plan.trajectory, panda.limits).values())


@pytest.mark.slow
def test_a_demonstration_of_positions_alone_is_read(panda, recording, tmp_path):
    file = tmp_path / "demonstration.csv"
    rows = np.column_stack([recording.t + 7.0, recording.q])  # recorders do not start at zero
    names = ",".join(f"q_{name}" for name in panda.joint_names)
    file.write_text(f"time,{names}\n" + "\n".join(",".join(map(repr, map(float, row))) for row in rows))
    plan = mp.improve(panda, file)
    assert plan.status is mp.Status.IMPROVED
    assert len(plan.save(tmp_path / "out")) == 7


@pytest.mark.slow
def test_a_planned_path_is_timed_first(panda):
    path = mp.JointPath.line(panda.neutral, panda.neutral + np.array([0.5, 0.3, 0.0, 0.4, 0.0, 0.2, 0.0]))
    plan = mp.improve(panda, path, formulation=mp.formulations.Equality(5e5))
    assert plan.report.passed


def test_a_recording_that_is_too_fast_is_slowed_down(panda, recording):
    plan = mp.improve(panda, recording, duration=0.2)
    assert plan.trajectory.duration > 0.4 and plan.report.passed


@pytest.mark.slow
def test_a_motion_into_an_obstacle_fails_its_check(panda, recording):
    end = panda.kinematics().pose(recording.q[-1])[:3, 3]
    scene = mp.Scene([mp.Sphere(radius=0.1, position=end, name="ball")])
    plan = mp.improve(panda, recording, scene=scene, throw=False)
    assert plan.status in (mp.Status.NOT_FOLLOWED, mp.Status.CHECK_FAILED) and not plan.status.has_path
    with pytest.raises(mp.PlanningError) as caught:
        mp.improve(panda, recording, scene=scene)
    assert caught.value.result.status is plan.status


def test_wrong_recordings_are_refused(panda, recording):
    other = mp.load_robot("xarm7")
    with pytest.raises(mp.InvalidInputError, match="recorded"):
        mp.improve(other, recording)
    with pytest.raises(mp.FileFormatError, match="existing file"):
        mp.improve(panda, "nowhere.csv")
    with pytest.raises(mp.InvalidInputError, match="recorded"):
        mp.improve(panda, np.zeros((3, 7)))


def test_an_objective_of_another_type_is_refused(panda, recording):
    with pytest.raises(mp.InvalidInputError, match="objective: got 'yoshikawa'; allowed: a PathObjective"):
        mp.improve(panda, recording, objective="yoshikawa")
