"""Makes an environment of its own for each peer, from its pinned versions: `python environments.py [FOLDER]`."""

import subprocess
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
FOLDER = HERE.parents[1] / ".peers"
PEERS = ("pink", "placo", "mink", "roboplan", "rtb")


def environment(peer: str, folder: Path = FOLDER) -> Path:
    """The peer's python in `folder`, made if its pinned versions are not yet installed there."""
    pins = (HERE / f"{peer}.txt").read_text()
    place = Path(folder).resolve() / peer
    done, python = place / "installed.txt", place / "bin" / "python"
    if done.exists() and done.read_text() == pins:
        return python
    print(f"making the environment of {peer} in {place}", flush=True)
    subprocess.run([sys.executable, "-m", "venv", "--clear", place], check=True)
    (place.parent / ".gitignore").write_text("*\n")
    pip = [python, "-m", "pip", "install", "-q", "--disable-pip-version-check", "-r", HERE / f"{peer}.txt"]
    said = subprocess.run(pip, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
    if said.returncode:
        lines = [line for line in said.stdout.splitlines() if line.strip() and not line.startswith("WARNING")]
        raise RuntimeError(f"{peer} cannot be installed:\n" + "\n".join(lines[-8:]))
    done.write_text(pins)
    return python


if __name__ == "__main__":
    for peer in PEERS:
        try:
            print(environment(peer, *map(Path, sys.argv[1:2])))
        except RuntimeError as error:
            print(error)
