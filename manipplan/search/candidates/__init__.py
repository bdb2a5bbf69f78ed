"""The candidates of a search: in which positions of a tool path which configurations are considered.

In: a robot and a tool path. Out: Layers, the configurations at each position with their manipulability.
"""
