"""The study of kth2012: the planar three-link arm, every table and figure of the thesis, and the questions it left open."""
