"""What a job returns: Plan, with its path, its trajectory and its Report, and the file it is saved in.

In: a timed motion of a robot among obstacles. Out: every figure of it, measured on the motion itself, and what does not pass.
"""
