"""Pictures of whole programs: where the moved parts are over time, and a figure with the marks of the steps.

In: a Program. Out: a Matplotlib figure, and the places of parts that the viewer draws.
"""
