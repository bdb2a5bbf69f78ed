"""The one engine for tool paths: `follow`, `MoveAlong` in `sequence`, straight ways and `carry` all use it.

Input: a workspace path with all configurations at its positions. Output: the joint path with the largest minimum manipulability
along it, from any or from a given configuration, in one or in the fewest parts, with the free motions to and between them.
"""
