"""Steady: motions on which the tool has a constant speed between a ramp at either end.

In come a joint path and a speed of the tool; a Trajectory comes out, or an error that names the fastest speed the path allows.
"""
