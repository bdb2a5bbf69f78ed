"""Compares the pictures of README and pages with those that are committed: python docs/compare_pictures.py.

The last step of `make pictures`. Prints what looks different and ends with 1 if anything does. Renderers and fonts differ by a
little from machine to machine.
"""

import io
import re
import subprocess
import sys
from pathlib import Path

import numpy as np
from PIL import Image, ImageSequence

ROOT = Path(__file__).parents[1]
FOLDERS = ("docs/_static", "docs/pictures")
#: Width at which pictures are compared [pixels], and the largest mean difference, of 255, of pictures that look the same.
WIDTH, SAME = 120, 4.0
#: Of a film, one frame out of this number is compared.
FRAMES = 10
#: Largest difference of a coordinate of a drawing.
APART = 1.0
NUMBER = re.compile(r"-?\d+(?:\.\d+)?(?:e-?\d+)?")


def difference(kind: str, old: bytes, new: bytes) -> str:
    """What differs between two files of a kind, such as ".png"; empty if they look the same."""
    return _of_drawings(old.decode(), new.decode()) if kind == ".svg" else _of_pictures(old, new)


def _of_drawings(old: str, new: str) -> str:
    if NUMBER.sub("#", old) != NUMBER.sub("#", new):
        return "other shapes"
    far = max((abs(float(a) - float(b)) for a, b in zip(NUMBER.findall(old), NUMBER.findall(new), strict=True)), default=0.0)
    return "" if far <= APART else f"coordinates up to {far:.3g} apart"


def _of_pictures(old: bytes, new: bytes) -> str:
    before, after = (Image.open(io.BytesIO(data)) for data in (old, new))
    if before.size != after.size:
        return f"{after.width} x {after.height} pixels instead of {before.width} x {before.height}"
    frames = [_frames(each) for each in (before, after)]
    if len(frames[0]) != len(frames[1]):
        return f"{len(frames[1])} frames compared instead of {len(frames[0])}"
    apart = max(float(np.abs(a - b).mean()) for a, b in zip(*frames, strict=True))
    return "" if apart <= SAME else f"a mean difference of {apart:.1f} of 255"


def _frames(image: Image.Image) -> list[np.ndarray]:
    """Every tenth frame, small."""
    size = WIDTH, round(WIDTH * image.height / image.width)
    every = [frame.convert("RGB").resize(size) for k, frame in enumerate(ImageSequence.Iterator(image)) if k % FRAMES == 0]
    return [np.asarray(frame, dtype=float) for frame in every]


def main() -> int:
    """Compare every picture that changed."""
    listed = subprocess.run(
        ["git", "diff", "--name-only", "HEAD", "--", *FOLDERS], cwd=ROOT, capture_output=True, text=True, check=True
    )
    changed = [file for file in listed.stdout.split() if Path(file).suffix in (".png", ".jpg", ".webp", ".svg")]
    faults = 0
    for file in changed:
        old = subprocess.run(["git", "show", f"HEAD:{file}"], cwd=ROOT, capture_output=True, check=True).stdout
        told = difference(Path(file).suffix, old, (ROOT / file).read_bytes())
        faults += bool(told)
        print(f"{file}: {told or 'looks the same'}")
    print(f"{len(changed)} files changed, {faults} look different")
    return min(faults, 1)


if __name__ == "__main__":
    sys.exit(main())
