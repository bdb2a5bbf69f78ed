"""Motions as files that robot controllers run.

In: a trajectory. Out: a program in URScript, or a table at 1 kHz for a Franka arm; what the format asks for is checked first.
"""
