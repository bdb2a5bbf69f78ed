"""Edited files for every loader: none may crash it, stop it or raise an error that is not one of the package's own.

Run with `make fuzz`. Each loader reads files that are made from valid ones by edits of bytes, words, lines and trees; file k
depends on the seed and k alone. A child process reads them, so that a crash or an endless loop is seen from outside: the
file is kept in the folder that --faults names, and a new child goes on with the next one. What was read is used once, since
a library may crash only then. Writes docs/benchmarks/fuzz_loaders.md.
"""

import argparse
import faulthandler
import multiprocessing
import os
import platform
import random
import sys
import tempfile
import time
import traceback
import warnings
from collections import Counter
from dataclasses import dataclass, field
from multiprocessing.connection import Connection
from pathlib import Path

if sys.platform == "linux":
    import resource
else:
    resource = None

from fuzz.loaders import LOADERS, Loader, Sample
from rich.progress import Progress

import manipplan as mp

OUT = Path(__file__).parents[1] / "docs" / "benchmarks" / "fuzz_loaders.md"
#: Number of files that a child process reads, and the memory that it may use [bytes].
BATCH, MEMORY = 500, 4 * 2**30
#: Memory by which one file may increase the largest use so far [kB].
GROWTH = 2**20
#: Longest time in which a child starts [s].
START = 120.0
#: A file that takes longer [s] is named.
SLOW = 1.0
ACCEPTED, REFUSED, FAULT = "accepted", "refused", "fault"


@dataclass(kw_only=True)
class Count:
    """What happened to the files of one loader, with the time [s] and number of the slowest."""

    outcomes: Counter[str] = field(default_factory=Counter)
    faults: dict[int, str] = field(default_factory=dict)
    slowest: tuple[float, int] = (0.0, -1)

    @property
    def files(self) -> int:
        """Number of files read."""
        return sum(self.outcomes.values()) + len(self.faults)


def case(samples: list[Sample], loader: str, seed: int, number: int) -> tuple[Sample, bytes]:
    """File `number` of a loader: the valid file, and what it is edited to."""
    rng = random.Random(f"{seed} {loader} {number}")
    sample = rng.choice(samples)
    return sample, sample.edited(rng)


def write(folder: Path, sample: Sample, data: bytes) -> Path:
    """Write a file and those beside it into `folder`."""
    for name, content in {**sample.beside, sample.name: data}.items():
        (folder / name).write_bytes(content)
    return folder / sample.name


def read(loader: Loader, file: Path) -> tuple[str, str]:
    """The outcome of reading a file, and the text of a fault."""
    try:
        loader.load(file)
    except mp.errors.ManipplanError as error:
        if len(str(error)) > 3000:
            return FAULT, f"a message of {len(str(error))} characters: {str(error)[:300]}"
        return REFUSED, ""
    except BaseException:
        return FAULT, traceback.format_exc()
    return ACCEPTED, ""


def memory() -> int:
    """The largest memory use so far [kB]."""
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss if resource is not None else 0


def child(connection: Connection, name: str, numbers: range, seed: int, log: Path) -> None:
    """Read files, and send the number of each before, and its outcome after."""
    stream = os.open(log, os.O_WRONLY | os.O_CREAT | os.O_TRUNC)
    for standard in (1, 2):
        os.dup2(stream, standard)
    faulthandler.enable(2)
    warnings.simplefilter("error", RuntimeWarning)
    if resource is not None:
        resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    loader = LOADERS[name]
    samples = loader.samples()
    with tempfile.TemporaryDirectory() as place:
        folder = Path(place)
        os.chdir(folder)  # for the log of MuJoCo
        for sample in samples:
            loader.load(write(folder, sample, sample.data))
        for number in numbers:
            sample, data = case(samples, name, seed, number)
            file = write(folder, sample, data)
            connection.send(number)
            began = time.monotonic()
            before = memory()
            outcome = read(loader, file)
            if outcome[0] != FAULT and memory() > before + GROWTH:
                outcome = FAULT, f"{outcome[0]}, with {memory() - before} kB more memory"
            os.ftruncate(stream, 0)
            connection.send((*outcome, time.monotonic() - began))
        os.chdir("/")
        connection.send(None)


def keep(folder: Path, loader: str, samples: list[Sample], seed: int, number: int, text: str) -> None:
    """Keep a file that is at fault, with those beside it and what happened."""
    place = folder / f"{loader}_{seed}_{number}"
    place.mkdir(parents=True, exist_ok=True)
    sample, data = case(samples, loader, seed, number)
    write(place, sample, data)
    (place / "fault.txt").write_text(text)


def run(name: str, numbers: range, seed: int, faults: Path | None, progress: Progress) -> Count:
    """Have children read the files of one loader."""
    count, following = Count(), numbers.start
    bar = progress.add_task(name, total=len(numbers))
    samples: list[Sample] = []
    with tempfile.TemporaryDirectory() as place:
        log = Path(place) / "log"
        while following < numbers.stop:
            batch = range(following, min(following + BATCH, numbers.stop))
            before = len(count.faults)
            following = _batch(name, batch, seed, log, count)
            if faults is not None and len(count.faults) > before:
                samples = samples or LOADERS[name].samples()
                for number in list(count.faults)[before:]:
                    keep(faults, name, samples, seed, number, count.faults[number])
            progress.update(bar, completed=following - numbers.start)
    return count


def _batch(name: str, numbers: range, seed: int, log: Path, count: Count) -> int:
    """Read files in one child until the end, or until it crashes or hangs; the number of the next file."""
    context = multiprocessing.get_context("spawn")
    ours, theirs = context.Pipe(duplex=False)
    process = context.Process(target=child, args=(theirs, name, numbers, seed, log), daemon=True)
    process.start()
    theirs.close()
    number, limit = -1, START
    try:
        while ours.poll(limit):
            message = ours.recv()
            if message is None:
                return numbers.stop
            if isinstance(message, int):
                number, limit = message, LOADERS[name].limit
                continue
            outcome, text, seconds = message
            count.slowest = max(count.slowest, (seconds, number))
            if outcome == FAULT:
                count.faults[number] = text
            else:
                count.outcomes[outcome] += 1
        fault = f"no answer after {limit:g} s"
    except EOFError:
        process.join()
        fault = f"the process ended with code {process.exitcode}"
    finally:
        process.kill()
        process.join()
        ours.close()
    text = log.read_text(errors="replace")[-5000:] if log.exists() else ""
    if number < 0:
        raise RuntimeError(f"{name}: the child did not start: {fault}\n{text}")
    count.faults[number] = f"{fault}\n{text}"
    return number + 1


def table(counts: dict[str, Count], seed: int) -> str:
    """The counts as a page."""
    head = "| loader | files | accepted | refused by an error of the package | faults | slowest [s] |"
    lines = [head, "|---|---|---|---|---|---|"]
    for name, count in counts.items():
        found = count.outcomes
        lines.append(
            f"| {LOADERS[name].about} | {count.files} | {found[ACCEPTED]} | {found[REFUSED]} | {len(count.faults)} "
            f"| {count.slowest[0]:.1f} |"
        )
    told = f"Python {platform.python_version()}, {platform.machine()}; seed {seed}; command: `make fuzz`."
    return "\n".join([*lines, "", told, ""])


def main(arguments: list[str] | None = None) -> dict[str, Count]:
    """Run, and write the table."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--count", type=int, default=10_000, help="number of files for each loader")
    parser.add_argument("--first", type=int, default=0, help="number of the first file, to continue or repeat a run")
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--loader", nargs="+", choices=list(LOADERS), default=list(LOADERS))
    parser.add_argument("--out", type=Path, default=OUT)
    parser.add_argument("--faults", type=Path, default=None, help="a folder for the files at fault")
    options = parser.parse_args(arguments)
    os.environ.setdefault("OMP_NUM_THREADS", "1")
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
    options.out.parent.mkdir(parents=True, exist_ok=True)
    counts, text = dict[str, Count](), ""
    with Progress() as progress:
        for name in options.loader:
            count = max(1, round(options.count * LOADERS[name].share))
            numbers = range(options.first, options.first + count)
            counts[name] = run(name, numbers, options.seed, options.faults, progress)
            text = table(counts, options.seed)
            options.out.write_text(text)
    print(text)
    for name, count in counts.items():
        if count.slowest[0] > SLOW:
            print(f"{name} {count.slowest[1]}: {count.slowest[0]:.1f} s")
        for number, fault in count.faults.items():
            print(f"{name} {number}: {fault.strip().splitlines()[-1] if 'Traceback' in fault else fault.splitlines()[0]}")
    return counts


if __name__ == "__main__":
    main()
