"""Linear algebra of a plan runs on one thread, and on as many as before after it, whatever ends first."""

import threading

import pytest
from threadpoolctl import threadpool_info, threadpool_limits

import manipplan as mp
from manipplan.support.processes.one_thread import one_thread


def threads():
    return {each["num_threads"] for each in threadpool_info() if each["user_api"] == "blas"}


@pytest.fixture
def two():
    """The numbers of threads of BLAS: two, or one where an environment variable forbids more."""
    limits = threadpool_limits(limits=2, user_api="blas")  # a with-block would forbid other threads to set the number
    yield threads()
    limits.restore_original_limits()


def test_blocks_limit_the_threads_until_the_last_one_ends(two):
    entered, leave = threading.Event(), threading.Event()

    def other():
        with one_thread():
            entered.set()
            leave.wait(10)

    worker = threading.Thread(target=other)
    with pytest.raises(ZeroDivisionError), one_thread():
        assert threads() == {1}
        worker.start()
        entered.wait(10)
        raise ZeroDivisionError
    assert threads() == {1}, "the other thread's block is open"
    leave.set()
    worker.join()
    assert threads() == two


def test_a_plan_uses_one_thread(planar, two):
    seen = []
    mp.plan(planar, [0.0, 1.5, -2.0], [0.5, 1.0, -1.5], progress=lambda _share, _text: seen.append(threads()))
    assert seen and all(each == {1} for each in seen)
    assert threads() == two
