"""Workers: processes of which one may die, as an executor of `concurrent.futures`; and the threads and memory each uses.

A `ProcessPoolExecutor` cannot be used any more once one of its processes has died, and does not tell whose work killed it.
Here each process has its own pipes: only its work fails, with WorkerLostError, and another process takes its place.

A process does not read the program of its caller, as those of `multiprocessing` do, so the program needs no line
``if __name__ == "__main__":``; only for arguments of a class that the program defines.
"""

import os
import pickle
import runpy
import signal
import subprocess
import sys
import threading
from collections.abc import Callable, Iterator
from concurrent.futures import Executor, Future
from contextlib import contextmanager, suppress
from dataclasses import dataclass, field
from functools import lru_cache, partial
from pathlib import Path, PurePosixPath
from queue import Empty, SimpleQueue
from typing import IO, TYPE_CHECKING, Any, TypeVar

from manipplan.support.checks import whole_number

if TYPE_CHECKING:
    from threadpoolctl import ThreadpoolController

Result = TypeVar("Result")

#: Variables by which libraries of linear algebra learn their number of threads. With as many processes as cores, the threads of
#: one wait for those of another, and a plan takes up to twice its processor time.
THREADS = ("OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS", "MKL_NUM_THREADS", "VECLIB_MAXIMUM_THREADS")
#: What a process does first, and what it writes then.
BEGIN = """
import pickle, sys
sys.path[:], script = pickle.load(sys.stdin.buffer)
from manipplan.support import workers
workers.work(script)
"""
READY = b"ready"
#: Name of the caller's program where a worker reads it, as in `multiprocessing`.
SCRIPT = "__mp_main__"
#: Time for a process to end by itself [s].
LONGEST_END = 1.0
_is_worker = False


class WorkerLostError(Exception):
    """The process died before it returned a result. `started` is False when it died before it took its first work."""

    def __init__(self, code: int | None, started: bool) -> None:
        self.code = code
        self.started = started
        how = f"signal {-code}, {signal.strsignal(-code)}" if code is not None and code < 0 else f"exit code {code}"
        super().__init__(f"the process ended with {how}")


@dataclass(frozen=True, eq=False)
class _Work:
    call: tuple[Callable[..., Any], tuple[Any, ...], dict[str, Any]]
    future: Future[Any] = field(default_factory=Future)


class Workers(Executor):
    """A number of processes, each with one thread of linear algebra; use it as a context manager.

    A process is started when there is work for it. Functions, arguments and results are pickled. Processes do not react to
    Ctrl-C. They end with the `with` block, at once if an error or Ctrl-C ends it, and when the caller dies.

    Raises RuntimeError in a worker: a program that starts workers wherever it is read would start more and more of them.
    """

    def __init__(self, count: int) -> None:
        if _is_worker:
            raise RuntimeError(
                'workers cannot start workers: the program needs the line if __name__ == "__main__": before that'
            )
        self.count = whole_number("count", count, least=1)
        self._queue: SimpleQueue[_Work | None] = SimpleQueue()
        self._closed = self._stopped = False
        self._lock = threading.Lock()
        self._processes: set[subprocess.Popen[bytes]] = set()
        self._threads = [threading.Thread(target=self._serve, name=f"worker {k}", daemon=True) for k in range(self.count)]
        for thread in self._threads:
            thread.start()

    def submit(self, fn: Callable[..., Result], /, *args: Any, **kwargs: Any) -> Future[Result]:
        """As `concurrent.futures.Executor.submit`; the future raises WorkerLostError when its process dies."""
        if self._closed:
            raise RuntimeError("the workers were shut down")
        work = _Work((fn, args, kwargs))
        self._queue.put(work)
        return work.future

    def shutdown(self, wait: bool = True, *, cancel_futures: bool = False) -> None:
        """End the processes: after their work with `wait`, at once otherwise."""
        self._closed = True
        if cancel_futures or not wait:
            with suppress(Empty):
                while (work := self._queue.get_nowait()) is not None:
                    work.future.cancel()
        if not wait:
            with self._lock:
                self._stopped = True
                for process in self._processes:
                    process.kill()
        for _ in self._threads:
            self._queue.put(None)
        if wait:
            for thread in self._threads:
                thread.join()

    def __exit__(self, kind: object, error: object, trace: object) -> None:
        self.shutdown(wait=error is None)

    def _serve(self) -> None:
        """In a thread per process: hand on its work and its results."""
        worker: _Worker | None = None
        try:
            while (work := self._queue.get()) is not None:
                if not work.future.set_running_or_notify_cancel():
                    continue
                try:
                    if worker is None:
                        worker = _Worker()
                        with self._lock:
                            self._processes.add(worker.process)
                            if self._stopped:
                                worker.process.kill()
                    result = worker.run(work)
                except WorkerLostError as error:
                    worker = None
                    work.future.set_exception(error)
                except BaseException as error:  # of the work, or of pickling it: handed on to the caller, as executors do
                    work.future.set_exception(error)
                else:
                    work.future.set_result(result)
        finally:
            if worker is not None:
                worker.end()


class _Worker:
    """One process and our ends of its pipes."""

    def __init__(self) -> None:
        sys.modules.setdefault(SCRIPT, sys.modules["__main__"])  # results may be of its classes
        self.process = subprocess.Popen(
            [sys.executable, "-c", BEGIN],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            env={**os.environ, **dict.fromkeys(THREADS, "1")},
            process_group=0 if os.name == "posix" else None,  # Ctrl-C does not reach it
            creationflags=getattr(subprocess, "CREATE_NEW_PROCESS_GROUP", 0),
        )
        self.started = False

    def run(self, work: _Work) -> Any:
        """The result of some work, or what it raised."""
        packed = pickle.dumps(work.call)
        assert self.process.stdin is not None and self.process.stdout is not None
        try:
            if not self.started:
                pickle.dump((sys.path, _script()), self.process.stdin)
                self.process.stdin.flush()
                if _read(self.process.stdout) != READY:  # something printed before the process could keep it apart
                    raise EOFError
                self.started = True
            _write(self.process.stdin, packed)
            succeeded, result = pickle.loads(_read(self.process.stdout))
        except (EOFError, ConnectionError, OverflowError, MemoryError) as error:
            self.end()
            raise WorkerLostError(self.process.returncode, self.started) from error
        if not succeeded:
            raise result
        return result

    def end(self) -> None:
        """Wait for the process, which ends when it can read no more work."""
        assert self.process.stdin is not None and self.process.stdout is not None
        with suppress(ConnectionError):
            self.process.stdin.close()
        try:
            self.process.wait(timeout=LONGEST_END)
        except subprocess.TimeoutExpired:
            self.process.kill()
            self.process.wait()
        self.process.stdout.close()


def _script() -> str | None:
    """The file of the program that the caller runs; None for a notebook or standard input."""
    file = getattr(sys.modules["__main__"], "__file__", None)
    return file if file is not None and Path(file).is_file() else None


def _write(pipe: IO[bytes], data: bytes) -> None:
    pipe.write(len(data).to_bytes(8, "big"))
    pipe.write(data)
    pipe.flush()


def _read(pipe: IO[bytes]) -> bytes:
    """What was written at once; raises EOFError when the other side has ended."""
    size = pipe.read(8)
    data = pipe.read(int.from_bytes(size, "big"))
    if len(size) < 8 or len(data) < int.from_bytes(size, "big"):
        raise EOFError
    return data


def work(script: str | None) -> None:
    """In the process: do what comes through standard input until it is closed."""
    global _is_worker  # noqa: PLW0603 - of this process, which does nothing else
    _is_worker = True
    sys.modules[SCRIPT] = sys.modules["__main__"]
    vars(sys.modules["__main__"])["__getattr__"] = partial(_of_script, script)
    replies = os.fdopen(os.dup(1), "wb")
    os.dup2(2, 1)  # what libraries print must not get among the replies
    with suppress(EOFError, ConnectionError):  # the caller has ended
        _write(replies, READY)
        while True:
            _write(replies, _reply(_read(sys.stdin.buffer)))


def _of_script(script: str | None, name: str) -> Any:
    """A name of the caller's program, such as a class of which an argument is; the program is read when it is first needed."""
    names = {} if script is None or name.startswith("__") else runpy.run_path(script, run_name=SCRIPT)
    if name not in names:
        raise AttributeError(f"the program {script or 'of the caller'} has no {name!r} that a worker can load")
    vars(sys.modules["__main__"]).update({key: each for key, each in names.items() if not key.startswith("__")})
    return names[name]


def _reply(packed: bytes) -> bytes:
    """Whether a call succeeded, and its result or what it raised, pickled."""
    try:
        function, arguments, options = pickle.loads(packed)
        return pickle.dumps((True, function(*arguments, **options)))
    except Exception as error:  # handed on to the caller, as executors do
        try:
            return pickle.dumps((False, error))
        except Exception:  # one that cannot be pickled
            return pickle.dumps((False, RuntimeError(f"{type(error).__name__}: {error}")))


#: The limits of control groups [bytes], version 2 and 1, under the folder of a group.
LIMITS = (("", "memory.max"), ("memory", "memory.limit_in_bytes"))


def usable_memory(proc: Path = Path("/proc/self"), groups: Path = Path("/sys/fs/cgroup")) -> float:
    """The least of the machine's memory, the limit of its address space, and those of all its control groups [bytes]."""
    limits = [float(os.sysconf("SC_PAGE_SIZE")) * os.sysconf("SC_PHYS_PAGES"), *_group_limits(proc, groups)]
    try:
        import resource
    except ImportError:  # Windows
        return min(limits)
    soft, _ = resource.getrlimit(resource.RLIMIT_AS)
    return min(limits if soft == resource.RLIM_INFINITY else [*limits, float(soft)])


def _group_limits(proc: Path, groups: Path) -> Iterator[float]:
    """The limits of the groups of this process and of the groups that hold these; none where there are no groups."""
    try:
        lines = (proc / "cgroup").read_text().splitlines()
    except OSError:
        return
    for line in lines:  # hierarchy:controllers:group
        _, controllers, group = line.split(":", 2)
        version_1 = "memory" in controllers.split(",")
        if controllers and not version_1:
            continue
        folder, name = LIMITS[version_1]
        for each in (PurePosixPath(group), *PurePosixPath(group).parents):
            try:  # a container may not see the folder of its own group: its limit then stands at the mount
                yield float((groups / folder / str(each).lstrip("/") / name).read_text())
            except (OSError, ValueError):  # no such file, or "max"
                continue


@contextmanager
def one_thread() -> Iterator[None]:
    """Let BLAS use one thread in the block, and as many as before after it; also usable as a decorator.

    The matrices of a plan are so small that more threads only wait for each other, on a busy machine several times as long as
    the work takes. Where BLAS has one setting for the process, the first of several threads decides, as threadpoolctl says.
    """
    with _libraries(len(sys.modules)).limit(limits=1, user_api="blas"):
        yield


@lru_cache(maxsize=1)
def _libraries(_modules: int) -> "ThreadpoolController":
    """The libraries of the process, which are searched for again when more modules have been imported: it takes 2 ms."""
    from threadpoolctl import ThreadpoolController

    return ThreadpoolController()
