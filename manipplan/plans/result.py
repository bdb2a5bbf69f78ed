"""Plan and PartialPlan: the results of all jobs, and `finish`, which ends every job with a timed and checked motion."""

from collections.abc import Callable
from dataclasses import dataclass, field, fields, replace
from pathlib import Path
from typing import TYPE_CHECKING, TypeVar

from manipplan.collision.scene import Scene
from manipplan.constraints.constraint import Constraint
from manipplan.goals.candidates import GoalCandidate
from manipplan.measures.measure import Measure
from manipplan.optimize.result import PathResult
from manipplan.paths.cartesian import CartesianPath
from manipplan.paths.deviation import Deviation
from manipplan.paths.joint import JointPath
from manipplan.paths.tolerance import Tolerance
from manipplan.paths.trajectory import Trajectory
from manipplan.plans.measure import measure_plan
from manipplan.plans.report import Comparison, PathPart, PlanReport
from manipplan.robots.limits import TakenToLimit
from manipplan.robots.robot import Robot
from manipplan.search.max_min import SearchResult
from manipplan.search.refine import Refinement
from manipplan.support.checks import Array
from manipplan.support.display import Pictured, short
from manipplan.support.errors import InvalidInputError, PlanningError
from manipplan.support.files import replacing, write_text
from manipplan.support.progress import Progress, silent
from manipplan.support.status import Status

if TYPE_CHECKING:
    from manipplan.viz.viewer import PlanViewer

Given = TypeVar("Given", bound="PartialPlan")


@dataclass(frozen=True, kw_only=True, repr=False, eq=False)
class PartialPlan(Pictured):
    """What a job returns with throw=False when it ends before there is a trajectory: missing parts are None.

    Attributes:
        robot, scene: what was planned for.
        status: how the path was obtained.
        path: the JointPath from start to goal.
        trajectory: the timed motion along it.
        report: the figures of this trajectory, measured on it; raises InvalidInputError together with another trajectory.
        result: the optimiser's result, with seed and history; for `improve` the seed is the recorded motion.
        search, refinement: for `follow`: the path found among the samples, and its refinement; with interruptions those of the
            part with the smallest minimum.
        workspace_path: the path that `follow` follows.
        tolerance: maximum deviation of the tool, for `follow` and `improve`.
        constraints: for `plan`: what the motion keeps beside limits and clearance.
        goal_index: for `plan`: index of the goal that is reached in the list of goals; 0 for a single goal.
        candidates: for `plan`: the configurations that reach a goal, and what was done with each; for `follow` with a start:
            those in which the path can begin.
        message: the reason of a failure.
    """

    robot: Robot
    scene: Scene
    status: Status
    path: JointPath | None = None
    trajectory: Trajectory | None = None
    report: PlanReport | None = None
    result: PathResult | None = None
    search: SearchResult | None = None
    refinement: Refinement | None = None
    workspace_path: CartesianPath | None = None
    tolerance: Tolerance | None = None
    constraints: tuple[Constraint, ...] = ()
    goal_index: int = 0
    candidates: tuple[GoalCandidate, ...] = ()
    message: str = ""

    def __post_init__(self) -> None:
        if self.report is None or (self.trajectory is not None and self.trajectory.digest == self.report.digest):
            return
        wanted = (
            "the trajectory that plan.report was measured on. Another one is not part of this plan: judge it by "
            "mp.check(plan.robot, trajectory, plan.scene), and write it by trajectory.to_csv"
        )
        other = "none" if self.trajectory is None else f"a motion of {self.trajectory.duration:.4g} s"
        raise InvalidInputError("trajectory", other, wanted)

    def __repr__(self) -> str:
        summary = short(self.message) if self.report is None else self.report.summary
        return f"{type(self).__name__}({self.robot.name!r}, {self.status.name}, {summary})"

    @property
    def path_begin(self) -> float:
        """For `follow`: the time at which the motion along the workspace path begins, after the lead-in [s]; otherwise 0."""
        return self.report.along[0].begin if self.report is not None and self.report.along else 0.0

    @property
    def off_path(self) -> tuple[tuple[float, float], ...]:
        """For `follow`: the times between which the tool is not on the workspace path [s]: lead-in, interruptions, way back."""
        if self.report is None or not self.report.along:
            return ()
        along = self.report.along
        times = [0.0, *(time for part in along for time in (part.begin, part.end)), self.report.duration]
        return tuple((begin, end) for begin, end in zip(times[::2], times[1::2], strict=True) if end > begin)

    @property
    def deviation(self) -> Deviation | None:
        """For `follow` and `carry`: the largest distances of the tool from the workspace path; those of the report."""
        return None if self.report is None else self.report.deviation

    @property
    def comparison(self) -> Comparison | None:
        """For `improve`, the recorded motion and this one side by side; that of the report."""
        return None if self.report is None else self.report.comparison

    def save(self, folder: str | Path) -> list[Path]:
        """Write trajectory.csv, .json and .yaml (ROS), report.json, report.txt, plan.png and plan.json; returns the files.

        `load` reads plan.json. Parts that cannot be written there (a measure, obstacle or workspace path of a class of your
        own, a robot put together by hand) are named in the log, and have to be given when the plan is loaded. All files of a
        plan or program that was saved there before are replaced in one step; a process that is killed leaves no mixture.

        Raises InvalidInputError when the folder cannot be written and PlanningError when there is no trajectory.
        """
        from manipplan.plans import archive
        from manipplan.viz import save_figure

        plan = self._complete("save")
        with replacing(folder) as (to, new):
            archive.write_plan(plan, new / archive.NAME, home=to)
            plan.trajectory.to_csv(new / "trajectory.csv")
            plan.trajectory.to_json(new / "trajectory.json")
            plan.trajectory.to_ros(new / "trajectory.yaml")
            plan.report.to_json(new / "report.json")
            write_text(new / "report.txt", f"{plan.report}\n")
        save_figure(plan, to / "plan.png")  # last: the data are on disk even if the picture fails
        names = ("trajectory.csv", "trajectory.json", "trajectory.yaml", "report.json", "report.txt", "plan.png", archive.NAME)
        return [to / name for name in names]

    @staticmethod
    def load(
        file: str | Path, *, robot: Robot | None = None, scene: Scene | None = None, measure: Measure | None = None
    ) -> "Plan":
        """Read a plan that `save` wrote, to show it, to check it or to save it again: all numbers are the same.

        The report is the one measured before the plan was saved; nothing is measured again. A file that was changed since is
        rejected, and so is a robot with different kinematics or different outlines of its bodies. Data that only the solvers
        need are not kept: `search`, and the `history` and `rivals` of `result`.

        Args:
            file: the folder, or plan.json in it.
            robot, scene, measure: used instead of the stored ones, if files of the robot or its meshes are missing, or if
                they are of a class of your own. The robot has to be the one that was planned for; different limits are
                logged. Whether the scene is the same is not checked.

        Raises:
            FileFormatError: the file is not a result, truncated, changed or of another version, or a robot or mesh file is
                missing or was changed.
            MissingExtraError: the robot is from the catalogue, whose package is not installed.
        """
        from manipplan.plans import archive

        return archive.read_plan(file, robot=robot, scene=scene, measure=measure)

    def show(self, *, port: int = 8080, host: str = "localhost", open_browser: bool = True) -> "PlanViewer":
        """Show the motion in the browser; see `manipplan.viz.viewer.show`. In a script: `plan.show().wait()`."""
        from manipplan.viz.viewer import show

        return show(self._complete("show"), port=port, host=host, open_browser=open_browser)

    def record(self, file: str | Path) -> Path:
        """Write the motion as an HTML file that plays in any browser; see `manipplan.viz.viewer.record`."""
        from manipplan.viz.viewer import record

        return record(self._complete("record"), file)

    def _complete(self, work: str) -> "Plan":
        if not isinstance(self, Plan):
            raise PlanningError(f"there is no trajectory to {work}: {self.message or self.status.value}", self)
        return self


@dataclass(frozen=True, kw_only=True, repr=False, eq=False)
class Plan(PartialPlan):
    """A motion with its path, its trajectory and its report; `status` tells whether the request was met.

    Attributes: those of PartialPlan, where `path`, `trajectory`, `report` and `result` are never None. With throw=False the
    status may be Status.CHECK_FAILED: then the report says which check did not pass.
    """

    path: JointPath = field()
    trajectory: Trajectory = field()
    report: PlanReport = field()
    result: PathResult = field()


def finish(
    draft: PartialPlan,
    time: Callable[[], tuple[Trajectory, tuple[PathPart, ...]]],
    *,
    goal: Array | None = None,
    taken: tuple[TakenToLimit, ...] = (),
    clearance: float,
    torque: bool,
    throw: bool,
    notify: Progress = silent,
    begins: float = 0.0,
    amend: Callable[[PlanReport, Trajectory], PlanReport] = lambda report, _: report,
) -> Plan | PartialPlan:
    """End a job: time the path of the draft, measure the motion, and return the plan or raise it where something is wrong.

    Args:
        draft: the plan so far, with path, result and the status that it has if all checks pass.
        time: makes the motion along the path, and tells which parts of it follow the workspace path; a PlanningError of it is
            Status.NO_TIMING.
        goal: (n,) where the motion has to end [rad or m]; None: where the path does.
        taken: joints of start and goal that were taken to a limit.
        clearance, torque, throw, notify: as in `plan`; `begins` is the fraction done at which this ending begins.
        amend: adds to the report what only this job knows, and its faults.
    """
    path, result = draft.path, draft.result
    assert path is not None and result is not None
    notify(begins, "timing the motion")
    try:
        trajectory, along = time()
    except PlanningError as error:
        return failed(replace(draft, status=Status.NO_TIMING), throw, str(error))
    notify((begins + 1) / 2, "checking the result")
    report = measure_plan(
        trajectory,
        result,
        draft.scene.collision_model(draft.robot),
        path.goal if goal is None else goal,
        constraints=draft.constraints,
        clearance=clearance,
        torque=torque,
    )
    report = amend(replace(report, status=draft.status, along=along, taken_to_limits=taken), trajectory)
    if report.faults:
        report = replace(report, status=Status.CHECK_FAILED, passed=False)
    parts = {each.name: getattr(draft, each.name) for each in fields(draft)}
    plan = Plan(**parts | {"status": report.status, "trajectory": trajectory, "report": report})
    if report.faults:
        return failed(plan, throw, str(report))
    notify(1.0, "done")
    return plan


def failed(plan: Given, throw: bool, message: str) -> Given:
    """The plan with its message, returned or raised."""
    without = replace(plan, message=message)
    if throw:
        raise PlanningError(message, without)
    return without
