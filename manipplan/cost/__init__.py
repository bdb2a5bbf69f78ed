"""The cost g of a path, its integrand and its metric.

In: a path and the kinematics with the measure. Out: g to ten digits, and the integrand as functions for the optimiser.
The minimum manipulability of a path is computed here, too.
"""
