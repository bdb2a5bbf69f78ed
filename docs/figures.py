"""Writes the numbers that pages state in prose from the tables in docs/benchmarks: `make figures`, or `python docs/figures.py`.

A page holds the numbers themselves, since it is also read where nothing is built. Each sentence below names its page and its
cells. A number of a sentence is replaced where its table changed; a sentence that its page no longer has is an error.
"""

import re
import sys
from collections.abc import Sequence
from dataclasses import dataclass
from decimal import ROUND_HALF_UP, Decimal
from pathlib import Path

ROOT = Path(__file__).parents[1]
TABLES = ROOT / "docs" / "benchmarks"
#: A number in prose; `{}` in a sentence stands for one.
NUMBER = r"\d+(?:[.,]\d+)*"
#: What a claim looks like: a quantity with a unit, a share, a ratio or a count.
CLAIM = re.compile(rf"{NUMBER}(?: to {NUMBER})? ?(?:µs|ns|ms|s|mm|%|x|times)(?!\w)|{NUMBER} of (?:the )?{NUMBER}")


def tables(name: str) -> list[list[list[str]]]:
    """The tables of docs/benchmarks/name.md: rows of cells, the first one the header."""
    found: list[list[list[str]]] = [[]]
    for line in (TABLES / f"{name}.md").read_text(encoding="utf-8").splitlines():
        if not line.startswith("|"):
            found.append([])
        elif not set(line) <= set("|-: "):
            found[-1].append([cell.strip().strip("*`") for cell in line.strip("|").split("|")])
    return [table for table in found if table]


def rows(name: str, column: str) -> list[dict[str, str]]:
    """The rows of all tables that have a column, each as header and cell; of equal headers the first counts."""
    found = []
    for header, *others in tables(name):
        found += [dict(reversed([*zip(header, row, strict=True)])) for row in others if column in header]
    return found


def cell(name: str, row: str, column: str, nth: int = 0) -> str:
    """The cell of the row that begins with `row`; of several, the nth."""
    return [each for each in rows(name, column) if [*each.values()][-1] == row][nth][column]


def number(name: str, row: str, column: str, place: int = 0, *, nth: int = 0) -> float:
    """The number at a place of a cell."""
    return float(re.findall(r"\d+(?:\.\d+)?(?:e[-+]?\d+)?", cell(name, row, column, nth).replace(",", " "))[place])


def shown(digits: int, name: str, row: str, column: str, place: int = 0, *, nth: int = 0) -> str:
    """The number at a place of a cell, with `digits` digits after the point."""
    exact = Decimal(str(number(name, row, column, place, nth=nth)))
    return str(exact.quantize(Decimal(1).scaleb(-digits), ROUND_HALF_UP))


def text(name: str, pattern: str) -> tuple[str, ...]:
    """What the groups of a pattern match in the text of docs/benchmarks/name.md."""
    [match] = re.finditer(pattern, (TABLES / f"{name}.md").read_text(encoding="utf-8"))
    return match.groups()


def rounded(exact: float, digits: int = 2) -> str:
    """A number with `digits` significant digits, without an exponent."""
    size = float(f"{exact:.{digits - 1}e}")
    return f"{size:,.{max(digits - 1 - int(f'{size:e}'.split('e')[1]), 0)}f}"


@dataclass(frozen=True)
class Sentence:
    """Words of a page, in which `{}` stands for a number, and the numbers."""

    page: str
    words: str
    numbers: Sequence[str | int]

    @property
    def pattern(self) -> re.Pattern[str]:
        """Finds the sentence in its page, on however many lines."""
        parts = [r"\s+".join(map(re.escape, re.split(r"\s+", part))) for part in self.words.split("{}")]
        return re.compile(f"({NUMBER})".join(parts))

    def written(self, content: str) -> str:
        """The page with the numbers of its tables."""
        matches = list(self.pattern.finditer(content))
        if len(matches) != 1:
            raise SystemExit(f"{self.page} has this sentence {len(matches)} times instead of once: {self.words}")
        for group, new in reversed(list(enumerate(self.numbers, 1))):
            begin, end = matches[0].span(group)
            content = content[:begin] + str(new) + content[end:]
        return content


def sentences() -> list[Sentence]:
    """All sentences whose numbers are those of tables."""
    return [*readme(), *headlines(), *other_pages()]


def readme() -> list[Sentence]:
    """The five results of the first page."""
    panda = motionbenchmaker("motionbenchmaker")
    solved, asked, medians, worst = programs()
    made, tried, least, most, longest = two_arms()
    page = "README.md"
    return [
        Sentence(page, "MotionBenchMaker, Panda: {} problems, {} of them beyond limits", [panda.all, panda.refused]),
        Sentence(
            page, "all {} others solved and proven; {} s in the median, 95 %: {} s", [panda.proven, panda.median, panda.high]
        ),
        Sentence(page, "timed motions that are free by the meshes | {} of {}; mplib {}", timed_motions()),
        Sentence(page, "{} of {}; {} and {} s in the median, {} s at most", [solved, asked, *medians, worst]),
        Sentence(page, "{} of {}; {} to {} s in the median, {} s at most", [made, tried, least, most, longest]),
        Sentence(page, "collision rows, from Python | {} µs, 99 %: {} µs", step("along a path of 0.3 m", "10 ms")),
    ]


def headlines() -> list[Sentence]:
    """The rows of the first table of the page on benchmarks, and of those at the head of its chapters."""
    page = "docs/benchmarks.md"
    kinematics, control, plans = (f"docs/measured/{each}.md" for each in ("kinematics", "servo", "plans"))
    panda, ur5 = motionbenchmaker("motionbenchmaker"), motionbenchmaker("motionbenchmaker_ur5")
    _, asked, medians, worst = programs()
    made, tried, least, most, longest = two_arms()
    alone = sum(int(row["solved one arm after the other"]) for row in rows("two_arms", "solved one arm after the other"))
    by_moves = [int(cell("programs", "all", "solved move by move", nth)) for nth in (0, 1)]
    suites = ("free pairs", "five boxes", "shelf")
    ours = "this version: median, 95 % [ms]"
    old = "older over this: median of the problems, lowest 5 %"
    lower = "g not above the older one's by more than 1 %"
    kept = [(int(number("against_01", suite, lower)), int(number("against_01", suite, lower, 1))) for suite in suites]
    trajopt = "tesseract, TrajOpt with AvoidSingularity"
    drake = "drake, B-splines, the cost is g"
    share, time = "of its free paths, ours lower", "ours over its processor time, median"
    return [
        Sentence(
            page,
            "one q from Python | {} µs; {} µs without a compiler | {} and {} times faster than Pinocchio with NumPy",
            [
                shown(1, "kinematics", "the same, ours compiled", "time"),
                shown(1, "kinematics", "the same, ours in CasADi's virtual machine", "time"),
                shown(0, "kinematics", "the same, ours compiled", "faster"),
                shown(1, "kinematics", "the same, ours in CasADi's virtual machine", "faster"),
            ],
        ),
        Sentence(page, "in four kinds of scenes | {} of {} | mplib {} |", timed_motions()),
        Sentence(
            page,
            "{} paths of the tool among two cubes, four arms, met to {} mm and {}° | all followed, {} of them without "
            "interruption; {} keep CppFlow's rule, {} break it by large joint steps; these {} take {} s in the median, {} s at "
            "most | each of the {} that connect on a grid ten times finer is among the {}; minimum manipulability over that "
            "grid's: {} in the median, {} at worst |",
            tool_paths(),
        ),
        Sentence(
            page,
            "median and worst | {}, {}; of {} random streams {} stall for a moment, {} avoidably, and {} move backward, {} "
            "avoidably | placo {}, {}; J-PARSE {}, {};",
            servo(),
        ),
        Sentence(
            kinematics,
            "the exact Hessian of m of the Panda, one q | {} µs; {} µs without a compiler | {} and {} times faster",
            [
                shown(1, "kinematics", "the same, exact, ours compiled", "time"),
                shown(1, "kinematics", "the same, exact, ours in CasADi's virtual machine", "time"),
                rounded(number("kinematics", "the same, exact, ours compiled", "faster")),
                rounded(number("kinematics", "the same, exact, ours in CasADi's virtual machine", "faster"), 3),
            ],
        ),
        Sentence(
            kinematics,
            "a million configurations of the Panda, one thread | {} ns each | {} times faster than CasADi's compiled map",
            [
                rounded(number("kinematics", "ours, 10⁶ q, one thread", "time")),
                shown(0, "kinematics", "10⁶ q: faster than CasADi's compiled map of sqrt(det(J Jᵀ))", "value"),
            ],
        ),
        Sentence(
            page,
            "median, 99 % | {} µs, {} µs; {} to {} µs without a compiler | placo {} µs, {} µs; pink {} µs, {} µs;",
            [
                *step("along a path of 0.3 m", "10 ms"),
                *(shown(0, "tracking", f"ours, {each}, without a compiler", "median") for each in ("(14)", "LogDrive")),
                *(shown(1, "tracking", "placo, with its manipulability term", each) for each in ("median", "99 %")),
                *(shown(0, "tracking", "pink, with its manipulability term", each) for each in ("median", "99 %")),
            ],
        ),
        Sentence(control, "from rest, at 1 ms | {} µs, {} µs |", step("at rest, target 0.2 mm away", "1 ms")),
        Sentence(
            control,
            "edge of reach {} times placo's, on one {} times, on three the same; {} to {} times that of the Robotics Toolbox",
            gains_of_tracking(),
        ),
        Sentence(
            kinematics,
            "verified | {} µs; xArm7 {} to {} µs | {} to {} times faster than EAIK, which builds a robot for each value; "
            "{} to {} times where one value is held; on the xArm7 ssik is {} to {} times faster than ours",
            inverse_kinematics(),
        ),
        Sentence(
            kinematics,
            "exact search among 45,000 synthetic candidates | {} to {} ms | {} times faster than a dense dynamic programme, "
            "{} times faster than a ladder graph",
            search(),
        ),
        Sentence(
            plans,
            "1,000 random pairs of the Panda, optimised: median, 95 %, worst time | {} ms, {} ms, {} ms;",
            [shown(0, "panda_pairs", "median, 95 %, worst time", "value", place) for place in range(3)],
        ),
        Sentence(
            page,
            "{} times the first path's g in the median, {} times in the worst tenth | on {} pairs lower g than all free paths "
            "of TrajOpt with its term for singularities, in {} times its time, and than {} % of the paths of drake with g as "
            "its cost that touch nothing, in {} times",
            [
                shown(2, "path_suite", "with obstacles", "g over the first path's, median"),
                shown(2, "path_suite", "with obstacles", "90 % below"),
                shown(0, "path_suite", trajopt, "pairs"),
                shown(2, "path_suite", trajopt, time),
                shown(0, "path_suite", drake, share),
                shown(2, "path_suite", drake, time),
            ],
        ),
        Sentence(
            page,
            "{} of {} get a motion, {} of the {} inside the limits a proven one that the meshes call free; time, median and "
            "95 %: {} s, {} s |",
            [panda.solved, panda.all, panda.proven, panda.inside, panda.median, panda.high],
        ),
        Sentence(
            page,
            "on the first 8 of each set {} times the time of mplib in the median, lower g on all {} that both solve; "
            "{} of mplib's {} motions are free",
            [
                shown(2, "motionbenchmaker_mplib", "all", "ours over mplib's, of each problem: median"),
                shown(0, "motionbenchmaker_mplib", "all", "both solve"),
                shown(0, "motionbenchmaker_mplib", "all", "mplib's free by the meshes"),
                shown(0, "motionbenchmaker_mplib", "all", "mplib's free by the meshes", 1),
            ],
        ),
        Sentence(
            page,
            "{} programs of eight moves in two sets, Panda, UR5, xArm7",
            [asked],
        ),
        Sentence(page, "{} s and {} s in the median, {} s at most | moves planned", [*medians, worst]),
        Sentence(
            page,
            "one by one solve {}; the minimum manipulability is at least theirs in all, {} times theirs in the median of "
            "the {} that differ",
            [
                sum(by_moves),
                shown(2, "programs", "all", "median of those", nth=1),
                shown(0, "programs", "all", "number that differ", nth=1),
            ],
        ),
        Sentence(
            page,
            "{} of {} proven; {} s to {} s in the median, {} s at most | one arm after the other solves {}",
            [made, tried, least, most, longest, alone],
        ),
        Sentence(
            page,
            "{} get a proven motion, all optimised, {} OPTIMAL; processor time, median and 95 %: {} s, {} s |",
            [ur5.proven, ur5.optimal, ur5.median, ur5.high],
        ),
        Sentence(
            plans,
            "median of the processor time | {} ms, {} ms, {} ms | version 0.1 takes {}, {} and {} times as long; "
            "g is lower on average, and more than 1 % higher on {} of {} |",
            [
                *(shown(0, "against_01", suite, ours) for suite in suites),
                *(shown(1, "against_01", suite, old) for suite in suites),
                sum(of - good for good, of in kept),
                sum(of for _, of in kept),
            ],
        ),
        Sentence(
            plans,
            "{} random pairs of the UR5, UR10, Z1 and Kinova, across singularities | all OPTIMAL; {} s, {} s | "
            "g at most {} times the straight line's, {} in the median",
            [
                shown(0, "six_joint_arms", "all", "pairs"),
                shown(2, "six_joint_arms", "all", "wall time: median, worst"),
                shown(1, "six_joint_arms", "all", "wall time: median, worst", 1),
                shown(2, "six_joint_arms", "all", "g over the straight line's: median, largest", 1),
                shown(2, "six_joint_arms", "all", "g over the straight line's: median, largest"),
            ],
        ),
    ]


def other_pages() -> list[Sentence]:
    """Sentences of other pages."""
    panda = motionbenchmaker("motionbenchmaker")
    few = "crossings as few as the bound"
    median, longest = text("recorded_motions", r"CPU time per call: median ([\d.]+) s, largest ([\d.]+) s")
    ours = "this version: median, 95 % [ms]"
    path, fast, rest = (
        step(case, period)
        for case, period in (
            ("along a path of 0.3 m", "10 ms"),
            ("along a path of 0.3 m", "1 ms"),
            ("at rest, target 0.2 mm away", "1 ms"),
        )
    )
    tracking = "docs/concepts/tracking.md"
    return [
        Sentence(tracking, "{} µs, called from Python, along a path at 10 ms, and {} µs at 1 ms", [path[0], fast[0]]),
        Sentence(
            tracking,
            "active: {} µs from rest towards a target 0.2 mm away, with three joints at their acceleration limit; there one "
            "step in a hundred takes more than {} µs",
            [rest[0], f"{float(rest[1]):.0f}"],
        ),
        Sentence(
            "docs/limits.md",
            "of {} random pairs of four arms {} % cross as often as the lower bound",
            [shown(0, "six_joint_arms", "all", "pairs"), shown(0, "six_joint_arms", "all", few)],
        ),
        Sentence(
            "docs/limits.md",
            "Of MotionBenchMaker's {} problems of the Panda {} are refused",
            [panda.all, panda.refused],
        ),
        Sentence(
            "docs/concepts/which-job.md",
            "{} ms without obstacles, {} ms among five boxes, {} s in MotionBenchMaker's scenes, in the median",
            [
                *(shown(0, "against_01", suite, ours) for suite in ("free pairs", "five boxes")),
                panda.median,
            ],
        ),
        Sentence("docs/concepts/which-job.md", "{} s in the median, {} s at most for a recording", [median, longest]),
    ]


@dataclass(frozen=True)
class Solved:
    """What became of MotionBenchMaker's problems of one arm, and the processor times [s]."""

    all: int
    refused: int
    solved: int
    inside: int
    proven: int
    optimal: int
    median: str
    high: str


def motionbenchmaker(name: str) -> Solved:
    """From the table of an arm."""
    solved, asked, proven, inside = text(
        name, r"(\d+) of (\d+) get a motion, .*? (\d+) of the (\d+) inside the limits get one that is proven"
    )
    times = "processor time: median, 95 %"
    return Solved(
        all=int(asked),
        refused=int(number(name, "all", "refused: beyond a joint limit") + number(name, "all", "refused: not free")),
        solved=int(solved),
        inside=int(inside),
        proven=int(proven),
        optimal=int(number(name, "all", "optimised, converged")),
        median=shown(2, name, "all", times),
        high=shown(2, name, "all", times, 1),
    )


def programs() -> tuple[int, int, list[str], str]:
    """Programs solved and asked, the medians of both sets and the longest time [s]."""
    sets = [row for row in rows("programs", "median time") if [*row.values()][-1] == "all"]
    seconds = [(float(row["median time"].split()[0]), float(row["largest"].split()[0])) for row in sets]
    solved, asked = (sum(int(row[column]) for row in sets) for column in ("solved and proven", "number"))
    return solved, asked, [f"{median:.2f}" for median, _ in seconds], f"{max(worst for _, worst in seconds):.1f}"


def two_arms() -> tuple[int, int, str, str, str]:
    """Problems of two arms solved and asked, the least and the largest median and the longest time [s]."""
    robots = rows("two_arms", "time: median")
    medians = [float(row["time: median"].split()[0]) for row in robots]
    solved, asked = (sum(int(row[column]) for row in robots) for column in ("solved and proven", "problems"))
    longest = max(float(row["largest"].split()[0]) for row in robots)
    return solved, asked, f"{min(medians):.1f}", f"{max(medians):.1f}", f"{longest:.1f}"


def timed_motions() -> list[str]:
    """Our motions that the meshes call free, how many there are, and mplib's."""
    ours = [shown(0, "timed_motions", "all", "ours free by the meshes", place) for place in (0, 1)]
    return [*ours, shown(0, "timed_motions", "all", "mplib's free by the meshes")]


def step(case: str, period: str) -> list[str]:
    """Median and 99 % of a control step of LogDrive with five collision rows [µs]."""
    [row] = [
        row
        for row in rows("control_step", "median")
        if (row["case"], row["time step"], row["formulation"], row["collision rows"]) == (case, period, "LogDrive", "5")
    ]
    return [f"{float(row[column].split()[0]):.1f}" for column in ("median", "99 %")]


def gains_of_tracking() -> list[str]:
    """Minimum manipulability over placo's on two paths, and least and largest over that of the Robotics Toolbox."""
    column = "ours, minimum manipulability"
    gains = {
        solver: [float(row[column].split(",")[1].strip(" x")) for row in rows("tracking", column) if row["solver"] == solver]
        for solver in ("placo", "rtb")
    }
    first, second, *others = sorted(gains["placo"], reverse=True)
    if max(others) > 1.05:
        raise SystemExit("docs/benchmarks/tracking.md: placo's minimum is below ours on more than two paths")
    return [f"{first:.0f}", f"{second:.0f}", f"{min(gains['rtb']):.1f}", f"{max(gains['rtb']):.1f}"]


def inverse_kinematics() -> list[str]:
    """Times of all configurations of a pose [µs], EAIK's over ours, and ours over ssik's on the xArm7."""
    name = "inverse_kinematics"
    each, held, ours, xarm7 = [list[float]() for _ in range(4)]
    for row in rows(name, "EAIK over ours"):
        ratio, time = row["EAIK over ours"].strip(" x"), row["time each [µs]"]
        if row["asked"].startswith("1000 values of the joint"):
            (xarm7 if row["arm, held"].startswith("xarm7") else ours).append(float(time))
        if ratio:
            (each if row["asked"].startswith("1000 values") else held).append(float(ratio))
    [row] = [row for row in rows(name, "ssik: answers a pose") if row["arm"] == "xarm7"]
    columns = ("in a batch", "µs an answer, one by one")
    slower = [float(row[column]) / float(row["µs an answer"]) for column in columns]
    return [
        f"{sum(ours) / len(ours):.1f}",
        *(f"{time:.0f}" for time in (min(xarm7), max(xarm7))),
        *(f"{ratio:.0f}" for ratio in (min(each), max(each), min(held))),
        f"{max(held):.1f}",
        *(f"{ratio:.1f}" for ratio in slower),
    ]


def tool_paths() -> list[str | int]:
    """The paths of the tool among two cubes that a script made."""
    name, row, fine = "tool_paths", "all made", "minimum m over that of the finer grid: median, least"
    time, connect = "time without interruption: median, 95 %, largest", "of those that connect on the finer grid"
    followed, kept = shown(0, name, row, "followed without interruption"), int(number(name, row, "CppFlow's rule kept"))
    [met] = set(text(name, r"a tolerance of ([\d.]+) mm"))
    [turned] = set(text(name, r"a tolerance of [\d.]+ mm and ([\d.]+)°"))
    number_of = int(number(name, row, "number"))
    if number(name, row, connect) != number(name, row, connect, 1):
        raise SystemExit("docs/benchmarks/tool_paths.md: a path that connects on the finer grid is interrupted")
    return [
        *(number_of, met, turned, followed, kept, number_of - kept, followed),
        *(shown(1, name, row, time, place) for place in (0, 2)),
        *(shown(0, name, row, connect), followed),
        *(shown(2, name, row, fine, place) for place in (0, 1)),
    ]


def servo() -> list[str]:
    """Shares of the command followed near singularities, and what became of random streams."""
    near = "share near: median, worst"
    laws = ("mp.Servo", "placo 0.10, as it comes", "J-PARSE, γ = 0.1")
    ours, placo, jparse = ([shown(2, "servo", law, near, place) for place in (0, 1)] for law in laws)
    found = r"(\d+) stall, avoidably (\d+), and (\d+) have a sample that moves backward, avoidably (\d+)"
    number_of, *others = text("servo_random", r"Of (\d+) streams of 20 s, " + found)
    return [*ours, f"{int(number_of):,}", *others, *placo, *jparse]


def search() -> list[str]:
    """The least and largest time of the exact search [ms], and the times of two other methods over the least."""
    exact = [1000 * number("search", f'exact, prefer="{each}"', "time") for each in ("first", "shortest", "lexicographic")]
    others = ("dense dynamic programme, as CppFlow's, NumPy", "ladder graph, as Descartes', NumPy")
    return [
        f"{min(exact):.0f}",
        f"{max(exact):.0f}",
        *(shown(0, "search", other, "of the exact search") for other in others),
    ]


def write(root: Path = ROOT) -> list[str]:
    """Write the numbers into the pages; returns the pages that changed."""
    every, changed = sentences(), []
    for page in dict.fromkeys(each.page for each in every):
        before = content = (root / page).read_text(encoding="utf-8")
        for each in every:
            if each.page == page:
                content = each.written(content)
        if content != before:
            (root / page).write_text(content, encoding="utf-8")
            changed.append(page)
    return changed


if __name__ == "__main__":
    sys.stdout.write("".join(f"wrote {page}\n" for page in write()) or "all numbers are those of the tables\n")
