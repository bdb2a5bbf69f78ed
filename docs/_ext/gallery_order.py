"""The order of the pages in each section of the gallery: what a newcomer needs first comes first."""

from pathlib import Path
from typing import Any

ORDER = {
    "first_steps": ("first_plan", "own_robot", "trajectory_files"),
    "plan": ("shelf", "cell", "rivals", "power_and_degree", "singular", "home", "timing"),
    "follow": ("all_solutions", "weld_seam", "talos_circle", "interruptions", "no_motion"),
    "track": ("tracking", "improve_recording", "avoidance", "servo_mujoco", "lerobot", "live_follow", "live_gamepad"),
    "measure": ("measures", "workspace_map", "own_measure", "planar_postures", "pictures"),
    "deploy": ("certificate", "export_c", "mujoco_playback", "cluster"),
}


class TaughtOrder:
    """Sort key of a file of one section; sphinx-gallery makes one for each folder and calls it with each name."""

    def __init__(self, folder: Any) -> None:
        self.order = ORDER.get(Path(folder).name, ())

    def __call__(self, name: str) -> tuple[int, str]:
        stem = Path(name).stem.removeprefix("plot_")
        return (self.order.index(stem) if stem in self.order else len(self.order), stem)

    def __repr__(self) -> str:
        return "TaughtOrder"
