"""Runs a peer's script on a problem, in the peer's own environment."""

import os
import subprocess
import tempfile
from pathlib import Path

import numpy as np
from environments import FOLDER, HERE, PEERS, environment

__all__ = ["PEERS", "run_peer"]


def run_peer(peer: str, problem: dict, folder: Path = FOLDER, script: str = "steps") -> dict:
    """What the peer's script writes; of "steps" q, qd (N, n), time (N,) in s, failed (N,) and first error, see steps.py."""
    python = environment(peer, folder)
    with tempfile.TemporaryDirectory() as work:
        given, result = Path(work, "problem.npz"), Path(work, "result.npz")
        np.savez(given, **problem)
        one_thread = os.environ | {"OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"}
        command = [python, "-E", HERE / f"{peer}_{script}.py", given, result]
        said = subprocess.run(command, env=one_thread, capture_output=True, text=True, check=False)
        if said.returncode:
            raise RuntimeError(f"{peer} did not run:\n" + "\n".join(said.stderr.splitlines()[-8:]))
        with np.load(result) as found:
            return dict(found)
