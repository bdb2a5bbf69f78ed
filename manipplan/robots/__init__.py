"""Robots read from robot descriptions.

In: a catalogue name, or a URDF, xacro or MJCF file with its SRDF. Out: a frozen Robot with its model, limits, tool and
collision geometry.
A file that cannot be read completely is rejected; the error names it.
"""
