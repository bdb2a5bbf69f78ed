"""Results that are stored on their owner."""

import gc
import pickle
import weakref
from dataclasses import dataclass, replace

import pytest

import manipplan as mp
from manipplan.support.memo import once_per_owner, once_per_pair, state_without_memo


@dataclass(frozen=True)
class Owner:
    value: int
    __getstate__ = state_without_memo


@pytest.fixture
def counted():
    """A function that is stored per owner, and the arguments of its calls."""
    calls = []

    @once_per_owner
    def scaled(owner, factor=1, *, plus=0):
        """Doubles as a check that the docstring stays."""
        calls.append((factor, plus))
        return owner.value * factor + plus

    return scaled, calls


def test_each_set_of_arguments_is_computed_once(counted):
    scaled, calls = counted
    owner = Owner(3)
    assert [scaled(owner), scaled(owner), scaled(owner, 2), scaled(owner, 2, plus=1), scaled(owner, 2)] == [3, 3, 6, 7, 6]
    assert calls == [(1, 0), (2, 0), (2, 1)]
    assert "docstring" in scaled.__doc__


def test_equal_owners_share_nothing(counted):
    scaled, calls = counted
    assert scaled(Owner(3)) == scaled(Owner(3)) == 3
    assert len(calls) == 2


@pytest.mark.parametrize("copied", [lambda owner: pickle.loads(pickle.dumps(owner)), lambda owner: replace(owner, value=5)])
def test_copies_start_without_results(counted, copied):
    scaled, calls = counted
    owner = Owner(3)
    scaled(owner)
    other = copied(owner)
    assert vars(other).keys() == {"value"}
    assert scaled(other) == other.value
    assert len(calls) == 2


def test_a_failure_is_not_stored():
    answers = iter([ValueError("not yet"), 4])

    @once_per_owner
    def moody(owner):
        answer = next(answers)
        if isinstance(answer, Exception):
            raise answer
        return answer

    owner = Owner(1)
    with pytest.raises(ValueError, match="not yet"):
        moody(owner)
    assert moody(owner) == 4


def test_arguments_that_cannot_be_stored_are_refused(counted):
    scaled, _ = counted
    with pytest.raises(TypeError, match="unhashable"):
        scaled(Owner(3), [2])


@pytest.mark.slow
def test_a_pair_s_result_lives_as_long_as_both():
    """The result may refer to its owner."""

    @dataclass(eq=False)
    class Made:
        owner: object

    calls = []

    @once_per_pair
    def made(owner, other):
        calls.append(other)
        return Made(owner)

    first, second, other = (mp.Scene() for _ in range(3))
    assert made(first, other) is made(first, other) is not made(second, other)
    assert len(calls) == 2
    calls.clear()
    left = weakref.ref(made(first, other)), weakref.ref(made(second, other))
    del first
    gc.collect()
    assert left[0]() is None and left[1]() is not None
    del other
    gc.collect()
    assert left[1]() is None


@pytest.mark.slow
def test_scenes_and_robots_that_are_gone_leave_no_collision_models():
    robot, scene = mp.planar_arm([1.0, 1.0]), mp.Scene([mp.Sphere(radius=0.1, position=(3.0, 0.0, 0.0))])
    carrying = [robot.attach(mp.Sphere(radius=0.1), name="part") for _ in range(3)]
    scenes = [mp.Scene([mp.Sphere(radius=0.1, position=(0.0, 3.0, 0.0))]) for _ in range(3)]
    pairs = [*((each, scene) for each in carrying), *((robot, each) for each in scenes)]
    models = [weakref.ref(world.collision_model(arm)) for arm, world in pairs]
    kept = scene.collision_model(robot)
    assert all(mp.plan(arm, [0.0, 1.0], [0.5, 0.5], world).status.has_path for arm, world in pairs[2:4])
    del carrying, scenes, pairs
    gc.collect()
    assert [each() for each in models] == [None] * 6
    assert scene.collision_model(robot) is kept
