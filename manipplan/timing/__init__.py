"""A path becomes a motion.

In: a joint path and limits. Out: the fastest Trajectory that was found, verified against every limit.
Without jerk limits toppra finds it, with jerk limits a barrier method.
"""
