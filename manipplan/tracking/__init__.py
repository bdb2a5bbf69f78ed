"""A controller that raises manipulability while the tool follows a path.

In: the arm's state and a target. Out: joint velocities, from one quadratic program per step, also as exported C.
`track` runs it along a whole path [dufour2020].
"""
