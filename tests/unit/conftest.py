"""A hand, a cell and a program that several modules of tests use."""

import pytest
from program_cell import pose_at

import manipplan as mp


@pytest.fixture(scope="session")
def hand():
    """A Panda whose hand is open."""
    return mp.load_robot("panda", locked={"panda_finger_joint1": 0.04, "panda_finger_joint2": 0.04})


@pytest.fixture(scope="session")
def cell():
    """A table with a post and a part."""
    return mp.Scene(
        [
            mp.Box(size=(0.9, 1.6, 0.04), position=(0.6, 0.0, -0.02), name="table"),
            mp.Box(size=(0.1, 0.1, 0.3), position=(0.45, 0.0, 0.15), name="post"),
            mp.Box(size=(0.04, 0.04, 0.1), position=(0.45, 0.3, 0.051), name="part"),
        ]
    ).allow("part", "table")


@pytest.fixture(scope="session")
def steps():
    return [
        mp.MoveTo(pose_at(0.45, 0.3, 0.09), approach=0.1),
        mp.Attach("part"),
        mp.MoveAlong([0, 0, -0.1]),
        mp.MoveTo([pose_at(0.45, -0.3, 0.09), pose_at(0.45, -0.3, 0.09, 1.57)], approach=0.1),
        mp.Detach("part"),
        mp.MoveAlong([0, 0, -0.1]),
        mp.Wait(0.5),
        mp.MoveTo("default"),
    ]


@pytest.fixture(scope="session")
def program(hand, cell, steps):
    return mp.sequence(hand, "default", steps, cell, blend=0.05)
