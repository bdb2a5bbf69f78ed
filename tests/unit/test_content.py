"""Keys of content: equal for equal memo, in every process, and different for any other."""

import os
import pickle
import subprocess
import sys
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
import pytest

import manipplan as mp
from manipplan.jobs.plan_many import Problem, checked, problem_key, robot_key, scene_key
from manipplan.support import memo
from manipplan.support.memo import code_key, content_key

TRIANGLES = np.array([[[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 0, 0], [0, 1, 0], [0, 0, 1]]], dtype=float)
#: A program that prints keys of things whose pickles differ from process to process.
PROGRAM = """
import manipplan as mp
from manipplan.jobs.plan_many import robot_key, scene_key
from manipplan.support.memo import content_key
scene = mp.Scene([mp.Box(size=(1, 1, 1), name=name) for name in "abcdef"], allowed=[(a, b) for a in "abc" for b in "def"])
print(content_key(frozenset("abcdefgh")), scene_key(scene), robot_key(mp.load_robot("panda")))
"""


@dataclass(frozen=True)
class Pair:
    first: object
    second: object


class Plain:
    def __init__(self, value):
        self.value = value


#: No two of them are the same, though some are equal to one another in Python.
DIFFERENT = [
    None, True, 1, 1.0, 1.5, "1", b"1", (1,), [1], [2], {1}, {2}, {1: 2}, {2: 1}, np.arange(3), np.arange(3.0), np.zeros((3, 1)),
    Path("1"), mp.Status.OPTIMAL, mp.Status.SINGULAR, mp.Status, Pair(1, 2), Pair(2, 1), Plain(1), Plain(2), content_key, len,
]  # fmt: skip


def test_content_decides():
    keys = [content_key(value) for value in DIFFERENT]
    assert len(set(keys)) == len(keys)
    assert keys == [content_key(pickle.loads(pickle.dumps(value))) for value in DIFFERENT]
    assert content_key(np.float64(1.5)) == content_key(1.5)


def test_parts_cannot_be_shifted_into_one_another():
    assert content_key(["ab", "c"]) != content_key(["a", "bc"])
    assert content_key([["a"], "b"]) != content_key([["a", "b"]])


def test_order_counts_where_it_has_a_meaning():
    assert content_key({"a": 1, "b": 2}) == content_key({"b": 2, "a": 1})
    assert content_key([1, 2]) != content_key([2, 1])


@pytest.mark.slow
def test_keys_are_the_same_in_every_process():
    found = set()
    for seed in ("1", "2"):
        environment = {**os.environ, "PYTHONHASHSEED": seed, "PYTHONPATH": str(Path(mp.__file__).parents[1])}
        done = subprocess.run([sys.executable, "-c", PROGRAM], env=environment, capture_output=True, text=True, check=True)
        found.add(done.stdout)
    assert len(found) == 1


@pytest.mark.slow
def test_work_with_a_robot_does_not_change_its_key(panda):
    robot = mp.load_robot("panda")
    before = robot_key(robot)
    scene = mp.Scene([mp.Box(size=(0.1, 0.1, 0.1), position=(0.5, 0.5, 0.0))])
    scene.distances(robot, robot.neutral)
    again = pickle.loads(pickle.dumps(robot))
    scene.distances(again, robot.neutral)
    assert robot_key(again) == before == robot_key(panda)


def changed_robots(panda):
    yield panda.with_limits(velocity=1.0)
    yield panda.with_tool(np.eye(4), name="tcp")
    yield panda.at([[1, 0, 0, 0.1], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]])
    yield panda.attach(mp.Sphere(radius=0.02), name="part")
    yield mp.load_robot("panda", locked={"panda_finger_joint1": 0.02})
    yield replace(panda, disabled_pairs=frozenset())
    heavier = panda.model.copy()
    heavier.inertias[3].mass *= 1.01
    yield replace(panda, model=heavier)


@pytest.mark.slow
def test_another_robot_has_another_key(panda):
    keys = [robot_key(robot) for robot in (panda, *changed_robots(panda))]
    assert len(set(keys)) == len(keys)


def test_another_scene_has_another_key(tmp_path):
    points = np.random.default_rng(0).normal(size=(50, 3))
    scenes = [
        mp.Scene(),
        mp.Scene([mp.Mesh(triangles=TRIANGLES)]),
        mp.Scene([mp.Mesh(triangles=TRIANGLES * 1.001)]),
        mp.Scene([mp.Mesh(triangles=TRIANGLES, name="mesh")]),
        mp.Scene([mp.Mesh(triangles=TRIANGLES, fill=None, position=(0, 0, 0.1))]),
        mp.Scene([mp.PointCloud(points=points, radius=0.01)]),
        mp.Scene([mp.PointCloud(points=points + 1e-9, radius=0.01)]),
        mp.Scene([mp.Box(size=(1, 1, 1), name="a"), mp.Box(size=(1, 1, 1), name="b")]),
        mp.Scene([mp.Box(size=(1, 1, 1), name="a"), mp.Box(size=(1, 1, 1), name="b")], allowed=[("a", "link")]),
    ]
    keys = [scene_key(scene) for scene in scenes]
    assert len(set(keys)) == len(keys)
    assert keys == [scene_key(pickle.loads(pickle.dumps(scene))) for scene in scenes]


def test_a_mesh_file_counts_by_its_triangles(tmp_path):
    def scene(height):
        (tmp_path / "part.obj").write_text(f"v 0 0 0\nv 1 0 0\nv 0 1 {height}\nf 1 2 3\n")
        return mp.Scene([mp.Mesh(file=tmp_path / "part.obj")])

    assert scene_key(scene(0)) == scene_key(scene(0)) != scene_key(scene(1))


def test_another_problem_has_another_key(planar):
    base = {"robot": planar, "start": [0.0, 1.5, -2.0], "goal": [1.0, 1.0, -1.0]}
    changes = [
        {},
        {"start": [0.0, 1.5, -2.000001]},
        {"goal": [1.0, 1.0, -1.000001]},
        {"scene": mp.Scene([mp.Sphere(radius=0.1, position=(5, 5, 5))])},
        {"objective": mp.PathObjective(power=2.0)},
        {"objective": mp.PathObjective(measure="isotropy")},
        {"shape": mp.PathShape(degree=5)},
        {"seeding": mp.Seeding(seed=1)},
        {"seeding": mp.Seeding(initial=mp.JointPath.line([0.0, 1.5, -2.0], [1.0, 1.0, -1.0]))},
        {"clearance": 0.01},
        {"torque": True},
    ]
    keys = [problem_key(checked("problem", Problem(**base | change))) for change in changes]
    assert len(set(keys)) == len(keys)
    same = [
        {"name": "other"},
        {"scene": mp.Scene()},
        {"start": np.array([0.0, 1.5, -2.0])},
        {"robot": mp.planar_arm([1.0] * 3)},
    ]
    assert {problem_key(checked("problem", Problem(**base | change))) for change in same} == {keys[0]}


def test_the_key_of_the_code_is_that_of_its_files(tmp_path, monkeypatch):
    """It changes with a line of any file that a result can depend on, and with a file's name, not with the viewer."""
    for file, text in {"a.py": "1", "b/c.c": "2", "viz/d.py": "3", "notes.txt": "4"}.items():
        (tmp_path / file).parent.mkdir(exist_ok=True)
        (tmp_path / file).write_text(text)
    monkeypatch.setattr(memo, "PACKAGE", tmp_path)
    keys = []
    for file, text in (("a.py", "1"), ("a.py", "5"), ("b/c.c", "6"), ("viz/d.py", "7"), ("notes.txt", "8")):
        (tmp_path / file).write_text(text)
        keys.append(code_key.__wrapped__())
    (tmp_path / "a.py").rename(tmp_path / "e.py")
    keys.append(code_key.__wrapped__())
    assert keys[2] == keys[3] == keys[4] and len(set(keys)) == 4
