"""A robot description becomes a Robot.

In: a name of the catalogue, or a URDF or MJCF file with its SRDF. Out: a frozen Robot with its model, limits,
tool and collision geometry.
A file that cannot be read whole is refused by name.
"""
