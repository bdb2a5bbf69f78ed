"""Compares the results of a study with its expected.csv."""

from collections.abc import Iterable, Mapping


def differences(values: Mapping[str, float], wanted: Iterable[tuple[str, float, float]]) -> list[str]:
    """One line per value that is out of tolerance or not in both; `wanted` has name, value and tolerance."""
    bounds = {name: (value, tolerance) for name, value, tolerance in wanted}
    missing = [f"{name}: not in both" for name in sorted(values.keys() ^ bounds.keys())]
    return missing + [
        f"{name}: {values[name]:g}, expected {value:g} within {tolerance:g}"
        for name, (value, tolerance) in bounds.items()
        if name in values and not abs(values[name] - value) <= tolerance
    ]
