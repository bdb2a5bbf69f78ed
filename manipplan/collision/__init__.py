"""What touches what, and how far apart bodies are.

In: a Robot and a Scene of obstacles. Out: distances, contacts, and proofs for whole paths.
`model` joins the two; everything else in the room serves it.
"""
