"""Goals of a motion: configurations, named states, poses of the tool, and sets of these.

Input: a goal as the user states it. Output: the configurations that reach it, in the order in which paths to them are planned,
and the best path found.
"""
