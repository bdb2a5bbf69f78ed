"""What every configuration of a free motion has to keep, beside limits and clearance: a level tool, a place, held joints.

In: constraints, a robot, configurations or a path. Out: rows c(q) >= 0 with derivatives, and a proof for the whole path.
Seeds, the path optimiser and the check of trajectories share them.
"""
