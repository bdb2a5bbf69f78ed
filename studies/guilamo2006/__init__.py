"""The study of guilamo2006: circle and line with the torso and arm of TALOS, the paper's search and the exact search."""
