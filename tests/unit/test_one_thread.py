"""Linear algebra of a plan runs on one thread, and on as many as before after it."""

import threading

import pytest
import scipy.linalg  # noqa: F401 - brings its own BLAS, which a plan would load otherwise
from threadpoolctl import threadpool_info, threadpool_limits

import manipplan as mp
from manipplan.support.workers import one_thread


def threads():
    return {each["num_threads"] for each in threadpool_info() if each["user_api"] == "blas"}


@pytest.fixture
def two():
    """The numbers of threads of BLAS: two, or one where an environment variable forbids more."""
    with threadpool_limits(limits=2, user_api="blas"):
        yield threads()


def test_blocks_limit_the_threads_until_they_end(two):
    with pytest.raises(ZeroDivisionError), one_thread():
        with one_thread():
            assert threads() == {1}
        assert threads() == {1}
        raise ZeroDivisionError
    assert threads() == two


def test_blocks_of_several_threads_leave_the_number_as_it_was(two):
    several = threading.Barrier(4)

    def work():
        several.wait(10)
        for _ in range(20):
            with one_thread():
                pass

    workers = [threading.Thread(target=work) for _ in range(3)]
    for worker in workers:
        worker.start()
    several.wait(10)
    for worker in workers:
        worker.join()
    assert threads() == two


def test_a_plan_uses_one_thread(planar, two):
    seen = []
    mp.plan(planar, [0.0, 1.5, -2.0], [0.5, 1.0, -1.5], progress=lambda _share, _text: seen.append(threads()))
    assert seen and all(each == {1} for each in seen)
    assert threads() == two
