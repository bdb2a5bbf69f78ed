"""Reports: the figures of a finished trajectory and what they are measured by.

What comes in is a trajectory, the robot among its obstacles, and what is asked of the motion; a Report comes out.
"""
