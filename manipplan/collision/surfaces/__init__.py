"""Surfaces of meshes and clouds of points, as coal takes them."""
