"""A path becomes a motion.

In: a joint path and limits. Out: the fastest Trajectory that was found, verified against every limit.
Speed, acceleration and torque are solved by toppra, jerk by a barrier method.
"""
