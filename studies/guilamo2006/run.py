"""The whole study in one command."""

from pathlib import Path

from studies import command
from studies.guilamo2006 import claims, config, figures, tables
from studies.guilamo2006.courses import courses, second_courses
from studies.guilamo2006.results import Results
from studies.guilamo2006.runs import Runs, warm


def study(out: Path, quick: bool, notify: command.Progress) -> list[claims.Claim]:
    """Make all tables and figures; returns the claims."""
    results = Results(runs=Runs(), courses=courses(), second=second_courses(), quick=quick)
    found: list[claims.Claim] = []
    command.in_stages(stages(results, out, found), notify)
    return found


def stages(results: Results, out: Path, found: list[claims.Claim]) -> list[command.Stage]:
    """The stages of the study, each with its approximate duration [s] on two idle cores."""
    runs, pair, quick = results.runs, results.courses, results.quick
    full = [] if quick else [("self-collisions", 10.0, lambda: tables.collisions_table(runs, pair).write(out))]
    return [
        ("compiling", 3.0, lambda: warm(runs, pair[0])),
        *full,
        ("sampling", 1.5 if quick else 9.0, results.sample),
        ("Table I", 0.5 if quick else 22.0, lambda: tables.table_1(runs, pair, results.table_grids).write(out)),
        ("starts", 0.1, lambda: tables.starts_table(runs, pair, results.table_grids).write(out)),
        ("ε and grid", 2.0 if quick else 18.0, lambda: tables.sampling_table(runs, pair, results.grids).write(out)),
        ("resolution", 0.1, lambda: tables.resolution_table(runs, pair[0], results.even_grids).write(out)),
        ("branching", 3.0, lambda: tables.branching_table(results.branching).write(out)),
        ("refinement", 6.0 if quick else 13.0, lambda: tables.refinement_table(runs, results.refinable).write(out)),
        ("ties", 0.1 if quick else 6.5, lambda: tables.ties_table(runs, results.ties).write(out)),
        ("cycles", 0.3 if quick else 10.0, lambda: tables.closed_table(results.cycles).write(out)),
        ("positions", 0.8 if quick else 5.0, lambda: tables.positions_table(runs, pair[1], results.table_grids).write(out)),
        ("second robot", 4.5 if quick else 3.5, lambda: tables.second_table(runs, results.second).write(out)),
        ("figures", 4.0 if quick else 3.0, lambda: figures.all_figures(results, out)),
        ("claims", 0.5, lambda: found.extend(claims.claims(results))),
        ("claims", 0.1, lambda: claims.table(found).write(out)),
    ]


STUDY = command.Study(
    pages=config.PAGES,
    quick="the coarse grids only",
    make=study,
    differences=lambda found, quick: claims.differences(found, quick=quick),
)
