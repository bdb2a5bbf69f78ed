"""The memory that a process may use."""

import resource
import subprocess
import sys

import psutil
import pytest

from manipplan.support.workers import usable_memory

GB = 1_000_000_000


@pytest.fixture
def made(tmp_path):
    """A function that writes files of a process and of control groups, and gives the usable memory [bytes]."""

    def memory(cgroup, **files):
        (tmp_path / "proc").mkdir()
        (tmp_path / "proc" / "cgroup").write_text(cgroup)
        for name, text in files.items():
            file = tmp_path / "groups" / name.replace("__", "/").replace("_dot_", ".")
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_text(text)
        return usable_memory(tmp_path / "proc", tmp_path / "groups")

    return memory


def test_without_groups_it_is_that_of_the_machine(tmp_path):
    assert usable_memory(tmp_path, tmp_path) == psutil.virtual_memory().total


def test_the_least_limit_of_all_groups_that_hold_the_process(made):
    found = made(
        "0::/user/job\n",
        user__memory_dot_max=f"{GB}\n",
        user__job__memory_dot_max="max\n",
    )
    assert found == GB


def test_version_1(made):
    group = "9:name=systemd:/\n4:cpu,memory:/jobs/a\n0::/\n"
    assert made(group, memory__jobs__a__memory_dot_limit_in_bytes=str(GB // 2), memory_dot_max="max") == GB // 2


def test_a_container_that_sees_its_own_group_as_the_root(made):
    assert made("0::/../../outside\n", memory_dot_max=str(GB)) == GB


@pytest.mark.slow
def test_a_limit_of_the_shell_counts():
    code = "from manipplan.support.workers import usable_memory; print(usable_memory())"
    limit = 3 * GB

    def limited():
        resource.setrlimit(resource.RLIMIT_AS, (limit, limit))

    done = subprocess.run([sys.executable, "-c", code], preexec_fn=limited, capture_output=True, text=True, check=True)
    assert float(done.stdout) == min(limit, usable_memory())
