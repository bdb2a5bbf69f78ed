"""Worker processes: results, errors, deaths, the end, and one thread of linear algebra each."""

import os
import signal
import subprocess
import sys
import threading
import time
from concurrent.futures import CancelledError, wait
from pathlib import Path

import pytest

import manipplan as mp
from manipplan.support.workers import THREADS, WorkerLostError, Workers


def square(x, *, plus=0):
    return x * x + plus


def fail(text):
    raise ValueError(text)


def die(code=None):
    if code is None:
        os.kill(os.getpid(), signal.SIGKILL)
    os._exit(code)


def threads():
    return [os.environ[name] for name in THREADS]


class Unloadable:
    def __reduce__(self):
        return fail, ("cannot be loaded",)


class UnpicklableError(Exception):
    def __init__(self):
        super().__init__()
        self.lock = threading.Lock()


def raise_unpicklable():
    raise UnpicklableError


@pytest.fixture(scope="module")
def workers():
    with Workers(2) as made:
        yield made


@pytest.mark.slow
def test_results_belong_to_their_call(workers):
    futures = [workers.submit(square, x, plus=1) for x in range(20)]
    assert [future.result() for future in futures] == [x * x + 1 for x in range(20)]


@pytest.mark.slow
def test_errors_are_those_of_the_work(workers):
    with pytest.raises(ValueError, match="no luck"):
        workers.submit(fail, "no luck").result()
    with pytest.raises(ValueError, match="cannot be loaded"):
        workers.submit(square, Unloadable()).result()
    with pytest.raises(RuntimeError, match="UnpicklableError"):
        workers.submit(raise_unpicklable).result()
    with pytest.raises((AttributeError, TypeError), match="pickle"):
        workers.submit(square, threading.Lock()).result()
    assert workers.submit(square, 3).result() == 9


@pytest.mark.slow
@pytest.mark.parametrize(("code", "message"), [(None, r"signal 9, Killed"), (3, "exit code 3")])
def test_only_the_work_of_a_dead_process_is_lost(workers, code, message):
    first = [workers.submit(square, x) for x in range(4)]
    lost = workers.submit(die, code)
    after = [workers.submit(square, x) for x in range(4)]
    with pytest.raises(WorkerLostError, match=message) as caught:
        lost.result()
    assert caught.value.started
    assert [each.result() for each in (*first, *after)] == [0, 1, 4, 9] * 2


@pytest.mark.slow
def test_each_process_has_one_thread_and_the_callers_environment_stays(workers, monkeypatch):
    monkeypatch.setenv(THREADS[0], "7")
    monkeypatch.delenv(THREADS[-1], raising=False)
    with Workers(1) as one:
        assert one.submit(threads).result() == ["1"] * len(THREADS)
    assert os.environ[THREADS[0]] == "7" and THREADS[-1] not in os.environ


def is_running(pid):
    """Whether a process runs; one that ended, but that nobody asked for its exit code, does not."""
    try:
        os.kill(pid, 0)
        return Path(f"/proc/{pid}/stat").read_text().split()[2] != "Z"
    except (ProcessLookupError, FileNotFoundError):
        return False


@pytest.mark.slow
def test_processes_end_with_the_block():
    with Workers(1) as one:
        future = one.submit(os.getpid)
    assert future.result() != os.getpid()
    assert not is_running(future.result())
    with pytest.raises(RuntimeError, match="shut down"):
        one.submit(square, 1)


@pytest.mark.slow
def test_an_error_in_the_block_ends_work_at_once():
    began = time.monotonic()
    with pytest.raises(KeyboardInterrupt), Workers(1) as one:
        running, queued = one.submit(time.sleep, 60), one.submit(square, 2)
        while not running.running():
            time.sleep(0.01)
        raise KeyboardInterrupt
    wait([running, queued], timeout=20)
    assert time.monotonic() - began < 30
    with pytest.raises(WorkerLostError):
        running.result(timeout=0)
    with pytest.raises(CancelledError):
        queued.result(timeout=0)


@pytest.mark.slow
def test_processes_do_not_react_to_ctrl_c(workers):
    pid = workers.submit(os.getpid).result()
    assert os.getpgid(pid) != os.getpgid(0)  # a terminal interrupts the group of the caller
    assert [workers.submit(square, x).result() for x in range(4)] == [0, 1, 4, 9]
    assert is_running(pid)


@pytest.mark.slow
def test_processes_end_with_a_caller_that_is_killed(tmp_path):
    program = tmp_path / "program.py"
    program.write_text(
        "import os, time\nfrom manipplan.support.workers import Workers\n"
        "if __name__ == '__main__':\n    workers = Workers(1)\n"
        "    print(workers.submit(os.getpid).result(), flush=True)\n    time.sleep(60)\n"
    )
    environment = {**os.environ, "PYTHONPATH": str(Path(mp.__file__).parents[1])}
    with subprocess.Popen([sys.executable, program], env=environment, stdout=subprocess.PIPE, text=True) as caller:
        pid = int(caller.stdout.readline())
        caller.kill()
    ends = time.monotonic() + 10
    while is_running(pid) and time.monotonic() < ends:
        time.sleep(0.05)
    assert not is_running(pid)


def outcome(program, tmp_path):
    """What a program prints; from standard input for a program that is not a file."""
    environment = {**os.environ, "PYTHONPATH": str(Path(mp.__file__).parents[1])}
    command, text = [sys.executable, "-"], program
    if tmp_path is not None:
        (tmp_path / "program.py").write_text(program)
        command, text = [sys.executable, tmp_path / "program.py"], None
    done = subprocess.run(command, input=text, env=environment, capture_output=True, text=True, timeout=100, check=False)
    return done.stdout + done.stderr


USE = "from manipplan.support.workers import Workers\nprint('read')\n"


@pytest.mark.slow
@pytest.mark.parametrize("file", [False, True])
def test_a_program_without_a_guard_runs_once(tmp_path, file):
    program = USE + "with Workers(1) as one: print(one.submit(pow, 2, 3).result())\n"
    assert outcome(program, tmp_path if file else None).split() == ["read", "8"]


@pytest.mark.slow
def test_functions_and_classes_of_a_program_are_found(tmp_path):
    program = USE + (
        "class Own:\n    def __init__(self, x): self.x = x\n"
        "def twice(own): return Own(2 * own.x)\n"
        "if __name__ == '__main__':\n    with Workers(1) as one: print(one.submit(twice, Own(4)).result().x)\n"
    )
    assert sorted(outcome(program, tmp_path).split()) == ["8", "read", "read"]
    assert "Can't get attribute 'twice' on <module '__main__'" in outcome(program, None)
    unguarded = program.replace("if __name__ == '__main__':", "if True:")
    assert "workers cannot start workers: the program needs the line if __name__" in outcome(unguarded, tmp_path)


def speak():
    print("to standard output")
    os.write(1, b"and past Python\n")
    return "result"


@pytest.mark.slow
def test_what_work_prints_does_not_get_among_the_results(workers):
    assert workers.submit(speak).result() == "result"


def test_a_process_that_does_not_start_is_told(monkeypatch):
    monkeypatch.setattr("manipplan.support.workers.BEGIN", "import sys; sys.exit(5)")
    with Workers(1) as one, pytest.raises(WorkerLostError, match="exit code 5") as caught:
        one.submit(square, 2).result()
    assert not caught.value.started


@pytest.mark.slow
def test_a_wrong_count_is_told():
    with pytest.raises(mp.errors.InvalidInputError, match="count: got 0"):
        Workers(0)
