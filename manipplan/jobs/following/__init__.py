"""Following: the job `follow` and its parts.

In come a robot, a path of the tool and perhaps the configuration in which the arm stands. Out goes a Plan, whose motion begins
there, leads to the path if need be, and follows it.
"""
