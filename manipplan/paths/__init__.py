"""Geometry over a parameter and over time: joint paths, paths of the tool, trajectories.

In: control points, poses or recorded samples. Out: curves with derivatives, and files in the formats of others.
Tolerance and Deviation say how far a motion may be, or is, from a path.
"""
