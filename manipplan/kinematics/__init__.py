"""Numerical evaluation of the symbolic expressions.

In: configurations, one or millions. Out: pose, Jacobian, manipulability, gradient and Hessian,
by machine code or by CasADi's virtual machine.
`Kinematics` is the public class; `Evaluator` is its version for control loops.
"""
