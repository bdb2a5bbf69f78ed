"""The study of guilamo2006: circle and line on TALOS' torso and arm, the paper's search and the exact one."""
