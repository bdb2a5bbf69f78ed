"""Programs: several moves of one arm, with parts taken up and put down, planned together.

In: a robot, a start, steps, a scene. Out: a Program, with one plan for each motion between two stops and one trajectory.
"""
