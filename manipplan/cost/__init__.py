"""What a path costs: g, its integrand and its metric.

In: a path and the kinematics whose measure counts. Out: g to ten digits, and the integrand as functions for the optimiser.
The minimum manipulability of a path is measured here, too.
"""
