"""The whole study in one command."""

from pathlib import Path

from studies import command
from studies.dufour2020 import claims, config, figures, numerics, pareto
from studies.dufour2020.courses import Array
from studies.dufour2020.follow import Arm
from studies.dufour2020.scenarios import Comparison, Obstacle, Scenario, goals_in_collision, obstacle_table

#: Paths whose Pareto figure is drawn by --quick.
QUICK = ("S1",)
STEPS = 14
TIMED = 20


def study(out: Path, quick: bool, notify: command.Progress) -> list[claims.Claim]:
    """Make all tables and figures; returns the claims."""
    names = QUICK if quick else ("S1", "S2", *config.TABLE_1)
    whole, done, doing = STEPS + len(names) + (0 if quick else TIMED), 0, ""

    def advance(text: str | None = None) -> None:
        nonlocal done, doing
        done, doing = done + 1, text or doing
        notify(done / whole, doing)

    arm = Arm()
    first, second = Scenario.of(arm, "S1"), Scenario.of(arm, "S2")
    advance("scenarios 1 and 2")
    figures.scenario(first, out / "scenario1.png")
    figures.scenario(second, out / "scenario2.png")
    advance("computation times")
    figures.times(_times(arm), config.DT, out / "times.png")
    advance("scenario 3")
    sphere, blocking = Obstacle.of(arm, config.SPHERE), Obstacle.of(arm, config.BLOCKING)
    obstacle_table([sphere, blocking]).write(out)
    took = [arm.step_times("S1", "(10)", run.strength, avoidance=sphere.avoidance) for run in sphere.runs]
    figures.obstacle(sphere, took, out / "scenario3.png")
    stopped_table, stopped = goals_in_collision(arm)
    stopped_table.write(out)
    figures.stiffness(out / "stiffness.png")
    advance("scenario 4")
    comparison = Comparison.of(arm)
    comparison.table().write(out)
    numerics.best_alphas(comparison).write(out)
    figures.comparison(comparison, out / "scenario4.png")
    advance("claim 1")
    convexity = numerics.convexity(arm, comparison)
    convexity.write(out)
    figures.convexity(convexity, out / "claim1.png")
    advance("Hessians")
    table, hessians = numerics.hessians(arm)
    table.write(out)
    figures.hessians(hessians, out / "hessians.png")
    printed_table, printed = numerics.literal(arm)
    printed_table.write(out)
    advance("moved starts")
    spread_table, chatter = numerics.spreads(arm)
    spread_table.write(out)
    advance("recorded motions")
    recorded_table, recorded = numerics.recorded(arm)
    recorded_table.write(out)
    advance("all paths")
    table, everything = numerics.all_courses(arm)
    table.write(out)
    advance("return to the path")
    numerics.approaches(arm).write(out)
    advance("time step")
    numerics.time_step(arm)[0].write(out)
    advance("claims")
    found = claims.claims(arm, first, second, sphere, comparison, everything, printed)
    found += claims.best_alphas(comparison)
    found += claims.stopped(stopped)
    found += claims.recorded(recorded)
    found += claims.chaotic(convexity, hessians, chatter)
    claims.table(found).write(out)
    advance("deviation against manipulability")
    fronts = pareto.fronts(arm, names, advance)
    pareto.front_table(fronts).write_csv(out)
    pareto.tube_table(fronts).write(out)
    if not quick:
        priced = pareto.prices(arm, fronts)
        pareto.own_table(arm, priced, config.TABLE_1).write(out)
        figures.price(priced, out / "pareto.png")
    for name in names:
        figures.pareto(fronts, name, out / f"pareto_{name}.png")
    if not quick:
        figures.postures(arm, first, second, sphere, out / "postures.png")
        notify(done / whole, "step times")
        numerics.real_time(arm, sphere.avoidance, advance)[0].write(out)
    return found


def _times(arm: Arm) -> dict[str, Array]:
    return {
        f"{name}, {made}": arm.step_times(name, "(10)", config.ALPHA, compiled=compiled)
        for compiled, made in ((False, "no compiler"), (True, "compiled"))
        for name in ("S1", "S2")
    }


STUDY = command.Study(
    pages=config.PAGES,
    quick="Pareto figure of scenario 1 only, no comparison of step times",
    make=study,
    differences=lambda found, _: claims.differences(found),
)
