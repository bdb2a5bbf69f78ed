"""``python -m manipplan``: the same as the command ``manipplan``."""

from manipplan.cli import run

run()
