"""CasADi expressions of an arm and of what its tool has to do.

In: a Robot and a Task. Out: pose, Jacobian and their derivatives as symbols, and functions of them as machine code.
Other rooms build what they evaluate or solve from these expressions.
"""
