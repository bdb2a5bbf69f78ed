"""All configurations that reach a pose.

In: a robot and poses. Out: a SolutionSet that says whether it is complete, and by which method.
Each family of arms has a file; Newton steps serve arms without a closed form.
"""
