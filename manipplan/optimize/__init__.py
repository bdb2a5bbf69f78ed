"""The path optimiser.

In: a first path and the cost. Out: a PathResult: a local optimum of g with the certificate of what it reaches.
`program` and `descent` solve, `certificate` verifies.
"""
