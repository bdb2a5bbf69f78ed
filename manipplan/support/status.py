"""Return status of a result: the outcome and, where something is left to do, the remedy; Failure: why there is no result."""

from dataclasses import dataclass
from enum import Enum


class Status(Enum):
    """Outcome of a job, a search or a tracked path. The value is the text for the user: what happened, and the remedy.

    A job is `plan`, `optimize_path`, `follow` or `improve`. `ok` tells whether the request was met.
    """

    # paths between two configurations
    OPTIMAL = "optimal: the first-order conditions of a local optimum hold, and every check passed"
    SHORTEST = (
        "shortest: the manipulability does not count, as it is zero in every configuration of this arm or its measure is "
        "constant; the first-order conditions of a locally shortest path hold, and every check passed"
    )
    STOPPED_EARLY = (
        "feasible, not converged: every check passed, but the first-order conditions of a local optimum do not hold; start "
        "again from this path (Seeding.initial), raise PathShape.degree, or try another Seeding.seed"
    )
    OUT_OF_TIME = (
        "feasible, out of time: every check passed, but the time limit ended the work before the first-order conditions of a "
        "local optimum held; raise Seeding.time_limit, or start again from this path (Seeding.initial)"
    )
    SEED_IS_BETTER = (
        "seed: no optimised path of this degree was found that has a lower g than the collision-free seed, which is returned; "
        "raise PathShape.degree, or try another Seeding.seed"
    )
    SEED_IS_SAFE = (
        "seed: no optimised path of this degree was found that stays clear of collisions, so the collision-free seed is "
        "returned; raise PathShape.degree, lower clearance, or try another Seeding.seed"
    )
    SEED_OUT_OF_TIME = (
        "seed, out of time: the time limit ended the work before an optimised path was found that passes every check, so the "
        "collision-free seed is returned; raise Seeding.time_limit"
    )
    ENDS_NOT_MET = (
        "seed: no path of this degree with the given end slopes and bends is inside the limits and collision-free, so the "
        "collision-free seed, which does not have them, is returned; raise PathShape.degree, or give smaller ones"
    )
    SINGULAR = (
        "singular: every check passed, but the manipulability is below the floor on more than a tenth of the path or, without "
        "a floor, zero somewhere, so that g is infinite; choose another start or goal, such as another solution of "
        "inverse_kinematics. With as many joints as task rows every path between configurations at which det J has different "
        "signs crosses a singularity"
    )
    AT_GOAL = "there already: the arm stands where the motion has to end, so the motion stands still, and every check passed"
    INTERRUPTED = "interrupted: the best checked path so far, optimised or the seed; run it again to get further"
    # recorded motions
    IMPROVED = (
        "improved: the minimum or mean manipulability of the recorded motion rose, its minimum did not fall, neither g nor "
        "jerk rose, and every check passed"
    )
    NOT_BETTER = (
        "smoothed: the manipulability of the recorded motion could not be raised without a lower minimum, a higher g or more "
        "jerk; the motion is the recording without its noise, inside the limits, and every check passed; allow more tolerance"
    )
    SMOOTHED_OUT_OF_TIME = (
        "smoothed, out of time: the time limit ended the work before the manipulability of the recorded motion was raised; the "
        "motion is the recording without its noise, inside the limits, and every check passed; raise time_limit"
    )
    NOT_FOLLOWED = "failed: no motion inside the tolerance around the recorded one is clear of collisions; allow more tolerance"
    # tool paths
    FOLLOWED = (
        "followed: the motion follows the workspace path with the largest minimum manipulability found, and every check passed"
    )
    FOLLOWED_IN_PARTS = (
        "followed in parts: the motion follows the workspace path with as few interruptions as the samples allow and the "
        "largest minimum manipulability found with so few, and every check passed"
    )
    NOT_CONNECTED = (
        "failed: no continuous path leads through the candidates of all positions; take more positions, more samples or a "
        "larger epsilon; mp.follow with its default positions and samples names what ends the motions"
    )
    # programs
    CARRIED = "carried: all tools move the object along its path, one arm led and the others followed, and every check passed"
    COMPOSED = "composed: motions of a program, joined up to the next stop, and every check passed"
    # any job
    NO_PATH = "failed: no collision-free path was found; raise Seeding.time_limit, lower clearance, or check the goal"
    NO_TIMING = "failed: no motion along the path obeys the limits; raise effort or acceleration, or choose another path"
    CHECK_FAILED = (
        "failed: the finished trajectory did not pass its own check of limits, collisions or goal; "
        "please report it with the robot, start and goal, unless it names a constraint of yours, which needs more width"
    )
    NOT_IN_TIME = "failed: the time limit ended the work before a motion was proven; raise time_limit"
    # one of many problems
    NOT_VALID = (
        "failed: this robot and scene do not allow the start, the goal or the first path; the message names the joint or the "
        "bodies"
    )
    WORKER_LOST = (
        "failed: the process that planned this died each time, perhaps for want of memory; start fewer processes, or plan it "
        "alone"
    )
    ERROR = "failed: an unexpected error, which the message names; please report it with the robot, start and goal"
    # searches among candidates; NOT_CONNECTED, too
    PROVEN_OPTIMAL = "optimal: no continuous path through these candidates has a larger minimum manipulability"
    IMPROVING = "improving: the search goes on; certified_gap tells how far the optimum can still be above the minimum"
    # tracked paths
    TRACKED = "tracked: the tool stayed inside the tolerance and reached the final pose"
    LEFT_TOLERANCE = "failed: the tool left the tolerance; increase the tolerance or the duration, or start where the path does"
    NOT_REACHED = "failed: the final pose was not reached; it may be out of reach, blocked, or need more time"
    BRAKED = "failed: some steps had no valid solution, and the arm braked"

    @property
    def ok(self) -> bool:
        """Whether the request was met."""
        return self in MET

    @property
    def has_path(self) -> bool:
        """Whether there is a path: for a job, a checked one that a robot can execute."""
        return self not in FAILED


MET = (
    Status.OPTIMAL,
    Status.SHORTEST,
    Status.AT_GOAL,
    Status.STOPPED_EARLY,
    Status.OUT_OF_TIME,
    Status.IMPROVED,
    Status.FOLLOWED,
    Status.FOLLOWED_IN_PARTS,
    Status.CARRIED,
    Status.COMPOSED,
    Status.PROVEN_OPTIMAL,
    Status.TRACKED,
)
#: Statuses without a path.
FAILED = (
    Status.NOT_FOLLOWED,
    Status.NOT_CONNECTED,
    Status.NO_PATH,
    Status.NO_TIMING,
    Status.NOT_IN_TIME,
    Status.CHECK_FAILED,
    Status.NOT_VALID,
    Status.WORKER_LOST,
    Status.ERROR,
    Status.LEFT_TOLERANCE,
    Status.NOT_REACHED,
    Status.BRAKED,
)
#: Statuses of motions along a workspace path.
ALONG = (Status.FOLLOWED, Status.FOLLOWED_IN_PARTS)
#: Statuses of motions that `improve` returns: they start from a recording, not from a planner's seed.
RECORDED = (Status.IMPROVED, Status.NOT_BETTER, Status.SMOOTHED_OUT_OF_TIME)


@dataclass(frozen=True, kw_only=True)
class Failure:
    """What a step of a job returns where it has no result: the reason. Subclasses add what its caller can still do."""

    message: str
