"""Number of examples of a law: all in `make test-all`; in `make test` a fifth of them, at least three."""

import os

from hypothesis import settings

#: Set by tests/conftest.py when the slow tests are left out.
FEW = "MANIPPLAN_FEW_EXAMPLES"


def examples(count, **options):
    """Settings of a law with at most `count` examples and no deadline."""
    return settings(max_examples=max(count // 5, 3) if os.environ.get(FEW) else count, deadline=None, **options)
