"""Collision-free seed paths.

In: a robot, a scene, start and goal. Out: a joint path found by our RRT-Connect or one of OMPL's planners.
A seed is proven free, or checked at every milliradian, before it is returned.
"""
