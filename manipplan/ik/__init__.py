"""All configurations that reach a pose.

Input: a robot and poses. Output: a SolutionSet that says whether it is complete and which method was used.
Each family of arms has a header in csrc/; arms without a closed form are solved by Newton steps (`newton`).
"""
