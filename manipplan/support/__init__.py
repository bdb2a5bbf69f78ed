"""What all packages share: errors, checks of arguments, status, files, caches, compiling.

A check takes a caller's value and the argument's name and returns the value in one form, or raises one of the errors here.
Nothing in this package depends on robots.
"""
