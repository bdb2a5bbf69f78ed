"""The motion of both arms that hold an object: one arm has its best motion, and the other one keeps free of it."""

from collections.abc import Sequence
from itertools import permutations

import numpy as np

from manipplan.ik.solver import Solver
from manipplan.jobs.carrying.lone_arm import LoneArm, lone_robot
from manipplan.jobs.carrying.request import Request
from manipplan.paths.joint import JointPath, side_by_side
from manipplan.robots.arms import own_joints
from manipplan.robots.robot import Robot
from manipplan.search.candidates.layers import SPARE_CLEARANCE
from manipplan.search.candidates.positions import STRIDE
from manipplan.search.candidates.sampling import default_samples, sample_layers
from manipplan.seeds.acceptance import CHECK_STEP
from manipplan.support.errors import InvalidInputError, PlanningError
from manipplan.support.progress import Progress, part

#: Number of places at which the nearest bodies are looked for.
PLACES = 401
#: How many times as many samples are taken where those of the default do not connect.
FINER = 4


def motion_of_both(request: Request, tell: Progress) -> tuple[JointPath, JointPath]:
    """The joint path of the whole robot, and the same as searched; where nothing connects, with closer positions and samples.

    Raises PlanningError with the reason, and InvalidInputError for a position that a tool cannot reach.
    """
    if request.positions is not None and request.samples is not None:
        return _tried(request, tell, finer=False)
    try:
        return _tried(request, part(tell, 0.0, 0.5), finer=False)
    except PlanningError as first:
        try:
            return _tried(request, part(tell, 0.5, 1.0), finer=True)
        except InvalidInputError as error:  # the positions and samples are not the caller's
            raise first from error


def _tried(request: Request, tell: Progress, *, finer: bool) -> tuple[JointPath, JointPath]:
    """The same with the default positions and samples, or finer ones."""
    arms = _arms(request, part(tell, 0.0, 0.8), finer=finer)
    tell(0.8, "searching for motions of the arms")
    return _motion(request, arms)


def _arms(request: Request, tell: Progress, *, finer: bool) -> list[LoneArm]:
    """Both arms with all their configurations at the positions."""
    arms, robot = [], request.robot
    s = request.at(STRIDE / 2 if finer else STRIDE)
    for k, tool in enumerate(request.grasps):
        joints = own_joints(robot, tool)
        lone = lone_robot(robot, tool, joints, request.still)
        try:
            layers = sample_layers(
                lone,
                request.way(tool),
                s,
                measure=request.integral.kinematics.measure.of_one_tool(),
                task=request.integral.kinematics.task,
                samples=request.samples if request.samples is not None else _count(lone) * (FINER if finer else 1),
                scene=request.scene,
                clearance=request.clearance,
                spare=SPARE_CLEARANCE,
                seed=request.seed,
                progress=part(tell, k / len(request.grasps), (k + 1) / len(request.grasps)),
            )
        except InvalidInputError as error:
            argument = error.argument if error.argument == "samples" else f"{tool}: {error.argument}"
            raise InvalidInputError(argument, error.value, error.allowed) from error
        layers = layers.inside(lone.limits)
        arm = LoneArm(
            tool=tool,
            joints=joints,
            path=request.way(tool),
            layers=layers,
            epsilon=request.epsilon[joints],
            tolerance=request.own_tolerance,
        )
        arms.append(arm if request.start is None else arm.starting_at(request.start[joints]))
    return arms


def _count(lone: Robot) -> int:
    """Default number of samples per parameter of redundancy."""
    solver = Solver.of(lone, task=None, held=None, method="auto", seed=0)
    usual = default_samples(solver)
    return usual[min(max(len(solver.names), 1), len(usual)) - 1]


def _motion(request: Request, arms: Sequence[LoneArm]) -> tuple[JointPath, JointPath]:
    """The motion of the first order of the arms that gives one; raises PlanningError with the reasons where none does."""
    reasons = []
    for lead, follow in permutations(arms):
        try:
            return _in_order(request, lead, follow)
        except PlanningError as error:
            reasons.append(f"{lead.tool} leads: {error}")
    raise PlanningError("; ".join(reasons))


def _in_order(request: Request, lead: LoneArm, follow: LoneArm) -> tuple[JointPath, JointPath]:
    model, s, still = request.scene.collision_model(request.robot), lead.layers.s, request.still
    assert s is not None
    refined, searched = lead.courses()
    q = np.tile(still, (len(s), 1))
    q[:, lead.joints] = refined(s)
    beside = follow.beside(model, q, request.clearance + SPARE_CLEARANCE)
    refined_beside, searched_beside = beside.courses()
    seed = side_by_side([(searched, lead.joints), (searched_beside, follow.joints)], still)
    for own in (refined_beside, searched_beside):  # what is refined knows nothing of the other arm
        joint = side_by_side([(refined, lead.joints), (own, follow.joints)], still)
        if model.path_is_free(joint, CHECK_STEP, request.clearance):
            return joint, seed
    bodies, _ = model.nearest_bodies(joint(np.linspace(0.0, 1.0, PLACES)))
    raise PlanningError(f"between the positions {bodies}; take more positions")
