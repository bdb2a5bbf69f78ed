"""CasADi expressions of an arm and its task.

In: a Robot and a Task. Out: pose, Jacobian and their derivatives as symbols, and functions of them as machine code.
Other packages build their functions and programs from these expressions.
"""
