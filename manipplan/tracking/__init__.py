"""A controller that raises manipulability while the tool follows a path.

It maps the arm's state and a target to joint velocities by one quadratic program per step, and can be exported as C.
`track` runs it along a whole path [dufour2020].
"""
