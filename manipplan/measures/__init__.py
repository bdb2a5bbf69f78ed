"""Measures of manipulability as expressions of the Jacobian, and ellipsoids.

In: the symbolic posture of an arm. Out: the value of a measure with its derivatives, its name and its unit.
`names` lists the measures that a user can choose by name.
"""
