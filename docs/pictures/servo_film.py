"""Draw servo_laws.png and the film servo_laws.webp: the laws of benchmarks/servo.py on three streams.

Run: python docs/pictures/servo_film.py [--environments FOLDER]. Environments of the peers are made on the first run. The film
shows the stream to the edge of the reach and back.
"""

import argparse
import sys
from collections.abc import Iterator
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "benchmarks"))

import matplotlib.pyplot as plt
import numpy as np
from PIL import Image, ImageDraw, ImageFont
from servo import PEERS, Arm, Array, described, own_runs, peer_runs
from servo_judge import DT, Run
from servo_laws import LAWS, robot_of
from servo_streams import Stream, designed

import manipplan as mp
from manipplan.viz.motions import skeleton
from manipplan.viz.render import DrawnWay, Renderer
from manipplan.viz.style import OPTIMUM

HERE = Path(__file__).resolve().parent
PLOT, FILM = HERE / "servo_laws.png", HERE / "servo_laws.webp"
#: Streams of the plot, and what they do; that of the film.
SHOWN = {
    "ur5 elbow in and out": "UR5: to the edge and back, 5 times",
    "xarm7 zero start": "xArm7: from its zeros",
    "ur5 wrist past": "UR5: past a straight wrist, 8 times",
}
FILMED = "ur5 elbow in and out"
#: The worse settings of peers.
LEFT_OUT = (
    "pink 4.4, as it comes",
    "placo 0.10, less regularization",
    "roboplan-oink 0.7, as it comes",
    "EmbodiK 0.23, as it comes",
)
#: Motion backward, and the command.
BACKWARD, COMMAND = "#D55E00", "#D55E00"
#: Of the film: laws beside each other, width and height of an arm's picture and height of its texts [pixels].
COLUMNS, WIDTH, HEIGHT, HEAD = 5, 180, 150, 62
#: Its length in the stream [s], frames per second, and how many times as fast as in reality it is.
SECONDS, FPS, FASTER = 8.0, 10, 2.0
#: Colours of texts, of a bar that is empty, and of the background, which is that of the arms; room around the arms [m].
INK, EMPTY, PAPER, ROOM = "#464A50", "#DDE0E5", "#F4F5F7", 0.09
#: Length of the arrow of the command [m], and time over which the share that is written is averaged [s].
ARROW, AVERAGED = 0.25, 0.2


def name_of(law: str) -> str:
    """The law's name, without its setting."""
    return law.replace("`", "").partition(",")[0]


def shares(arm: Arm, run: Run, every: int = 10) -> tuple[Array, Array]:
    """Times (k,) [s], and the share (k,) of the command that the tool follows there."""
    at = np.arange(0, len(run.raw), every)
    commands = [arm.scaled(run.twist[i]) for i in at]
    moves = [arm.jacobian(run.q[i]) @ run.qd[i + 1] for i in at]
    return at * DT, np.array([c @ v / max(float(c @ c), 1e-6) for c, v in zip(commands, moves, strict=True)])


def motions(models: dict[str, Arm], streams: dict[str, Stream], environments: Path) -> dict[str, list[Run]]:
    """What each law does on the streams."""
    found = {name: own_runs(make, models, streams, []) for name, make in LAWS.items()}
    for peer in PEERS:
        found |= peer_runs(peer, models, streams, [], environments)
    return {name: runs for name, runs in found.items() if name not in LEFT_OUT}


def plot(found: dict[str, list[Run]], models: dict[str, Arm], streams: dict[str, Stream]) -> None:
    """How much of the command each law follows over time."""
    size = (9.5, 0.62 * len(found) + 0.8)
    figure, panels = plt.subplots(len(found), len(streams), figsize=size, sharex=True, sharey=True, layout="constrained")
    for line, (law, runs) in zip(panels, found.items(), strict=True):
        for ax, run, stream in zip(line, runs, streams.values(), strict=True):
            at, share = shares(models[stream.arm], run)
            ax.fill_between(at, 0, np.clip(share, 0, 1.2), color=OPTIMUM, linewidth=0)
            ax.fill_between(at, 0, np.clip(share, -1.2, 0), color=BACKWARD, linewidth=0)
            ax.axhline(0, color="0.6", linewidth=0.6)
            ax.set(ylim=(-0.5, 1.25), xlim=(0, 20), yticks=[0, 1], yticklabels=["0", "1"])
            ax.spines[["top", "right"]].set_visible(False)
        line[0].set_ylabel(name_of(law), rotation=0, ha="right", va="center")
    for ax, name in zip(panels[0], streams, strict=True):
        ax.set_title(SHOWN[name], fontsize=10)
    for ax in panels[-1]:
        ax.set_xlabel("time [s]")
    figure.savefig(PLOT, dpi=100)


def frames(found: dict[str, Run], arm: Arm, robot: mp.Robot) -> Iterator[Image.Image]:
    """The pictures of the film: each arm, the command as an arrow, and the share that the tool follows."""
    rows, steps = -(-len(found) // COLUMNS), round(SECONDS / DT)
    corners = np.array([(x, y, z) for x in (-ROOM, ROOM) for y in (-ROOM, ROOM) for z in (-ROOM, ROOM)])
    bones = np.concatenate([skeleton(robot, q) for run in found.values() for q in run.q[: steps + 1 : 200]])
    tools = {law: robot.kinematics().pose(run.q[:steps])[:, :3, 3] for law, run in found.items()}
    commands = np.array(next(iter(found.values())).twist[:steps])[:, :3]
    arrows = ARROW * commands / np.maximum(np.linalg.norm(commands, axis=1, keepdims=True), 1e-9)
    ends = np.concatenate([tools[law][::200] + arrows[::200] for law in found])
    window = np.full(round(AVERAGED / DT), DT / AVERAGED)
    followed = {law: np.convolve(shares(arm, run, 1)[1][:steps], window, "same") for law, run in found.items()}
    folder = Path(plt.matplotlib.get_data_path(), "fonts", "ttf")
    bold, plain = (ImageFont.truetype(str(folder / name), 13) for name in ("DejaVuSans-Bold.ttf", "DejaVuSans.ttf"))
    around = np.concatenate([(bones[:, None] + corners).reshape(-1, 3), ends])
    with Renderer(robot, mp.Scene(), around, (WIDTH, HEIGHT)) as renderer:
        for i in range(0, steps, round(FASTER / FPS / DT)):
            picture = Image.new("RGB", (COLUMNS * WIDTH, rows * (HEIGHT + HEAD)), PAPER)
            pen = ImageDraw.Draw(picture)
            for k, (law, run) in enumerate(found.items()):
                x, y = k % COLUMNS * WIDTH, k // COLUMNS * (HEIGHT + HEAD)
                way = DrawnWay(points=np.array([tools[law][i], tools[law][i] + arrows[i]]), colour=COMMAND)
                picture.paste(Image.fromarray(renderer.draw(run.q[i], [way])), (x, y + HEAD))
                share = float(followed[law][i])
                pen.text((x + 8, y + 8), name_of(law), INK, bold)
                pen.text((x + 8, y + 26), f"follows {100 * share:.0f} %", BACKWARD if share < -0.02 else INK, plain)
                pen.rectangle((x + 8, y + 48, x + WIDTH - 16, y + 55), fill=EMPTY)
                end = x + 8 + round((WIDTH - 24) * min(abs(share), 1.0))
                pen.rectangle((x + 8, y + 48, end, y + 55), fill=BACKWARD if share < 0 else OPTIMUM)
            yield picture


def main() -> None:
    """Draw both."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument(
        "--environments", type=Path, default=HERE.parents[1] / ".peers", help="folder of the peers' environments"
    )
    given = parser.parse_args()
    models = described()
    streams = {name: each for name, each in designed(models).items() if name in SHOWN}
    streams = {name: streams[name] for name in SHOWN}
    found = motions(models, streams, given.environments)
    plot(found, models, streams)
    k, arm = list(SHOWN).index(FILMED), streams[FILMED].arm
    first, *others = frames({law: runs[k] for law, runs in found.items()}, models[arm], robot_of(arm))
    first.save(FILM, save_all=True, append_images=others, duration=round(1000 / FPS), loop=0, quality=75, method=5)
    for file in (PLOT, FILM):
        print(f"wrote {file.name}, {file.stat().st_size // 1000} kB")


if __name__ == "__main__":
    main()
