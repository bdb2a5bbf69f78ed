from manipplan.robots.catalog import *
from manipplan.robots.robot import Robot
