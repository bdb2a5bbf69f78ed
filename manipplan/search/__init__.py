"""The global search along a path of the tool [guilamo2006].

In: a path of the tool. Out: the joint path whose minimum manipulability is the largest among all sampled configurations.
`sampling` makes layers, `max_min` searches them, `refine` leaves the grid.
"""
