"""Mesh files from outside, judged before a mesh loader reads them."""
