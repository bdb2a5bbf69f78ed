"""What every room needs and no room owns: errors, checks of arguments, status, files, caches, compiling.

Checks take what a caller gave under the argument's name and return it in one form, or raise one of the errors here.
Nothing in this room knows of robots.
"""
