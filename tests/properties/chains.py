"""Random serial chains of revolute and prismatic joints, for hypothesis."""

import numpy as np
import pinocchio as pin
from hypothesis import strategies as st

from manipplan.robots.limits import JointLimits
from manipplan.robots.robot import Robot


def random_rotation(rng):
    return pin.Quaternion(rng.normal(size=4)).normalized().matrix()


def chain(seed, prismatic, *, scale=1.0, base=None, tool=None):
    """A chain with one joint for each entry of `prismatic`; the same seed gives the same chain, with lengths times scale."""
    rng = np.random.default_rng(seed)
    model = pin.Model()
    model.name = "random"
    joint = 0
    for i, slides in enumerate(prismatic):
        axis = rng.normal(size=3)
        axis /= np.linalg.norm(axis)
        kind = pin.JointModelPrismaticUnaligned if slides else pin.JointModelRevoluteUnaligned
        placement = pin.SE3(random_rotation(rng), scale * rng.uniform(-0.5, 0.5, 3))
        if i == 0 and base is not None:
            placement = base * placement
        joint = model.addJoint(joint, kind(axis), placement, f"joint{i}")
        model.appendBodyToJoint(joint, pin.Inertia.Random(), pin.SE3.Identity())
    offset = pin.SE3(random_rotation(rng), scale * rng.uniform(-0.5, 0.5, 3))
    model.addBodyFrame("tool", joint, offset if tool is None else offset * tool, 0)
    n = model.nv
    limits = JointLimits(
        lower=np.full(n, -3.0),
        upper=np.full(n, 3.0),
        velocity=np.ones(n),
        acceleration=np.ones(n),
        jerk=np.full(n, np.inf),
        effort=np.full(n, np.inf),
    )
    return Robot(name="random", model=model, geometry=pin.GeometryModel(), tool="tool", limits=limits, neutral=np.zeros(n))


seeds = st.integers(0, 2**32 - 1)


def kinds(least, most=9):
    return st.lists(st.sampled_from([False, False, False, True]), min_size=least, max_size=most)


@st.composite
def placements(draw):
    rng = np.random.default_rng(draw(seeds))
    return pin.SE3(random_rotation(rng), rng.uniform(-1, 1, 3))


@st.composite
def joint_values(draw, n):
    return np.array(draw(st.lists(st.floats(-3.0, 3.0), min_size=n, max_size=n)))


def chain_file(file, joints, tool):
    """A URDF of a chain in `file`: joints as (kind, place, turn, axis, lower, upper), and the place of the link "tool"."""
    text = '<link name="l0"/>'
    for k, (kind, place, turn, axis, lower, upper) in enumerate(joints):
        text += (
            f'<link name="l{k + 1}"/><joint name="j{k + 1}" type="{kind}"><parent link="l{k}"/><child link="l{k + 1}"/>'
            f'<origin xyz="{place}" rpy="{turn}"/><axis xyz="{axis}"/>'
            f'<limit lower="{lower}" upper="{upper}" velocity="1" effort="10"/></joint>'
        )
    text += (
        f'<link name="tool"/><joint name="flange" type="fixed"><parent link="l{len(joints)}"/><child link="tool"/>'
        f'<origin xyz="{tool}"/></joint>'
    )
    file.write_text(f'<robot name="{file.stem}">{text}</robot>')
    return file
