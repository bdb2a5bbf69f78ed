"""The nearest configuration of a refusal: no descent of the error from random starts ends nearer."""

import numpy as np
import pinocchio as pin
import pytest
from chains import chain, random_rotation, seeds
from examples import examples
from hypothesis import given
from hypothesis import strategies as st

import manipplan as mp
from manipplan.ik.newton import nearest_to
from manipplan.symbolic.free_motion import NOTHING

STARTS, STEPS = 150, 80


@pytest.fixture(scope="module", autouse=True)
def no_compiler():
    """Every example is another arm: machine code of its forward kinematics would take a second each."""
    with pytest.MonkeyPatch.context() as patch:
        for module in ("support.compiler", "symbolic.machine_code"):
            patch.setattr(f"manipplan.{module}.find_compiler", lambda language="c": None)
        yield


def own_error(robot, data, q, pose):
    """Displacement [m] and rotation vector [rad] to a pose, and the Jacobian, by Pinocchio."""
    frame = robot.model.getFrameId("tool")
    jacobian = pin.computeFrameJacobian(robot.model, data, q, frame, pin.LOCAL_WORLD_ALIGNED)
    pin.updateFramePlacement(robot.model, data, frame)
    own = data.oMf[frame]
    return np.concatenate([pose[:3, 3] - own.translation, pin.log3(pose[:3, :3] @ own.rotation.T)]), jacobian


def by_descents(robot, pose, rng):
    """The smallest norm of the error that damped least squares inside the limits reach from random starts."""
    data, lower, upper, best = robot.model.createData(), robot.limits.lower, robot.limits.upper, np.inf
    for start in rng.uniform(lower, upper, (STARTS, robot.n)):
        q, damping = start, 1e-2
        error, jacobian = own_error(robot, data, q, pose)
        for _ in range(STEPS):
            slope = jacobian.T @ error
            moves = ~(((q <= lower) & (slope < 0)) | ((q >= upper) & (slope > 0)))
            part, step = jacobian[:, moves], np.zeros(robot.n)
            step[moves] = part.T @ np.linalg.solve(part @ part.T + damping * np.eye(6), error)
            moved = np.clip(q + np.clip(step, -0.5, 0.5), lower, upper)
            left, slopes = own_error(robot, data, moved, pose)
            if left @ left < error @ error:
                q, error, jacobian, damping = moved, left, slopes, max(damping / 3, 1e-9)
            else:
                damping *= 4
            if damping > 1e6:
                break
        best = min(best, float(np.linalg.norm(error)))
    return best


@pytest.mark.slow
@examples(15)
@given(seed=seeds, joints=st.integers(4, 7), slide=st.booleans(), spread=st.floats(0.3, 3.0))
def test_no_descent_ends_nearer(seed, joints, slide, spread):
    robot = chain(seed, [*([False] * (joints - 1)), slide]).with_limits(lower=-1.2, upper=1.0)
    rng = np.random.default_rng(seed)
    pose = np.eye(4)
    pose[:3, :3], pose[:3, 3] = random_rotation(rng), rng.normal(scale=spread, size=3)
    found = nearest_to(robot.kinematics(mp.Task.pose(length=1.0)), NOTHING, pose)
    error, _ = own_error(robot, robot.model.createData(), found.q, pose)
    assert (robot.limits.outside(found.q) <= 0).all()
    assert np.hypot(found.position, found.rotation) == pytest.approx(np.linalg.norm(error), rel=1e-6, abs=1e-9)
    assert np.linalg.norm(error) <= 1.01 * by_descents(robot, pose, rng) + 1e-9
    at = [name for name, q in zip(robot.joint_names, found.q, strict=True) if min(q + 1.2, 1.0 - q) <= 1e-6]
    assert list(found.stopped) == at


@pytest.mark.slow
def test_refusals_of_follow_and_plan_have_the_configuration(panda):
    begin = panda.kinematics().pose(panda.neutral)
    far = begin.copy()
    far[:3, 3] *= 4
    with pytest.raises(mp.errors.OutOfReachError, match=r"the arm stays [\d.]+ mm and [\d.]+° away") as told:
        mp.follow(panda, mp.CartesianPath.line(begin, far), positions=[0.0, 1.0])
    with pytest.raises(mp.errors.OutOfReachError, match="out of reach") as planned:
        mp.plan(panda, panda.neutral, far)
    norms = []
    for error in (told.value, planned.value):
        own, _ = own_error_of_panda(panda, error.nearest.q, far)
        assert np.linalg.norm(own[:3]) == pytest.approx(error.nearest.position, rel=1e-6)
        norms.append(np.linalg.norm(own))
    assert norms[0] == pytest.approx(norms[1], rel=1e-2)
    assert f"{1e3 * told.value.nearest.position:.4g} mm" in str(told.value)


def own_error_of_panda(panda, q, pose):
    """As `own_error`, by the frame of the arm's own tool."""
    data = panda.model.createData()
    pin.framesForwardKinematics(panda.model, data, q)
    own = data.oMf[panda.model.getFrameId(panda.tool, pin.FrameType.BODY)]
    return np.concatenate([pose[:3, 3] - own.translation, pin.log3(pose[:3, :3] @ own.rotation.T)]), None
