"""Saving a result over another one is one step, whatever kills the process, and leaves nothing behind."""

import pytest

import manipplan as mp
from manipplan.support import files
from manipplan.support.files import finish, replacing


def write(new, mark, names=("trajectory.csv", "report.txt", "plan.json")):
    for name in names:
        (new / name).write_text(mark)


def held(folder):
    return {each.name: each.read_text() for each in folder.iterdir() if each.is_file()}


def test_the_files_of_a_result_are_replaced_and_others_stay(tmp_path):
    (tmp_path / "notes.txt").write_text("mine")
    for mark, names in (("old", ("plan.json", "plan.png", "part_7.json")), ("new", ("program.json", "part_0.json"))):
        with replacing(tmp_path) as (to, new):
            assert to == tmp_path
            write(new, mark, names)
    assert held(tmp_path) == {"notes.txt": "mine", "program.json": "new", "part_0.json": "new"}
    assert len(list(tmp_path.iterdir())) == 3


def test_an_error_leaves_the_old_files(tmp_path):
    with replacing(tmp_path) as (_, new):
        write(new, "old")
    with pytest.raises(KeyError), replacing(tmp_path) as (_, new):
        write(new, "new", ("plan.json",))
        raise KeyError
    assert set(held(tmp_path).values()) == {"old"} and len(list(tmp_path.iterdir())) == 3


def test_a_folder_that_cannot_be_written(tmp_path):
    (tmp_path / "file").write_text("")
    wanted = pytest.raises(mp.errors.InvalidInputError, match="folder: got .*file.*a folder that can be written")
    with wanted, replacing(tmp_path / "file"):
        pass


class Killed(BaseException):
    """What ends the process in the next test."""


@pytest.mark.parametrize("step", range(12))
def test_killed_at_every_step(tmp_path, monkeypatch, step):
    """Each unlink and rename of the second save may be the last one: no mixture, and the next call puts all in place."""
    with replacing(tmp_path) as (_, new):
        write(new, "old", ("trajectory.csv", "report.txt", "plan.json", "plan.png"))
    left = step

    def until_killed(call):
        def counted(*arguments):
            nonlocal left
            left -= 1
            if left < 0:
                raise Killed
            return call(*arguments)

        return counted

    path = type(tmp_path)
    with monkeypatch.context() as patched:
        for name in ("unlink", "rename", "replace", "rmdir"):
            patched.setattr(path, name, until_killed(getattr(path, name)))
        patched.setattr(files.shutil, "rmtree", lambda *_, **__: None)  # a killed process cleans nothing
        try:
            with replacing(tmp_path) as (_, new):
                write(new, "new")
        except Killed:
            pass
    there = set(held(tmp_path).values())
    assert len(there) <= 1
    finish(tmp_path)
    assert not [each for each in tmp_path.glob(".*") if not each.name.startswith(files.WRITING)]
    kinds = [{"trajectory.csv", "report.txt", "plan.json"}, {"trajectory.csv", "report.txt", "plan.json", "plan.png"}]
    assert set(held(tmp_path)) in kinds and len(set(held(tmp_path).values())) == 1
    with replacing(tmp_path) as (_, new):
        write(new, "last")
    assert not list(tmp_path.glob(".*")) and set(held(tmp_path).values()) == {"last"}


def test_an_unfinished_save_hinders_no_reader(tmp_path, monkeypatch):
    """Nobody can write there: the files of the last save are read."""
    with replacing(tmp_path) as (_, new):
        write(new, "old")
    (tmp_path / f"{files.WRITING}x").mkdir()
    monkeypatch.setattr(files, "_finish", lambda _: pytest.fail("nothing is half in place"))
    finish(tmp_path)
    assert set(held(tmp_path).values()) == {"old"}
