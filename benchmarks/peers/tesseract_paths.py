"""tesseract's TrajOpt with AvoidSingularity: `python tesseract_paths.py problem.npz result.npz`.

A problem has what world.py writes, and: seeds (k, m, n), the first paths at even s, whose m waypoints TrajOpt moves;
clearance [m], time_limit [s] and weight, the coefficient of AvoidSingularity. The clearance is a constraint, checked
continuously between waypoints; velocities are smoothed, as in the default profile.

The result has waypoints (k, m, n), time and cpu (k,) [s] and said (k,).
"""

import json
import sys
import time
from pathlib import Path

import numpy as np
import tesseract_robotics
from tesseract_robotics.tesseract_command_language import (
    CompositeInstruction,
    InstructionPoly_as_MoveInstructionPoly,
    JointWaypoint,
    JointWaypointPoly_wrap_JointWaypoint,
    MoveInstruction,
    MoveInstructionPoly_wrap_MoveInstruction,
    MoveInstructionType_FREESPACE,
    ProfileDictionary,
    WaypointPoly_as_JointWaypointPoly,
    WaypointPoly_as_StateWaypointPoly,
)
from tesseract_robotics.tesseract_common import FilesystemPath, GeneralResourceLocator, ManipulatorInfo
from tesseract_robotics.tesseract_environment import Environment
from tesseract_robotics.tesseract_motion_planners import PlannerRequest
from tesseract_robotics.tesseract_motion_planners_trajopt import (
    CollisionEvaluatorType_CAST_CONTINUOUS,
    TrajOptDefaultCompositeProfile,
    TrajOptDefaultPlanProfile,
    TrajOptMotionPlanner,
)

NAMESPACE = "TrajOptMotionPlannerTask"


def read():
    with np.load(sys.argv[1]) as file:
        return {key: value.item() if value.ndim == 0 else value for key, value in file.items()}


def write_plugins(folder):
    """The two files that world.srdf names: which of the wheel's libraries hold the plugins for kinematics and collision."""
    libraries = Path(tesseract_robotics.__file__).parents[1] / "tesseract_robotics.libs"

    def plugins(library, **kinds):
        (found,) = libraries.glob(f"lib{library}-*.so")
        return {"search_paths": [str(libraries)], "search_libraries": [found.stem.removeprefix("lib")], **kinds}

    def only(name, **config):
        return {"default": name, "plugins": {name: {"class": f"{name}Factory"} | config}}

    ends = {"config": {"base_link": "base", "tip_link": "tool"}}
    kinematics = plugins(
        "tesseract_kinematics_kdl_factories",
        fwd_kin_plugins={"arm": only("KDLFwdKinChain", **ends)},
        inv_kin_plugins={"arm": only("KDLInvKinChainLMA", **ends)},
    )
    contact = plugins(
        "tesseract_collision_bullet_factories",
        discrete_plugins=only("BulletDiscreteBVHManager"),
        continuous_plugins=only("BulletCastBVHManager"),
    )
    # JSON is YAML
    (folder / "kinematics.yaml").write_text(json.dumps({"kinematic_plugins": kinematics}))
    (folder / "contact_managers.yaml").write_text(json.dumps({"contact_manager_plugins": contact}))


def profiles_of(problem):
    composite, plan, n = TrajOptDefaultCompositeProfile(), TrajOptDefaultPlanProfile(), len(problem["joints"])
    composite.smooth_velocities, composite.velocity_coeff = True, np.ones(n)
    composite.smooth_accelerations = composite.smooth_jerks = False
    composite.avoid_singularity, composite.avoid_singularity_coeff = True, problem["weight"]
    composite.collision_cost_config.enabled = False
    composite.collision_constraint_config.enabled = True
    composite.collision_constraint_config.type = CollisionEvaluatorType_CAST_CONTINUOUS
    composite.collision_constraint_config.safety_margin = problem["clearance"]
    composite.collision_constraint_config.safety_margin_buffer = 0.01
    composite.longest_valid_segment_length = 0.05
    profiles = ProfileDictionary()
    profiles.addProfile(NAMESPACE, "DEFAULT", composite)
    profiles.addProfile(NAMESPACE, "DEFAULT", plan)
    return profiles


def solve(environment, profiles, joints, seed):
    info = ManipulatorInfo()
    info.manipulator, info.tcp_frame, info.working_frame = "arm", "tool", "base"
    program = CompositeInstruction("DEFAULT")
    program.setManipulatorInfo(info)
    for k, q in enumerate(seed):
        waypoint = JointWaypoint(joints, q, k in (0, len(seed) - 1))  # only the ends are held
        move = MoveInstruction(JointWaypointPoly_wrap_JointWaypoint(waypoint), MoveInstructionType_FREESPACE, "DEFAULT")
        program.appendMoveInstruction(MoveInstructionPoly_wrap_MoveInstruction(move))
    environment.setState(joints, seed[0])
    request = PlannerRequest()
    request.instructions, request.env, request.profiles = program, environment, profiles
    response = TrajOptMotionPlanner(NAMESPACE).solve(request)
    # each of these must live as long as what is taken out of it
    results, found = response.results, []
    instructions = results.getInstructions()
    for k in range(len(instructions)):
        move = InstructionPoly_as_MoveInstructionPoly(instructions[k])
        waypoint = move.getWaypoint()
        if waypoint.isStateWaypoint():
            state = WaypointPoly_as_StateWaypointPoly(waypoint)
        else:
            state = WaypointPoly_as_JointWaypointPoly(waypoint)
        found.append(np.array(state.getPosition()).ravel())
    return np.array(found), "ok" if response.successful else str(response.message)


def main():
    problem = read()
    joints = [str(name) for name in problem["joints"]]
    write_plugins(Path(problem["urdf"]).parent)
    environment, locator = Environment(), GeneralResourceLocator()
    assert environment.init(FilesystemPath(problem["urdf"]), FilesystemPath(problem["srdf"]), locator)
    profiles = profiles_of(problem)
    solve(environment, profiles, joints, problem["seeds"][0])
    waypoints, seconds, cpu, said = [], [], [], []
    for seed in problem["seeds"]:
        began, used = time.perf_counter(), time.process_time()
        path, word = solve(environment, profiles, joints, seed)
        seconds.append(time.perf_counter() - began)
        cpu.append(time.process_time() - used)
        waypoints.append(path)
        said.append(word)
    np.savez(sys.argv[2], waypoints=waypoints, time=seconds, cpu=cpu, said=said)


if __name__ == "__main__":
    main()
