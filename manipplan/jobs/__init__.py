"""Whole tasks: plan, follow, improve, and the check of what came out.

In: a robot and what it has to do. Out: a Plan with path, trajectory and Report, which files can keep.
Success is reported after an independent check only.
"""
