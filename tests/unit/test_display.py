"""Every public value has a `repr` of one line, and some have a picture for notebooks."""

import base64
from html.parser import HTMLParser

import numpy as np
import pytest

import manipplan as mp
from manipplan.support.display import LONGEST, short


@pytest.fixture(scope="module")
def values(planar, panda):
    """Values of the public classes with large fields."""
    scene = mp.Scene([mp.Box(size=(0.1, 0.1, 0.6), position=(0.45, 0.0, 0.3), name="post")])
    path = mp.JointPath.through([[0.0, 1.5, -2.0], [1.0, 1.0, -1.0], [2.0, 1.0, 1.0]])
    result = mp.optimize_path(planar, path.start, path.goal)
    plan = mp.plan(planar, path.start, path.goal)
    tool = planar.kinematics(mp.Task.planar()).pose
    line = mp.CartesianPath.line(tool([0.0, 1.5, -2.0]), tool([0.1, 1.4, -1.8]))
    drive = mp.formulations.LogDrive()
    layers = mp.Layers.from_arrays([np.zeros((2, 3)), np.zeros((3, 3))], [np.ones(2), np.ones(3)])
    return [
        *(panda, panda.limits, panda.kinematics(), scene, mp.Task.pose(), path, result, result.certificate),
        *(plan, plan.report, plan.trajectory, line, layers, mp.max_min_search(layers, 0.1)),
        mp.track(planar, line, [0.0, 1.5, -2.0], drive, dt=0.01, duration=0.1, compiled=False),
        mp.Controller(planar, drive, dt=0.01, compiled=False),
        mp.inverse_kinematics(panda, panda.kinematics().pose(panda.neutral), samples=3),
        *(mp.Seeding(initial=path), mp.PathObjective(metric=np.eye(3)), mp.PathShape(start_slope=[0.0, 0.0, 0.0])),
        mp.path_cost(path, planar.kinematics(), 1.0),
        mp.measures.velocity_ellipsoid(planar.kinematics().jacobian([0.0, 1.0, 1.0])),
        scene.path_clearance(panda, mp.JointPath.line(panda.neutral, panda.neutral + 0.1)),
    ]


def test_a_repr_is_one_short_line(values):
    for value in values:
        text = repr(value)
        assert "\n" not in text, text
        assert text.startswith(type(value).__name__)
        assert len(text) <= LONGEST, text


def test_a_repr_tells_what_the_value_is(panda):
    assert repr(panda) == "Robot('panda', joints=7, tool='panda_hand_tcp')"
    assert repr(mp.Seeding()) == "Seeding(planner='auto', seed=0, count=1, time_limit=10, shifts='none')"
    assert repr(mp.JointPath.line([0.0, 1.0], [2.0, 1.0])) == "JointPath(breaks=[0, 1], control=<1 x 2 x 2 array>)"


@pytest.mark.parametrize(
    ("value", "text"),
    [
        (1.23456789, "1.235"),
        (np.float64(0.1), "0.1"),
        (True, "True"),
        (np.zeros((3, 2)), "<3 x 2 array>"),
        (np.array([1.0, 2.5]), "[1, 2.5]"),
        (np.arange(100.0), "<100 array>"),
        ("x" * 100, repr("x" * 37 + "...")),
        (("a", "b"), "('a', 'b')"),
        (tuple(range(50)), "<50 entries>"),
        ({"a": 1}, "<1 entries>"),
        (mp.Status.OPTIMAL, "OPTIMAL"),
    ],
)
def test_short_texts(value, text):
    assert short(value) == text


class Page(HTMLParser):
    """Names of all elements of a page, and the first picture in it."""

    def __init__(self, text):
        super().__init__()
        self.names, self.picture = [], b""
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        self.names.append(tag)
        if tag == "img":
            self.picture = base64.b64decode(dict(attributes)["src"].removeprefix("data:image/png;base64,"))


@pytest.mark.slow
def test_notebooks_show_pictures(planar, panda):
    scene = mp.Scene([mp.Box(size=(0.1, 0.1, 0.6), position=(0.45, 0.0, 0.3), name="post"), mp.Plane(name="floor")])
    plan = mp.plan(planar, [0.0, 1.5, -2.0], [1.0, 1.0, -1.0])
    solutions = mp.inverse_kinematics(panda, panda.kinematics().pose(panda.neutral), samples=3)
    for value in (panda, scene, plan, plan.trajectory, solutions):
        page = Page(value._repr_html_())
        assert page.names == ["pre", "img"]
        assert page.picture.startswith(b"\x89PNG")
        assert 3_000 < len(page.picture) < 300_000


@pytest.mark.slow
def test_a_plan_tells_its_figures_in_a_line_and_its_report_in_notebooks(panda):
    plan = mp.plan(panda, panda.neutral, panda.neutral + 0.1)
    assert repr(plan) == f"Plan('panda', {plan.status.name}, {plan.report.summary})" and "all checks passed" in repr(plan)
    assert "proven on the whole motion" in plan._repr_html_()
    partial = mp.results.PartialPlan(robot=panda, scene=mp.Scene(), status=mp.Status.NO_PATH, message="the wall is <thick>")
    assert repr(partial) == "PartialPlan('panda', NO_PATH, 'the wall is <thick>')"
    assert "NO_PATH: the wall is &lt;thick&gt;" in partial._repr_html_()


def test_without_a_picture_notebooks_show_the_text(panda):
    far = np.eye(4)
    far[:3, 3] = 9.0
    nothing = mp.inverse_kinematics(panda, far, samples=2)
    partial = mp.results.PartialPlan(robot=panda, scene=mp.Scene(), status=mp.Status.NO_PATH)
    for value in (nothing, partial, mp.Scene()):
        assert Page(value._repr_html_()).names == ["pre"]


def test_names_are_escaped_in_notebooks():
    scene = mp.Scene([mp.Sphere(radius=0.1, name="<script>alert(1)</script>\"'")])
    assert Page(scene._repr_html_()).names == ["pre", "img"]
