"""A short run of edited files through every loader, and what the run itself reports."""

import os
import sys
import time
from pathlib import Path

import pytest

import manipplan as mp

sys.path.insert(0, str(Path(__file__).parents[2] / "benchmarks"))
import fuzz_loaders
from fuzz.loaders import LOADERS, Loader

#: Number of edited files of each loader; `make fuzz` reads 10,000.
COUNT = 60


@pytest.mark.parametrize("name", LOADERS)
def test_no_edited_file_is_at_fault(name, tmp_path):
    count = round(COUNT / LOADERS[name].share)
    found = fuzz_loaders.main(
        ["--count", str(count), "--loader", name, "--out", str(tmp_path / "table.md"), "--faults", str(tmp_path / "faults")]
    )
    assert found[name].faults == {}
    assert found[name].files == COUNT
    assert min(found[name].outcomes[each] for each in (fuzz_loaders.ACCEPTED, fuzz_loaders.REFUSED)) > 5
    assert f"| {COUNT} |" in (tmp_path / "table.md").read_text()


def test_files_depend_on_seed_and_number_alone():
    for name, loader in LOADERS.items():
        if name != "plan":
            samples = loader.samples()
            first = [fuzz_loaders.case(samples, name, 3, k)[1] for k in range(20)]
            assert first == [fuzz_loaders.case(loader.samples(), name, 3, k)[1] for k in range(20)]
            assert len(set(first)) > 10


def test_errors_of_the_package_are_no_faults(tmp_path):
    def refuse(file):
        raise mp.errors.InvalidInputError("a", 1, "2")

    def crash(file):
        raise KeyError("a")

    for load, outcome in ((refuse, "refused"), (crash, "fault"), (lambda file: None, "accepted")):
        assert fuzz_loaders.read(Loader(about="", samples=list, load=load), tmp_path)[0] == outcome


def crashing(connection, name, numbers, seed, log):
    connection.send(numbers.start)
    os.abort()


def hanging(connection, name, numbers, seed, log):
    connection.send(numbers.start)
    time.sleep(60)


@pytest.mark.parametrize(
    ("child", "message"),
    [(crashing, "the process ended with code -6"), (hanging, "no answer after 1 s")],
    ids=["crash", "hang"],
)
def test_a_crash_and_a_hang_are_seen_from_outside(child, message, tmp_path, monkeypatch):
    loader = LOADERS["srdf"]
    monkeypatch.setitem(LOADERS, "srdf", Loader(about="", samples=loader.samples, load=loader.load, limit=1.0))
    monkeypatch.setattr(fuzz_loaders, "child", child)
    count = fuzz_loaders.Count()
    assert fuzz_loaders._batch("srdf", range(3, 9), 0, tmp_path / "log", count) == 4
    assert count.faults[3].startswith(message)
    fuzz_loaders.keep(tmp_path, "srdf", loader.samples(), 0, 3, message)
    assert (tmp_path / "srdf_0_3" / "fault.txt").read_text() == message
    assert (tmp_path / "srdf_0_3" / "arm.srdf").read_bytes() == fuzz_loaders.case(loader.samples(), "srdf", 0, 3)[1]
