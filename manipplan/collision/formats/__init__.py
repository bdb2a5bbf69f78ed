"""Readers of scenes from elsewhere: files of MoveIt and MuJoCo go in, obstacles come out."""
