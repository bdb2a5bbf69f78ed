"""A judge of robots that shares nothing with the package: Pinocchio and coal on the original URDF.

Parent and child link of one joint are adjacent and no others. Links that touch at nearly all postures touch by construction.
"""

import xml.etree.ElementTree as ET
from collections import defaultdict
from dataclasses import dataclass
from itertools import combinations
from pathlib import Path

import numpy as np
import pinocchio as pin

import manipplan as mp

#: Links that touch in this share of the judge's postures touch by construction; near it a verdict is not compared.
ALWAYS, NEAR = 0.95, 0.04


@dataclass(frozen=True, kw_only=True)
class Verdicts:
    """What the judge finds at each posture: the links that touch, and how near the nearest of the others are [m]."""

    touching: list[set[frozenset[str]]]
    always: set[frozenset[str]]
    unclear: set[frozenset[str]]


class Judge:
    """Pinocchio and coal on the original file."""

    def __init__(self, file: Path, robot: mp.Robot) -> None:
        self.model = pin.buildModelFromUrdf(str(file))
        folders = [str(each) for each in file.parents]
        self.geometry = pin.buildGeomFromUrdf(self.model, str(file), pin.GeometryType.COLLISION, package_dirs=folders)
        joined = set()
        for joint in ET.parse(file).getroot().findall("joint"):
            joined.add(frozenset((joint.find("parent").get("link"), joint.find("child").get("link"))))
        self.neutral = pin.neutral(self.model)
        for name, value in robot.locked.items():
            joint = self.model.joints[self.model.getJointId(name)]
            self.neutral[joint.idx_q : joint.idx_q + joint.nq] = value if joint.nq == 1 else (np.cos(value), np.sin(value))
        active = set(robot.joint_names)
        self.links = []
        for i, j in combinations(range(self.geometry.ngeoms), 2):
            first, second = self.geometry.geometryObjects[i], self.geometry.geometryObjects[j]
            names = frozenset(self.model.frames[each.parentFrame].name for each in (first, second))
            moved = set(self.model.supports[first.parentJoint]) ^ set(self.model.supports[second.parentJoint])
            if len(names) == 2 and names not in joined and {self.model.names[k] for k in moved} & active:
                self.geometry.addCollisionPair(pin.CollisionPair(i, j))
                self.links.append(names)
        self.indices = [self.model.joints[self.model.getJointId(name)] for name in robot.joint_names]
        self.data, self.geometry_data = self.model.createData(), pin.GeometryData(self.geometry)

    def whole(self, q: np.ndarray) -> np.ndarray:
        """All numbers of Pinocchio for the active joints (n,); it has the cosine and the sine of a continuous joint."""
        whole = self.neutral.copy()
        for joint, value in zip(self.indices, q, strict=True):
            whole[joint.idx_q : joint.idx_q + joint.nq] = value if joint.nq == 1 else (np.cos(value), np.sin(value))
        return whole

    def pose_and_jacobian(self, q: np.ndarray, frame: str) -> tuple[np.ndarray, np.ndarray]:
        """Pose (4, 4) of a frame, and its Jacobian (6, n) with linear rows first, along the axes of the world."""
        index = (
            self.model.getFrameId(frame, pin.BODY) if self.model.existFrame(frame, pin.BODY) else self.model.getFrameId(frame)
        )
        jacobian = pin.computeFrameJacobian(self.model, self.data, self.whole(q), index, pin.LOCAL_WORLD_ALIGNED)
        pin.framesForwardKinematics(self.model, self.data, self.whole(q))
        return self.data.oMf[index].homogeneous.copy(), jacobian[:, [joint.idx_v for joint in self.indices]]

    def place(self, q: np.ndarray) -> None:
        """Place all bodies at q (n,)."""
        pin.updateGeometryPlacements(self.model, self.data, self.geometry, self.geometry_data, self.whole(q))

    def verdicts(self, postures: np.ndarray) -> Verdicts:
        """Which links touch at each posture (m, n)."""
        touching = []
        for q in postures:
            self.place(q)
            pin.computeCollisions(self.geometry, self.geometry_data, False)
            hits = [result.isCollision() for result in self.geometry_data.collisionResults]
            touching.append({names for names, hit in zip(self.links, hits, strict=True) if hit})
        counts = defaultdict(int)
        for each in touching:
            for names in each:
                counts[names] += 1
        share = {names: count / len(postures) for names, count in counts.items()}
        always = {names for names, value in share.items() if value >= ALWAYS}
        return Verdicts(
            touching=touching, always=always, unclear={names for names, value in share.items() if abs(value - ALWAYS) < NEAR}
        )

    def least(self, q: np.ndarray, left_out: set[frozenset[str]]) -> float:
        """The smallest distance at a posture of links that are not left out [m]."""
        self.place(q)
        pin.computeDistances(self.geometry, self.geometry_data)
        found = [
            result.min_distance
            for names, result in zip(self.links, self.geometry_data.distanceResults, strict=True)
            if names not in left_out
        ]
        return min(found, default=np.inf)
