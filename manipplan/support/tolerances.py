"""Tolerances on what a caller gives: one per meaning, used by every folder.

Numbers from outside are rounded: poses to float32 or to some digits in a file, points to whatever a recorder keeps. What lies
within such a tolerance is taken to what was meant, once, where it comes in; from there on all work is exact.
"""

#: Largest difference between an entry of a pose and that of the nearest rigid transform: float32, or five digits or more.
POSE = 1e-5
#: Up to this difference a pose is kept bit by bit: it is the rounding of a few products of rotations in double precision.
EXACT = 1e-12
#: Largest difference of a quaternion's length from 1: two digits or more. Its length says nothing of the rotation.
QUATERNION = 1e-2
#: Two points, configurations or poses nearer than this are one [rad or m]: a goal this near is reached.
COINCIDENT = 1e-6
