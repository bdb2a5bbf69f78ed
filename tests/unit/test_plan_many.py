"""Many problems: order, failures as results, workers that die, and calls that are taken up again."""

import inspect
import json
import logging
import multiprocessing
import os
import re
import signal
import subprocess
import threading
from concurrent.futures import Executor, Future, ProcessPoolExecutor, ThreadPoolExecutor
from dataclasses import fields, replace
from pathlib import Path

import numpy as np
import pytest

import manipplan as mp
from manipplan.jobs import plan_many
from manipplan.jobs import plan_many as dispatch
from manipplan.plans.archive import checksum
from manipplan.support.status import Status

POST = mp.Scene([mp.Cylinder(radius=0.12, length=1.0, position=(0.03, 2.2, 0.0), name="post")])
PAIRS = [
    ([0.0, 1.5, -2.0], [1.0, 1.0, -1.0]),
    ([0.0, -1.1, -1.6], [1.57, 0.5, 1.5]),
    ([0.3, 0.9, 1.2], [-1.0, 1.5, -0.5]),
    ([0.0, 1.5, -2.0], [np.pi, -2.0, 2.0]),
]


def problems_of(robot, scenes=(None, POST)):
    return [
        mp.Problem(robot=robot, start=start, goal=goal, scene=scene, objective=mp.PathObjective(power=power))
        for scene in scenes
        for power, (start, goal) in zip((2.0, 1.0, 2.0, 1.0), PAIRS, strict=True)
    ]


@pytest.fixture(scope="module")
def problems(planar):
    return problems_of(planar)


@pytest.fixture(scope="module")
def expected(problems):
    return [mp.plan(p.robot, p.start, p.goal, p.scene, objective=p.objective, throw=False) for p in problems]


def assert_same(found, expected):
    assert [each.status for each in found] == [each.status for each in expected]
    for one, other in zip(found, expected, strict=True):
        assert type(one) is type(other)
        np.testing.assert_array_equal(one.trajectory.q, other.trajectory.q)
        np.testing.assert_array_equal(one.trajectory.t, other.trajectory.t)
        assert one.report == other.report and one.result.g == other.result.g


# ---- who does the work


@pytest.mark.slow
def test_results_in_this_process_are_those_of_plan(problems, expected):
    found = mp.plan_many(problems)
    assert_same(found, expected)
    assert all(one.robot is problem.robot for one, problem in zip(found, problems, strict=True))
    assert all(one.scene is problem.scene for one, problem in zip(found[4:], problems[4:], strict=True))
    assert [len(one.result.history) for one in found] == [len(other.result.history) for other in expected]


@pytest.mark.slow
def test_processes_give_the_same_in_the_same_order(problems, expected):
    found = mp.plan_many(iter(problems), 2)
    assert_same(found, expected)
    assert all(one.robot is problem.robot for one, problem in zip(found, problems, strict=True))
    assert_same(mp.plan_many(problems[:1], 1), expected[:1])


@pytest.mark.slow
def test_threads_give_the_same(problems, expected):
    with ThreadPoolExecutor(2) as pool:
        assert_same(mp.plan_many(problems, pool), expected)


@pytest.mark.slow
def test_a_pool_of_processes_gives_the_same(problems, expected):
    with ProcessPoolExecutor(2, mp_context=multiprocessing.get_context("spawn")) as pool:
        assert_same(mp.plan_many(problems, pool), expected)


@pytest.fixture(scope="module")
def client():
    import dask
    import distributed

    with (
        dask.config.set({"distributed.scheduler.allowed-failures": 0}),  # a worker takes seconds to start
        distributed.LocalCluster(n_workers=2, threads_per_worker=1, processes=True, dashboard_address=":0") as cluster,
        distributed.Client(cluster) as made,
    ):
        made.wait_for_workers(2)
        yield made


@pytest.mark.slow
def test_a_dask_cluster_gives_the_same(problems, expected, client):
    assert_same(mp.plan_many(problems, client.get_executor()), expected)
    assert_same(mp.plan_many(problems, client.get_executor(pure=True)), expected)


def test_no_problems_are_no_work(tmp_path):
    assert mp.plan_many([]) == mp.plan_many([], 2) == mp.plan_many([], folder=tmp_path) == []


class Recorder(Executor):
    """Runs in a thread, and keeps what it was sent."""

    def __init__(self):
        self.pool = ThreadPoolExecutor(1)
        self.parcels = []
        self._max_workers = 1

    def submit(self, fn, /, *args, **kwargs):
        self.parcels += args
        return self.pool.submit(fn, *args, **kwargs)


@pytest.mark.slow
def test_a_robot_is_sent_when_it_is_needed_and_only_then():
    arms = [mp.planar_arm([1.0, 1.0, 1.0]) for _ in range(8)]
    given = [replace(problem, robot=arm) for arm, problem in zip(arms, problems_of(arms[0]), strict=True)]
    given = [replace(each, seeding=mp.Seeding(initial=mp.JointPath.line(each.start, each.goal))) for each in given[:4] * 5]
    recorder = Recorder()
    found = mp.plan_many(given, recorder)
    assert all(one.robot is problem.robot for one, problem in zip(found, given, strict=True))
    sent = [dispatch for dispatch in recorder.parcels if dispatch.robot in dispatch.contents]
    assert len(sent) <= 2  # two problems are on their way before the first answer
    assert len(recorder.parcels) <= len(given) + 2
    assert len({dispatch.label for dispatch in recorder.parcels}) == len(recorder.parcels)


@pytest.mark.slow
def test_a_large_scene_is_sent_when_it_is_needed(planar, monkeypatch):
    monkeypatch.setattr(dispatch, "SMALL", 10)
    recorder = Recorder()
    given = [replace(problem, scene=POST) for problem in problems_of(planar)[:3]]
    assert [each.status.has_path for each in mp.plan_many(given, recorder)] == [True] * 3
    sent = [each for each in recorder.parcels if each.scene in each.contents]
    assert 1 <= len(sent) <= 2


def test_only_the_latest_are_kept():
    kept, made = dispatch.Latest(2), []
    for key in ("a", "b", "a", "c", "a", "b"):
        assert kept.get(key, lambda key=key: made.append(key) or key.upper()) == key.upper()
    assert made == ["a", "b", "c", "b"]
    assert "c" not in kept and "a" in kept


# ---- failures


CAGE = mp.Scene(
    [
        mp.Box(size=(0.05, 8.0, 1.0), position=(-0.4, 0.0, 0.0), name="wall"),
        mp.Box(size=(5.0, 0.02, 1.0), position=(2.6, 0.0, 0.0), name="shelf"),
    ]
)


@pytest.fixture(scope="module")
def hard(planar):
    """Problems of which some fail, each in its own way."""
    limited = planar.with_limits(lower=-3.0, upper=3.0)
    good = mp.Problem(robot=planar, start=PAIRS[0][0], goal=PAIRS[0][1], name="good")
    inside = [np.pi / 2, 0.0, 0.0]
    return [
        good,
        replace(good, robot=limited, goal=[3.1, 0.0, 0.5], name="outside"),
        replace(good, scene=POST, start=inside, name="in collision"),
        replace(good, robot=limited, start=[3.1, 0.0, 0.5], name="start outside"),
        replace(good, scene=CAGE, start=[0.5] * 3, goal=[-0.5] * 3, seeding=mp.Seeding(time_limit=60.0), name="caged"),
        good,
    ]


@pytest.mark.slow
@pytest.mark.parametrize("executor", [None, 1])
def test_failures_are_results(hard, executor, caplog, tmp_path):
    with caplog.at_level(logging.INFO, "manipplan"):
        found = mp.plan_many(hard, executor, folder=tmp_path)
    invalid = Status.NOT_VALID
    assert [each.status for each in found[1:5]] == [invalid, invalid, invalid, Status.NO_PATH]
    assert re.search(r"goal\[0\].*3\.1", found[1].message)
    assert re.search("start.*post overlap", found[2].message)
    assert "cannot be reached" in found[4].message
    assert all(type(each) is mp.results.PartialPlan and not each.status.has_path and each.path is None for each in found[1:5])
    assert_same([found[5]], [found[0]])
    assert "problems[4] (caged): NO_PATH" in caplog.text
    again = mp.plan_many(hard, folder=tmp_path)
    assert [each.message for each in again] == [each.message for each in found]
    failed = next(file for file in tmp_path.iterdir() if "NO_PATH" in file.read_text())
    with pytest.raises(
        mp.errors.FileFormatError, match="a plan with a trajectory; this one has none, with status NO_PATH: it is proven"
    ):
        mp.Plan.load(failed)


@pytest.mark.slow
def test_an_unexpected_error_ends_one_problem(problems, monkeypatch, caplog, tmp_path):
    real = dispatch.plan

    def sometimes(robot, start, *arguments, **options):
        if start[1] == PAIRS[1][0][1]:
            raise ZeroDivisionError("by chance")
        return real(robot, start, *arguments, **options)

    monkeypatch.setattr(dispatch, "plan", sometimes)
    found = mp.plan_many(problems[:3], folder=tmp_path)
    assert [each.status for each in found] == [Status.OPTIMAL, Status.ERROR, Status.OPTIMAL]
    assert found[1].message == "ZeroDivisionError: by chance"
    assert "Traceback" in caplog.text
    monkeypatch.undo()
    assert mp.plan_many(problems[:3], folder=tmp_path)[1].status is Status.OPTIMAL  # it was not kept


@pytest.mark.slow
def test_progress_names_each_result(hard):
    told = []
    mp.plan_many(hard[:4], 1, progress=lambda share, text: told.append((share, text)))
    assert [share for share, _ in told] == [0.25, 0.5, 0.75, 1.0]
    assert told[-1][1] == "4 of 4 problems, 3 failed"


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"robot": "panda"}, r"problems\[2\]\.robot: got 'panda'; allowed: a Robot"),
        ({"scene": "scene.yaml"}, r"problems\[2\]\.scene: got 'scene.yaml'; allowed: a Scene"),
        ({"start": [0.0] * 2}, r"problems\[2\]\.start: .*shape \(3,\)"),
        ({"start": [[0.0] * 3]}, r"problems\[2\]\.start: .*one configuration"),
        ({"goal": [0.0, np.nan, 0.0]}, r"problems\[2\]\.goal: .*finite"),
        ({"goal": "home"}, r"problems\[2\]\.goal: got 'home'"),
        ({"objective": 2.0}, r"problems\[2\]\.objective: got 2.0; allowed: a PathObjective"),
        ({"objective": mp.PathObjective(metric=[1.0, 2.0])}, r"problems\[2\]\.metric: "),
        ({"objective": mp.PathObjective(task=mp.Task.pose())}, r"problems\[2\]\.task: "),
        ({"objective": mp.PathObjective(measure="yoshikava")}, r"problems\[2\]\.measure: .*did you mean yoshikawa"),
        ({"shape": 6}, r"problems\[2\]\.shape: got 6"),
        (
            {"seeding": mp.Seeding(initial="missing.csv")},
            r"problems\[2\]\.file: got 'missing.csv'|problems\[2\]\..*missing.csv",
        ),
        ({"seeding": mp.Seeding(initial=mp.JointPath.line([0.0], [1.0]))}, r"problems\[2\]\.initial: "),
        ({"clearance": -1.0}, r"problems\[2\]\.clearance: got -1.0"),
        ({"torque": 1}, r"problems\[2\]\.torque: got 1"),
        ({"name": 5}, r"problems\[2\]\.name: got 5"),
    ],
)
def test_wrong_values_of_a_problem_are_told_with_its_number(planar, monkeypatch, change, message):
    monkeypatch.setattr(dispatch, "plan", None)
    good = mp.Problem(robot=planar, start=PAIRS[0][0], goal=PAIRS[0][1])
    with pytest.raises(mp.errors.InvalidInputError, match=message):
        mp.plan_many([good, good, replace(good, **change), good])


def test_robots_without_speed_limits_are_told(planar, monkeypatch):
    good = mp.Problem(robot=planar, start=PAIRS[0][0], goal=PAIRS[0][1])
    fast = replace(good, robot=planar.with_limits(velocity=np.inf))
    with pytest.raises(mp.errors.InvalidInputError, match=r"problems\[1\]\.limits\.velocity: .*give velocity="):
        mp.plan_many([good, fast])


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({"problems": 5}, "problems: got 5; allowed: a list of Problem"),
        ({"problems": [{"start": 1}]}, r"problems\[0\]: got .*; allowed: a Problem"),
        ({"executor": 0}, "executor: got 0; allowed: a whole number, at least 1"),
        ({"executor": "two"}, "executor: got 'two'; allowed: a number of processes, a concurrent.futures.Executor, or None"),
        ({"executor": True}, "executor: got True"),
        ({"executor": 2.0}, "executor: got 2.0"),
        ({"folder": 3}, "folder: got 3"),
        ({"folder": "/proc/none"}, "folder: got '/proc/none'"),
        ({"progress": 3}, "progress: got 3"),
    ],
)
def test_wrong_arguments(problems, arguments, message):
    with pytest.raises(mp.errors.InvalidInputError, match=message):
        mp.plan_many(**{"problems": problems, **arguments})


def test_a_problem_holds_each_option_of_plan():
    given = inspect.signature(mp.plan).parameters
    options = {name: given[name].default for name in given if name not in ("executor", "throw", "progress")}
    held = {each.name: each.default for each in fields(mp.Problem) if each.name != "name"}
    assert list(held) == list(options)
    for name in set(held) - {"robot", "start", "goal"}:
        assert repr(held[name]) == repr(options[name])


def test_what_cannot_be_sent_is_told(planar):
    class Local(mp.measures.Yoshikawa):
        pass

    given = [mp.Problem(robot=planar, start=PAIRS[0][0], goal=PAIRS[0][1], objective=mp.PathObjective(measure=Local()))]
    with pytest.raises(mp.errors.InvalidInputError, match=r"problems\[0\]: .*a problem that can be pickled"):
        mp.plan_many(given, 1)


def test_an_executor_that_was_shut_down_is_told(problems):
    pool = ThreadPoolExecutor(1)
    pool.shutdown()
    with pytest.raises(mp.errors.InvalidInputError, match="executor: .*an executor that takes work"):
        mp.plan_many(problems, pool)


class Failing(Executor):
    """Its futures hold what was given."""

    def __init__(self, error=None):
        self.error = error

    def submit(self, fn, /, *args, **kwargs):
        future = Future()
        if self.error is None:
            future.cancel()
            future.set_running_or_notify_cancel()
        else:
            future.set_exception(self.error)
        return future


@pytest.mark.parametrize(
    ("executor", "message"),
    [
        (Failing(), "an executor that is not shut down while it plans"),
        (Failing(ModuleNotFoundError("no manipplan")), r"workers that can load problems\[\d\] \(ModuleNotFoundError: no manip"),
    ],
)
def test_an_executor_that_fails_is_told(problems, executor, message):
    with pytest.raises(mp.errors.InvalidInputError, match=f"executor: .*{message}"):
        mp.plan_many(problems, executor)


# ---- workers that die


def kill(times, folder, caller):
    """Killed in a worker, at most a number of times in all; what is left of a path that is unpickled."""
    if os.getpid() != caller:
        deaths = len(list(Path(folder).iterdir()))
        if deaths < times:
            (Path(folder) / f"death {deaths}").touch()
            os.kill(os.getpid(), signal.SIGKILL)
    return mp.JointPath.line(*PAIRS[0])


class Deadly(mp.JointPath):
    """A first path whose arrival kills the worker."""

    def __reduce__(self):
        return kill, (self.times, self.folder, os.getpid())


def deadly(robot, times, folder):
    folder.mkdir()
    line = mp.JointPath.line(*PAIRS[0])
    path = Deadly(breaks=line.breaks, control=line.control)
    vars(path).update(times=times, folder=str(folder))
    return mp.Problem(robot=robot, start=PAIRS[0][0], goal=PAIRS[0][1], seeding=mp.Seeding(initial=path), name="deadly")


@pytest.fixture
def started(monkeypatch):
    """The processes that were started for workers."""
    made = []

    class Noted(subprocess.Popen):
        def __init__(self, *arguments, **options):
            super().__init__(*arguments, **options)
            made.append(self)

    monkeypatch.setattr("manipplan.support.workers.subprocess.Popen", Noted)
    return made


@pytest.fixture
def with_deaths(planar, tmp_path):
    """Six problems, of which the second kills its worker a number of times."""
    return lambda times: [
        *problems_of(planar)[:1],
        deadly(planar, times, tmp_path / "deaths"),
        *problems_of(planar)[1:5],
    ]


def deaths(tmp_path):
    return len(list((tmp_path / "deaths").iterdir()))


@pytest.mark.slow
def test_a_lost_worker_is_replaced_and_its_problem_redone(with_deaths, tmp_path):
    found = mp.plan_many(with_deaths(1), 2)
    assert deaths(tmp_path) == 1
    assert all(isinstance(each, mp.Plan) and each.report.passed for each in found)


@pytest.mark.slow
@pytest.mark.parametrize("workers", [1, 2])
def test_a_problem_that_kills_each_worker_is_a_failure(with_deaths, tmp_path, expected, workers):
    found = mp.plan_many(given := with_deaths(100), workers, folder=tmp_path / "results")
    assert deaths(tmp_path) == 2
    assert (found[1].status, type(found[1])) == (Status.WORKER_LOST, mp.results.PartialPlan)
    assert "signal 9, Killed" in found[1].message
    assert_same([found[0], *found[2:]], expected[:5])
    assert len(list((tmp_path / "results").iterdir())) == len(given) - 1


@pytest.mark.slow
def test_a_process_killed_from_outside_is_replaced(problems, expected, started):
    def murder(share, text):
        if text.startswith("2 of"):
            os.kill(started[0].pid, signal.SIGKILL)

    assert_same(mp.plan_many(problems, 2, progress=murder), expected)
    assert started[0].returncode == -signal.SIGKILL and len(started) == 3


@pytest.mark.slow
def test_the_rest_of_a_broken_pool_is_planned(with_deaths, tmp_path, expected, caplog):
    with ProcessPoolExecutor(2, mp_context=multiprocessing.get_context("spawn")) as pool:
        found = mp.plan_many(with_deaths(100), pool)
    assert deaths(tmp_path) == 3
    assert found[1].status is Status.WORKER_LOST
    assert_same([found[0], *found[2:]], expected[:5])
    assert "2 processes of plan_many plan the other" in caplog.text


@pytest.mark.slow
def test_a_pool_that_is_broken_already_is_replaced(problems, expected, caplog):
    with ProcessPoolExecutor(1, mp_context=multiprocessing.get_context("spawn")) as pool:
        assert pool.submit(os._exit, 1).exception() is not None
        assert_same(mp.plan_many(problems[:2], pool), expected[:2])
    assert "1 processes of plan_many plan the other 2 problems" in caplog.text


@pytest.mark.slow
@pytest.mark.filterwarnings("ignore::ResourceWarning")
def test_a_dask_cluster_survives_a_deadly_problem(with_deaths, tmp_path, expected, client):
    found = mp.plan_many(with_deaths(100), client.get_executor())
    assert found[1].status is Status.WORKER_LOST
    assert_same([found[0], *found[2:]], expected[:5])


def test_processes_that_do_not_start_are_told(problems, monkeypatch):
    monkeypatch.setattr("manipplan.support.workers.BEGIN", "import sys; sys.exit(5)")
    with pytest.raises(mp.errors.InvalidInputError, match=r"executor: .*processes that can start.*exit code 5"):
        mp.plan_many(problems, 2)


# ---- taken up again


@pytest.fixture
def counted(monkeypatch):
    """The starts of the problems that are really planned."""
    real, starts = dispatch.plan, []

    def plan(robot, start, *arguments, **options):
        starts.append(list(start))
        return real(robot, start, *arguments, **options)

    monkeypatch.setattr(dispatch, "plan", plan)
    return starts


@pytest.mark.slow
def test_a_second_call_plans_only_the_rest(problems, expected, counted, tmp_path):
    mp.plan_many(problems[2:4], folder=tmp_path / "deep" / "results")
    assert len(counted) == 2
    counted.clear()
    found = mp.plan_many(problems, folder=tmp_path / "deep" / "results")
    assert counted == [each.start for k, each in enumerate(problems) if k not in (2, 3)]
    assert_same(found, expected)
    counted.clear()
    again = mp.plan_many(problems[::-1], 2, folder=tmp_path / "deep" / "results")
    assert counted == []
    assert_same(again[::-1], expected)
    assert all(one.robot is problem.robot for one, problem in zip(again[::-1], problems, strict=True))
    assert all(each.result.history == () for each in again)
    file = next((tmp_path / "deep" / "results").iterdir())
    assert isinstance(mp.Plan.load(file), mp.Plan)


def test_a_changed_problem_is_planned_again(problems, counted, tmp_path):
    mp.plan_many(problems[:2], folder=tmp_path)
    counted.clear()
    changed = replace(problems[0], clearance=0.01)
    mp.plan_many([changed, problems[1]], folder=tmp_path)
    assert counted == [problems[0].start]
    assert len(list(tmp_path.iterdir())) == 3


def edited(file, **changes):
    data = json.loads(file.read_text())
    del data["sha256"]
    data |= changes
    file.write_text(json.dumps({**data, "sha256": checksum(data)}))


@pytest.mark.slow
@pytest.mark.parametrize(
    ("spoil", "message"),
    [
        (lambda file: edited(file, code="0" * 64), "is of other code, of manipplan .*: planned again"),
        (lambda file: edited(file, version=99), "planned again: .*this is version 99"),
        (lambda file: edited(file, problem="of another"), "planned again: .*it holds that of another one"),
        (lambda file: edited(file, status="UNHEARD_OF"), "planned again: .*UNHEARD_OF"),
        (lambda file: file.write_text(file.read_text()[:1000]), "planned again: .*truncated"),
        (lambda file: file.write_text(file.read_text().replace('"status"', '"Status"', 1)), "planned again: .*changed since"),
        (lambda file: file.write_text("[]"), "planned again: "),
    ],
)
def test_files_that_cannot_be_used_are_told_and_replaced(problems, expected, counted, tmp_path, caplog, spoil, message):
    mp.plan_many(problems[:1], folder=tmp_path)
    (file,) = tmp_path.iterdir()
    spoil(file)
    counted.clear()
    assert_same(mp.plan_many(problems[:1], folder=tmp_path), expected[:1])
    assert len(counted) == 1
    assert re.search(message, caplog.text)
    caplog.clear()
    mp.plan_many(problems[:1], folder=tmp_path)
    assert len(counted) == 1 and not caplog.records


def test_a_file_is_whole_or_not_there(problems, tmp_path, monkeypatch):
    class FullError(OSError):
        pass

    def full(*_):
        raise FullError(28, "No space left on device")

    monkeypatch.setattr("pathlib.Path.replace", full)
    with pytest.raises(mp.errors.InvalidInputError, match="No space left"):
        mp.plan_many(problems[:1], folder=tmp_path)
    assert list(tmp_path.iterdir()) == []


@pytest.mark.slow
@pytest.mark.parametrize("executor", [None, 2])
def test_ctrl_c_keeps_what_is_finished(problems, expected, tmp_path, counted, executor, sigint, started):
    def interrupt(share, text):
        if text.startswith("3 of"):
            os.kill(os.getpid(), signal.SIGINT)

    with pytest.raises(KeyboardInterrupt):
        mp.plan_many(problems, executor, folder=tmp_path, progress=interrupt)
    assert len(list(tmp_path.iterdir())) == 3
    assert len(started) == (executor or 0)
    for process in started:
        process.wait(timeout=20)
    for thread in threading.enumerate():
        if thread.name.startswith("worker"):
            thread.join(timeout=20)
            assert not thread.is_alive()
    counted.clear()
    assert_same(mp.plan_many(problems, folder=tmp_path), expected)
    assert len(counted) == len(problems) - 3


def test_statuses_that_are_not_kept_are_failures():
    assert all(not status.has_path for status in plan_many.UNFINISHED)
