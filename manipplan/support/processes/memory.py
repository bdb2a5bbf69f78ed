"""usable_memory: the memory that this process may use, which a container or a shell limits below that of the machine."""

import os
from collections.abc import Iterator
from pathlib import Path, PurePosixPath

#: The limits of control groups [bytes], version 2 and 1, under the folder of a group.
LIMITS = (("", "memory.max"), ("memory", "memory.limit_in_bytes"))


def usable_memory(proc: Path = Path("/proc/self"), groups: Path = Path("/sys/fs/cgroup")) -> float:
    """The least of the machine's memory, the limit of its address space, and those of all its control groups [bytes].

    Args:
        proc: the process's folder in the file system of processes.
        groups: where control groups are mounted.
    """
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
