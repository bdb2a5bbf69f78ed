"""Results that are stored on their owner."""

import pickle
from dataclasses import dataclass, replace

import pytest

from manipplan.support.memo import once_per_owner, state_without_memo


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
