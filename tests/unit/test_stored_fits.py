"""Fitted capsules are kept on disk, and what is read is as it was written."""

import numpy as np
import pytest

from manipplan.collision import covers
from manipplan.collision.stored_fits import find_or_fit
from manipplan.collision.world import outside


@pytest.fixture
def cache(tmp_path, monkeypatch):
    monkeypatch.setenv("MANIPPLAN_CACHE", str(tmp_path))
    return tmp_path


@pytest.fixture
def triangles():
    return np.random.default_rng(3).normal(scale=0.1, size=(40, 3, 3))


@pytest.fixture
def fits(monkeypatch):
    """The calls of the fit."""
    calls = []
    fit = covers.fit_capsules

    def counted(*arguments, **options):
        calls.append(options)
        return fit(*arguments, **options)

    monkeypatch.setattr(covers, "fit_capsules", counted)
    return calls


def described(primitives):
    return [(type(each.shape).__name__, each.placement.homogeneous.tolist(), each.volume) for each in primitives]


@pytest.mark.slow
def test_a_mesh_is_fitted_once(cache, triangles, fits):
    first, second = find_or_fit(triangles), find_or_fit(triangles)
    assert len(fits) == 1 and described(first) == described(second)
    find_or_fit(triangles + 1e-9)
    assert len(fits) == 2


@pytest.mark.slow
@pytest.mark.parametrize(
    "spoil",
    [
        lambda stored: stored[:-9],
        lambda stored: b"",
        lambda stored: stored + b" ",
        lambda stored: stored.replace(b"0.", b"9."),
        lambda stored: stored[:32] + b"3",
    ],
    ids=["cut off", "empty", "longer", "other numbers", "a number"],
)
def test_spoilt_files_are_fitted_again(cache, triangles, fits, spoil):
    expected = find_or_fit(triangles)
    [file] = cache.rglob("capsules/*")
    file.write_bytes(spoil(file.read_bytes()))
    found = find_or_fit(triangles)
    assert len(fits) == 2 and described(found) == described(expected)
    depth = np.array([outside(each, covers.subdivide(triangles).reshape(-1, 3)) for each in found])
    assert depth.min(axis=0).max() == 0.0
    find_or_fit(triangles)
    assert len(fits) == 2


@pytest.mark.slow
def test_without_a_cache_folder_every_process_fits(tmp_path, monkeypatch, triangles, fits):
    (tmp_path / "file").write_text("")
    monkeypatch.setenv("MANIPPLAN_CACHE", str(tmp_path / "file" / "folder"))
    assert described(find_or_fit(triangles)) == described(find_or_fit(triangles))
    assert len(fits) == 2
