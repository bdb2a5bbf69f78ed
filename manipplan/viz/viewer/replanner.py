"""The part of the viewer's panel in which goal and obstacles are dragged and the motion is planned again."""

import threading
from collections.abc import Callable
from html import escape
from typing import Any

import numpy as np
import pinocchio as pin

from manipplan.collision.scene import Scene
from manipplan.cost.objective import PathObjective
from manipplan.goals.goal import Goal, PoseGoal
from manipplan.jobs.plan import plan
from manipplan.plans.result import Plan
from manipplan.support.errors import InvalidInputError, ManipplanError
from manipplan.support.status import RECORDED
from manipplan.viz.motions import ShownMotion
from manipplan.viz.viewer.stage import Stage, put

#: Size of the arrows, as a share of the diagonal of what is shown, and of the axes at the goal.
ARROWS, AXES = 0.12, 0.05
#: The choice of nothing to drag.
NOTHING = "nothing"


def can_replan(motion: ShownMotion) -> bool:
    """Whether it is a plan from a start to a goal; a tool path, a recording and a program have more than a goal."""
    made = motion.plan
    return isinstance(made, Plan) and made.workspace_path is None and made.result.status not in RECORDED


class _StopError(Exception):
    """The planning was stopped."""


#: What the panel says then.
STOPPED = "Stopped; the motion is the one before."


class Replanner:
    """Arrows to drag goal and obstacles with, and a thread that plans again.

    Attributes:
        planning: whether a motion was asked for, and is neither shown nor stopped.
        text: what it does, or how the last planning ended; "" before.
        scene: the obstacles where they are now.
        arrows: viser's handle of what is dragged.
    """

    def __init__(self, server: Any, running: Callable[[], bool], show: Callable[[ShownMotion], None]) -> None:
        """`running`: whether the page is served; `show` shows another motion, and calls `fill_panel` again."""
        self._server, self._running, self._show = server, running, show
        self._asked, self._stopped = threading.Event(), threading.Event()
        self._lock, self.planning, self.text = threading.Lock(), False, ""

    def fill_panel(self, motion: ShownMotion, stage: Stage) -> None:
        """Put the controls into the panel, and the goals into the scene."""
        assert isinstance(motion.plan, Plan)
        gui, scene = self._server.gui, self._server.scene
        self._plan, self._stage, self._chosen = motion.plan, stage, -1
        self.scene = motion.scene
        self._goals = [pin.SE3(tool.pose(motion.trajectory.q[-1])) for tool in motion.tools]
        self._is_dragged = False
        several = len(self._goals) > 1
        choices = [NOTHING, *(f"goal of {tool}" if several else "goal" for tool in motion.robot.tools), *motion.scene.names]
        size = stage.around.size
        self._marks = [
            scene.add_frame(f"/goal/{k}", axes_length=AXES * size, axes_radius=0.03 * AXES * size)
            for k in range(len(self._goals))
        ]
        for mark, goal in zip(self._marks, self._goals, strict=True):
            put(mark, goal)
        axes = (True, True, not motion.robot.planar)
        self.arrows = scene.add_transform_controls("/arrows", ARROWS * size, active_axes=axes, depth_test=False, visible=False)
        with gui.add_folder("Plan again", expand_by_default=bool(self.text)):
            self._choice = gui.add_dropdown("drag", choices, initial_value=NOTHING)
            self._button = gui.add_button("Plan again", icon="route")
            self._stop = gui.add_button("Stop", icon="player-stop", visible=False)
            self._bar = gui.add_progress_bar(0.0, visible=False)
            self._line = gui.add_html("")
        self._say(self.text)
        self._choice.on_update(lambda _: self.choose(choices.index(self._choice.value)))
        self.arrows.on_update(self._drag)
        self._button.on_click(lambda _: self.plan())
        self._stop.on_click(lambda _: self.stop())

    def choose(self, k: int) -> None:
        """Put the arrows at a choice: 0 at nothing, then the goal of each tool, then each obstacle."""
        self._chosen = k - 1
        self.arrows.visible = k > 0
        if k > 0:
            n = len(self._goals)
            put(self.arrows, self._goals[k - 1] if k <= n else self.scene.obstacles[k - 1 - n].pose)

    def _drag(self, event: Any) -> None:
        w, x, y, z = event.target.wxyz
        self.move(pin.SE3(pin.Quaternion(w, x, y, z).normalized().toRotationMatrix(), np.array(event.target.position)))

    def move(self, pose: pin.SE3) -> None:
        """Move what is chosen."""
        k = self._chosen - len(self._goals)
        if k < 0:
            self._goals[self._chosen], self._is_dragged = pose, True
            put(self._marks[self._chosen], pose)
            return
        obstacles = self.scene.named
        obstacles[k] = obstacles[k].at(pose * obstacles[k].pose.inverse())
        self.scene = Scene(obstacles, allowed=self.scene.allowed)
        for figure in self._stage.around.obstacles:
            figure.place(k, pose)

    def _set_planning(self, value: bool) -> None:
        self.planning = value
        self._button.visible, self._stop.visible, self._bar.visible = not value, value, value

    def plan(self) -> None:
        """Ask for the motion among the obstacles as they are now."""
        if not self.planning:
            self._stopped = threading.Event()
            self._bar.value = 0.0
            self._set_planning(True)
            self._asked.set()

    def stop(self) -> None:
        """Stop at once: what the planner still does until its next step is not shown."""
        with self._lock:
            if self.planning:
                self._stopped.set()
                self._say(STOPPED)
                self._set_planning(False)

    def run(self) -> None:
        """Plan whenever it is asked for, until the page ends."""
        while self._running():
            if self._asked.wait(0.2):
                self._asked.clear()
                if not self._stopped.is_set():
                    self._work(self._stopped)

    def _work(self, stopped: threading.Event) -> None:
        def notify(share: float, text: str) -> None:
            with self._lock:
                if stopped.is_set() or not self._running():
                    raise _StopError
                self._bar.value = 100 * share
                self._say(f"{text[0].upper()}{text[1:]} ...")

        made, result, report = self._plan, self._plan.result, self._plan.report
        goal: Goal = made.trajectory.q[-1]
        if self._is_dragged:
            poses = dict(zip(made.robot.tools, (PoseGoal(each) for each in self._goals), strict=True))
            goal = poses if len(poses) > 1 else poses[made.robot.tool]
        try:
            found: Plan | str = plan(
                made.robot,
                made.trajectory.q[0],
                goal,
                self.scene,
                constraints=made.constraints,
                objective=PathObjective(
                    power=result.power, task=result.task, measure=result.measure, metric=result.metric, floor=result.floor
                ),
                clearance=report.required_clearance,
                torque="torque" in report.limits,
                progress=notify,
            )
        except _StopError:
            return
        except InvalidInputError as error:  # its value is an array of numbers
            found = f"The {error.argument} has to be {error.allowed}."
        except ManipplanError as error:
            found = str(error)
        with self._lock:
            if stopped.is_set():
                return
            if isinstance(found, str):
                self._say(found, failed=True)
            else:
                self.text = f"{found.status.value[0].upper()}{found.status.value[1:]}."
                self._show(ShownMotion.of(found))  # which fills the panel again
            self._set_planning(False)

    def _say(self, text: str, *, failed: bool = False) -> None:
        self.text = text
        kind = ' class="error"' if failed else ""
        self._line.content = f'<div class="figures"><p role="status"{kind}>{escape(text)}</p></div>'
