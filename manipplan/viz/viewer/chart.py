"""The measure over time as SVG, with a mark at the displayed time; a browser draws it without scripts."""

from collections.abc import Sequence
from dataclasses import dataclass
from html import escape

import numpy as np

from manipplan.support.checks import Array

#: Size of the drawing and its margins: left, right, top, bottom [px].
WIDTH, HEIGHT = 300, 170
LEFT, RIGHT, TOP, BOTTOM = 42, 8, 10, 30


@dataclass(frozen=True, kw_only=True, eq=False)
class ChartLine:
    """One curve: its name in the legend, its colour, and its values at the chart's times."""

    name: str
    colour: str
    values: Array


@dataclass(frozen=True, kw_only=True, eq=False)
class Chart:
    """Curves over the same times t (k,) [s], on an axis that includes zero; `label` gives quantity and unit.

    `marks`: times [s] with names, drawn as dotted lines that show their name under the mouse.
    """

    t: Array
    curves: Sequence[ChartLine]
    label: str
    marks: Sequence[tuple[float, str]] = ()

    def svg(self, now: float | None = None) -> str:
        """The picture; a line and a dot on each curve mark the time `now` [s]."""
        end, start = float(self.t[-1]), float(self.t[0])
        highest = max([float(np.max(c.values, initial=0.0)) for c in self.curves])
        lowest = min([float(np.min(c.values, initial=0.0)) for c in self.curves])
        highest = highest if highest > lowest else 1.0
        step = _round_step((highest - lowest) / 3)
        top, bottom = float(step * np.ceil(highest * 1.02 / step)), float(step * np.floor(lowest * 1.02 / step))

        across = LEFT + (WIDTH - LEFT - RIGHT) * (self.t - start) / max(end - start, 1e-9)

        def x(t: float) -> float:
            return float(np.interp(t, self.t, across))

        def y(value: float) -> float:
            return float(HEIGHT - BOTTOM - (HEIGHT - TOP - BOTTOM) * (value - bottom) / (top - bottom))

        parts = []
        for value in np.arange(bottom, top + step / 2, step):
            at = f"{y(value):.1f}"
            parts.append(f'<line x1="{LEFT}" x2="{WIDTH - RIGHT}" y1="{at}" y2="{at}" stroke="#e4e4e4"/>')
            parts.append(f'<text x="{LEFT - 5}" y="{at}" dy="3.5" text-anchor="end">{value:.6g}</text>')
        time_step = _round_step((end - start) / 4)
        for t in np.arange(np.ceil(start / time_step) * time_step, end + 1e-9, time_step):
            parts.append(f'<text x="{x(t):.1f}" y="{HEIGHT - BOTTOM + 13}" text-anchor="middle">{t:.6g}</text>')
        parts.append(f'<text x="{(LEFT + WIDTH - RIGHT) / 2}" y="{HEIGHT - 3}" text-anchor="middle">time [s]</text>')
        for begin, name in self.marks:
            ends = f'x1="{x(begin):.1f}" x2="{x(begin):.1f}" y1="{TOP}" y2="{HEIGHT - BOTTOM}"'
            lines = f'<line {ends} stroke="#999" stroke-dasharray="2 2"/><line {ends} stroke="transparent" stroke-width="6"/>'
            parts.append(f'<g class="mark"><title>{escape(name)}</title>{lines}</g>')
        for curve in reversed(self.curves):
            points = " ".join(f"{place:.1f},{y(value):.1f}" for place, value in zip(across, curve.values, strict=True))
            parts.append(f'<polyline points="{points}" fill="none" stroke="{curve.colour}" stroke-width="2"/>')
        if now is not None:
            here, foot = f"{x(now):.1f}", HEIGHT - BOTTOM
            parts.append(f'<line class="now" x1="{here}" x2="{here}" y1="{TOP}" y2="{foot}" stroke="#333"/>')
            for curve in reversed(self.curves):
                height = f"{y(float(np.interp(now, self.t, curve.values))):.1f}"
                parts.append(f'<circle cx="{here}" cy="{height}" r="4" fill="{curve.colour}" stroke="#fff"/>')
        return (
            f'<svg viewBox="0 0 {WIDTH} {HEIGHT}" width="100%" role="img" aria-label="{escape(self.label)} over time" '
            f'font-family="sans-serif" font-size="10.5" fill="#444">{"".join(parts)}</svg>'
        )

    def html(self, now: float | None = None) -> str:
        """Legend and picture."""
        keys = " ".join(
            f'<span style="white-space:nowrap;margin-right:0.8em"><span style="color:{curve.colour}">&#9644;</span> '
            f"{escape(curve.name)}</span>"
            for curve in self.curves
        )
        keys = f"<br>{keys}" if len(self.curves) > 1 else ""
        return (
            f'<div style="padding:0 0.75em;font:12px sans-serif;color:#333"><div style="margin:0.3em 0">'
            f"{escape(self.label)}{keys}</div>{self.svg(now)}</div>"
        )


def _round_step(rough: float) -> float:
    """1, 2 or 5 times a power of ten, at least `rough`."""
    power = 10.0 ** np.floor(np.log10(max(rough, 1e-12)))
    return float(next(k * power for k in (1, 2, 5, 10) if k * power >= rough * (1 - 1e-9)))
