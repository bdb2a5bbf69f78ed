"""URScript: a program for the controllers of Universal Robots, which follows a motion by servoj."""

from pathlib import Path

import numpy as np

from manipplan.paths.controllers.sampled import ControllerFormat, sampled
from manipplan.paths.trajectory import Trajectory
from manipplan.support.checks import number
from manipplan.support.errors import InvalidInputError
from manipplan.support.files import write_text
from manipplan.support.untrusted import is_identifier

#: Rates of the controllers: CB3, and e-Series [Hz].
RATES = (125, 500)
#: Distance of a joint from the first configuration up to which the program begins [rad].
NEAR = 0.01
#: The arms, and the largest speed of any of their joints, that of the UR3's wrist [rad/s].
UR = ControllerFormat(
    name="a UR arm",
    joints=tuple((f"{each}_joint",) for each in ("shoulder_pan", "shoulder_lift", "elbow", "wrist_1", "wrist_2", "wrist_3")),
    lower=np.full(6, -2 * np.pi - 1e-9),
    upper=np.full(6, 2 * np.pi + 1e-9),
)
FASTEST = 2 * np.pi
#: Ranges of servoj's arguments, by the manual of URScript.
LOOKAHEAD, GAIN = (0.03, 0.2), (100, 2000)


def to_urscript(trajectory: Trajectory, file: str | Path, *, rate: int, name: str, lookahead_time: float, gain: float) -> None:
    """Write the program; see `Trajectory.to_urscript`."""
    if isinstance(rate, bool) or not isinstance(rate, int | np.integer) or rate not in RATES:
        raise InvalidInputError("rate", rate, "125 (CB3) or 500 (e-Series) [Hz]")
    if not isinstance(name, str) or not is_identifier(name):
        raise InvalidInputError("name", name, "a name of letters, digits and underscores that begins with a letter")
    lookahead_time = number("lookahead_time", lookahead_time, least=LOOKAHEAD[0], most=LOOKAHEAD[1])
    gain = number("gain", gain, least=GAIN[0], most=GAIN[1])
    q = sampled(trajectory, UR, rate)
    speed = np.abs(np.diff(q, axis=0)).max(initial=0.0) * rate
    if speed > FASTEST:
        raise InvalidInputError("trajectory", f"a joint speed of {speed:.4g} rad/s", f"at most {FASTEST:.4g} rad/s")
    away = " or ".join(f"norm(here[{k}] - ({value!r})) > {NEAR!r}" for k, value in enumerate(q[0].tolist()))
    order = f"t={1 / rate!r}, lookahead_time={lookahead_time!r}, gain={gain:g}"
    lines = [
        f"# {len(q)} positions at {rate} Hz, {trajectory.duration:.4f} s",
        f"def {name}():",
        "  here = get_actual_joint_positions()",
        f"  if {away}:",
        '    popup("The arm is not where this motion begins.", title="manipplan", error=True, blocking=True)',
        "    halt",
        "  end",
        *(f"  servoj([{', '.join(repr(value) for value in each)}], {order})" for each in q.tolist()),
        "  stopj(2.0)",
        "end",
        f"{name}()",
    ]
    write_text(file, "\n".join(lines) + "\n")
