"""Few convex bodies in place of many: fits and pieces of an arm's meshes, and coarse copies of scenes."""
