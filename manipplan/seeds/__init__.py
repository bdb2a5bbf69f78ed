"""First paths that are free of collision.

In: a robot, a scene, start and goal. Out: a joint path by one of OMPL's planners.
A seed is proven free before it is returned.
"""
