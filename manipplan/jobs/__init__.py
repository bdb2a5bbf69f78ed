"""Complete jobs: plan, follow, carry, sequence, improve, many plans at once, and the check of any trajectory.

A job takes a robot and its task, and returns a Plan with path, trajectory and Report, which can be saved to files.
Success is reported only after an independent check.
"""
