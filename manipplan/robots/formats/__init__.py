"""Readers of robot files: xacro is expanded, packages are found, and links, bodies and XML trees are checked."""
