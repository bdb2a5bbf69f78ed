"""Carrying: two tools of one robot hold an object and move it along a path.

What comes in is the object's path and where each tool holds it; a Plan comes out, in which the tools keep their relative pose.
"""
