"""The loaders of the package: valid files for each, how they are edited, and the call that reads one."""

import hashlib
import json
import random
import sys
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pinocchio as pin
import yaml
from fuzz import samples
from fuzz.text_edits import edit_bytes, edit_encoding, edit_lines, edit_words
from fuzz.tree_edits import edit_value, edit_xml

import manipplan as mp

#: Longest file [bytes], and edits of any file; some twice or three times, since they are more often of use.
LARGEST = 500_000
#: Limit of recursion while deeply nested trees are edited and written; they are read with the usual one.
DEEPEST = 20_000
EDITS = (*(edit_bytes,) * 2, *(edit_words,) * 3, *(edit_lines,) * 2, edit_encoding)


@dataclass(frozen=True, kw_only=True)
class Sample:
    """A valid file, and the files that it needs beside it."""

    name: str
    data: bytes
    beside: Mapping[str, bytes] = field(default_factory=dict)

    def edited(self, rng: random.Random) -> bytes:
        """The file after one to five edits; the edits of trees come first, since later ones may leave no tree."""
        count = rng.choice((1, 1, 1, 1, 2, 2, 3, 5))
        data = self.data
        if rng.random() < 0.7:
            data = self._edited_tree(rng, data, count)
            count = rng.choice((0, 0, 0, 0, 1)) if data != self.data else count
        for _ in range(count):
            data = rng.choice(EDITS)(rng, data)
        return data if len(data) < LARGEST else self.edited(rng)

    def _edited_tree(self, rng: random.Random, data: bytes, count: int) -> bytes:
        kind = Path(self.name).suffix
        if kind in (".urdf", ".srdf", ".xml", ".dae"):
            for _ in range(count):
                data = edit_xml(rng, data)
        elif kind in (".yaml", ".json"):
            value = yaml.load(data, Loader=yaml.CSafeLoader) if kind == ".yaml" else json.loads(data)
            limit = sys.getrecursionlimit()
            sys.setrecursionlimit(DEEPEST)
            try:
                for _ in range(count):
                    value = edit_value(rng, value)
                data = _dumped(rng, value) if kind == ".yaml" else _json(value)
            finally:
                sys.setrecursionlimit(limit)
        return data


@dataclass(frozen=True, kw_only=True)
class Loader:
    """A loader.

    Attributes:
        about: what it reads.
        samples: gives the valid files.
        load: reads a file; raises AssertionError if what was read cannot be used.
        limit: longest time [s] for one file.
    """

    about: str
    samples: Callable[[], list[Sample]]
    load: Callable[[Path], None]
    limit: float = 10.0
    share: float = 1.0


def _dumped(rng: random.Random, value: Any) -> bytes:
    style = rng.choice((None, True, False))
    return yaml.dump(value, Dumper=yaml.CSafeDumper, sort_keys=False, default_flow_style=style).encode()


def _json(value: Any) -> bytes:
    """JSON with the checksum of its edited values, so that a plan is read beyond it."""
    if isinstance(value, dict) and "sha256" in value:
        value = {key: each for key, each in value.items() if key != "sha256"}
        value = json.loads(json.dumps(value, default=str))
        value["sha256"] = hashlib.sha256(json.dumps(value).encode()).hexdigest()
    return json.dumps(value, default=str, skipkeys=True).encode()


def _robot(robot: mp.Robot) -> None:
    """Use a robot: its frames, limits and bodies are finite."""
    data = robot.model.createData()
    pin.framesForwardKinematics(robot.model, data, robot.neutral)
    places = [data.oMf[i] for i in range(robot.model.nframes)] + [item.placement for item in robot.geometry.geometryObjects]
    assert all(np.isfinite(place.homogeneous).all() for place in places), "a frame or body is not at a finite place"
    limits = robot.limits
    assert not np.isnan([limits.lower, limits.upper, limits.velocity, limits.effort]).any(), "a limit is NaN"
    for item in robot.geometry.geometryObjects:
        item.geometry.computeLocalAABB()
        box = item.geometry.aabb_local
        bounded = type(item.geometry).__name__ not in ("Plane", "Halfspace")
        assert not bounded or np.isfinite([box.min_, box.max_]).all(), f"the size of {item.name} is not finite"


@cache
def _arm() -> mp.Robot:
    return mp.planar_arm([0.4, 0.4, 0.4])


def _scene(scene: mp.Scene) -> None:
    """Use a scene: its distances to an arm are numbers. The time of more obstacles is not that of a loader."""
    unallowed = mp.Scene(scene.obstacles[:100])
    distances = unallowed.distances(_arm(), np.array([0.1, 0.2, 0.3]))
    assert not np.isnan(distances).any(), "a distance is NaN"


def _mesh(file: Path) -> None:
    _scene(mp.Scene([mp.Mesh(file=file)]))


def _trajectory(file: Path) -> None:
    read = {".csv": "from_csv", ".json": "from_json", ".yaml": "from_ros", ".npz": "from_npz"}[file.suffix]
    motion = getattr(mp.Trajectory, read)(file)
    motion(motion.duration)


def _trajectory_of(plan: mp.Plan) -> None:
    plan.trajectory(plan.trajectory.duration)


def _srdf(file: Path) -> None:
    _robot(mp.Robot.from_urdf(file.parent / "arm.urdf", srdf=file))


WEDGE = {"wedge.stl": samples.meshes()["wedge.stl"]}
LOADERS = {
    "urdf": Loader(
        about="`Robot.from_urdf`",
        samples=lambda: [Sample(name="arm.urdf", data=samples.urdf("wedge.stl"), beside=WEDGE)],
        load=lambda file: _robot(mp.Robot.from_urdf(file, tool="tip")),
    ),
    "urdf_mesh": Loader(
        about="meshes of `Robot.from_urdf`",
        samples=lambda: [
            Sample(name=name, data=data, beside={"arm.urdf": samples.urdf(name)}) for name, data in samples.meshes().items()
        ],
        load=lambda file: _robot(mp.Robot.from_urdf(_urdf_for(file), tool="tip")),
    ),
    "srdf": Loader(
        about="`Robot.from_urdf(srdf=)`",
        samples=lambda: [
            Sample(name="arm.srdf", data=samples.SRDF.encode(), beside={"arm.urdf": samples.urdf("wedge.stl"), **WEDGE})
        ],
        load=_srdf,
    ),
    "mjcf": Loader(
        about="`Robot.from_mjcf`",
        samples=lambda: [Sample(name="arm.xml", data=samples.MJCF.encode(), beside=WEDGE)],
        load=lambda file: _robot(mp.Robot.from_mjcf(file, tool="c", velocity=1.0)),
        share=0.1,
    ),
    "mjcf_scene": Loader(
        about="`Scene.from_mjcf`",
        samples=lambda: [Sample(name="cell.xml", data=samples.CELL.encode(), beside=WEDGE)],
        load=lambda file: _scene(mp.Scene.from_mjcf(file)),
        share=0.1,
    ),
    "mjcf_mesh": Loader(
        about="meshes of `Scene.from_mjcf`",
        samples=lambda: [
            Sample(
                name=name, data=samples.meshes()[name], beside={"cell.xml": samples.CELL.replace("wedge.stl", name).encode()}
            )
            for name in ("wedge.stl", "wedge.obj")
        ],
        load=lambda file: _scene(mp.Scene.from_mjcf(file.parent / "cell.xml")),
        share=0.1,
    ),
    "scene_yaml": Loader(
        about="`Scene.from_yaml`",
        samples=lambda: [Sample(name="scene.yaml", data=samples.SCENE.encode(), beside=WEDGE)],
        load=lambda file: _scene(mp.Scene.from_yaml(file)),
    ),
    "moveit_text": Loader(
        about="`Scene.from_moveit`, .scene",
        samples=lambda: [Sample(name="cell.scene", data=samples.MOVEIT_TEXT.encode())],
        load=lambda file: _scene(mp.Scene.from_moveit(file)),
    ),
    "moveit_yaml": Loader(
        about="`Scene.from_moveit`, .yaml",
        samples=lambda: [Sample(name="cell.yaml", data=samples.MOVEIT_YAML.encode(), beside=WEDGE)],
        load=lambda file: _scene(mp.Scene.from_moveit(file)),
    ),
    "mesh": Loader(
        about="`Mesh(file=)`",
        samples=lambda: [Sample(name=name, data=data) for name, data in samples.meshes().items()],
        load=_mesh,
    ),
    "trajectory": Loader(
        about="`Trajectory.from_csv`, `from_json`, `from_ros`, `from_npz`",
        samples=lambda: [Sample(name=name, data=data) for name, data in samples.trajectories().items()],
        load=_trajectory,
    ),
    "plan": Loader(
        about="`Plan.load`",
        samples=lambda: [Sample(name="plan.json", data=samples.plan())],
        load=lambda file: _trajectory_of(mp.Plan.load(file)),
    ),
}


def _urdf_for(mesh: Path) -> Path:
    return mesh.parent / "arm.urdf"
