"""Collision checks and distances of bodies.

In: a Robot and a Scene of obstacles. Out: distances, contacts, and proven clearances of whole paths.
`model` joins the two; all other modules serve it.
"""
