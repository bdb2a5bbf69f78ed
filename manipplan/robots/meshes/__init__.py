"""Mesh files of robots and scenes.

In: a file in STL, OBJ, PLY, COLLADA or glTF. Out: its triangles as the file says, with the transforms of its nodes.
A file that cannot be read completely is rejected; nothing of it is left out.
"""
