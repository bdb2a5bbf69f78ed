"""The whole study in one command."""

from pathlib import Path

from studies import command
from studies.kth2012 import claims, config, eikonal, tables_beyond, tables_global, tables_more, tables_paths, tables_postures
from studies.kth2012.figures import FULL_ONLY, figures
from studies.kth2012.results import Results
from studies.tables import Table


def study(out: Path, quick: bool, notify: command.Progress) -> list[claims.Claim]:
    """Make all tables and figures; returns the claims."""
    if not quick:
        eikonal.marching()
    results, found = Results(quick=quick), []
    command.in_stages(stages(results, out, found), notify)
    return found


def stages(results: Results, out: Path, found: list[claims.Claim]) -> list[command.Stage]:
    """The stages of the study, each with its approximate duration [s] on two idle cores."""
    quick = results.quick

    def written(*tables: Table) -> None:
        for table in tables:
            table.write(out)

    drawn = {name: write for name, write in figures(results).items() if not (quick and name in FULL_ONLY)}
    beyond: list[command.Stage] = [
        ("proportions", 3.5, lambda: written(tables_postures.proportions_table(results))),
        ("goals by full turns", 3.0, lambda: written(tables_beyond.torus_table(results), tables_beyond.shifts_table(results))),
        ("convergence", 4.0, lambda: written(tables_beyond.convergence_table(results), tables_beyond.two_links_table(results))),
        ("posts", 25.0, lambda: written(tables_beyond.obstacles_table(results))),
        ("more links", 3.0, lambda: written(tables_beyond.links_table(results))),
        ("global optimum", 60.0, lambda: written(tables_global.global_table(results), tables_global.turns_table(results))),
        ("global optimum among posts", 90.0, lambda: written(tables_global.global_posts_table(results))),
        ("random pairs", 60.0, lambda: written(tables_global.pairs_table(results))),
    ]
    return [
        ("theorems", 1.0, lambda: written(tables_postures.theorems_table(tables_postures.theorems()))),
        ("Table 5.1", 0.1, lambda: written(tables_postures.table_5_1(results), tables_postures.stationary_table(results))),
        ("Table 5.2", 0.1, lambda: written(tables_postures.table_5_2(results))),
        ("Tables 6.1 and 6.2", 2.0, lambda: written(*tables_paths.path_tables(results))),
        ("Table 6.3", 0.5, lambda: written(tables_paths.table_6_3(results), tables_paths.costs_6_3(results))),
        ("Table 6.4", 0.1, lambda: written(tables_paths.table_6_4(results))),
        ("statements", 3.0, lambda: written(tables_more.frobenius_table(), tables_more.workspaces_table())),
        ("curves", 1.0, lambda: written(tables_more.distances_table(results), tables_more.rounding_table(results))),
        ("homotopy classes", 0.5 if quick else 3.0, lambda: written(tables_beyond.classes_table(results))),
        *([] if quick else beyond),
        *((name, 0.2, lambda name=name, write=write: write(out / f"{name}.svg")) for name, write in drawn.items()),
        ("claims", 1.0, lambda: found.extend(claims.claims(results))),
        ("claims", 0.1, lambda: written(claims.table(found))),
    ]


STUDY = command.Study(
    pages=config.PAGES,
    quick="chapters 4 to 6 and the shortest classes only",
    make=study,
    differences=lambda found, quick: claims.differences(found, quick=quick),
)
