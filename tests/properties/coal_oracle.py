"""A collision model whose kernel decides nothing, so that coal decides and measures everything."""

from types import SimpleNamespace

import numpy as np

from manipplan.collision.kernel import UNDECIDED


def by_coal(model):
    slow, pairs, n = model.copy(), len(model.pairs), model.robot.n
    slow.__dict__["_kernel"] = SimpleNamespace(
        check=lambda q, clearance: UNDECIDED,
        check_rows=lambda q, clearance: np.full(len(q), UNDECIDED),
        distances=lambda q, reach: np.full((len(q), pairs), np.nan),
        near=lambda q, reach: (np.arange(len(q) * pairs), np.full(len(q) * pairs, np.nan)),
        pair_distances=lambda q, chosen, reach: np.full(len(q), np.nan),
        interval_bounds=lambda q, slopes, chosen, reach, bends, motions: (np.full(len(q), np.nan), np.full(len(q), -np.inf)),
        least=lambda q, reach, step: None,
        witnesses=lambda q, chosen, leaves: np.full((len(q), 13 + n), np.nan),
        nearest_triangle=lambda q, pair: None,
    )
    return slow
