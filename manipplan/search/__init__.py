"""The global search along a tool path [guilamo2006].

In: a tool path. Out: the joint path with the largest minimum manipulability among all sampled configurations.
`sampling` makes layers, `max_min` searches them, `interruptions` cuts the path where nothing connects, and `refine` improves
the result beyond the grid.
"""
