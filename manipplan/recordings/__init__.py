"""Recordings: what `improve` needs to make a better motion of a recorded one.

What comes in is a recorded motion with its noise; smooth splines inside a tube around it, and a comparison of both, come out.
"""
