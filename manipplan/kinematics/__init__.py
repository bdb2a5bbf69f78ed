"""Numerical evaluation of the symbolic expressions.

In: configurations, one or millions. Out: pose, Jacobian, manipulability, gradient and Hessian,
by an interpreter in C, machine code or CasADi's virtual machine.
`Kinematics` is the public class; `Evaluator` is its version for control loops.
"""
