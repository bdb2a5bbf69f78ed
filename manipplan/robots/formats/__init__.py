"""Readers of URDF files: xacro is expanded and packages are found; a checked XML tree comes out."""
