"""Curves over a parameter or over time: joint paths, tool paths, trajectories.

In: control points, poses or recorded samples. Out: curves with derivatives, and files in common formats.
Tolerance is how far a motion may leave a path, Deviation how far it does.
"""
