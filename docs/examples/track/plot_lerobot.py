"""
A step of a LeRobot pipeline
============================

.. image:: /pictures/lerobot.jpg
   :alt: An SO-100 with its gripper at the edge of its reach.
   :width: 560px

*For those who teleoperate or record with LeRobot.*

LeRobot's teleoperators and robots exchange dictionaries: a gamepad or keyboard gives
``delta_x``, ``delta_y``, ``delta_z`` and ``gripper``, and a follower arm takes
``<motor>.pos`` in degrees. Between them stands a pipeline of processor steps, usually
with an inverse kinematics that jumps or stalls where the arm is stretched. The class
below takes the place of that step with ``mp.Servo``. It needs no LeRobot, so this page
runs it on a simulated SO-100.
"""

# %%
# The step: dictionaries in, a dictionary out. The servo runs eight times per frame from
# the positions that it commanded last. These stay within a leash of the measured ones:
# a blocked arm does not wind up.

# sphinx_gallery_thumbnail_path = "pictures/lerobot.jpg"
import matplotlib.pyplot as plt
import numpy as np

import manipplan as mp


class ServoStep:
    """Turns a teleoperator's action and a robot's observation into joint positions.

    Args:
        robot: the arm; its joints are named like the motors.
        rate: frames per second of the loop.
        speed: of the gripper for a delta of 1 [m/s].
        grip: change of ``gripper.pos`` per second.
    """

    SUBSTEPS = 8
    LEASH = 0.2  # [rad]

    def __init__(self, robot, *, rate=30.0, speed=0.15, grip=100.0):
        self.servo = mp.Servo(
            robot, dt=1 / (rate * self.SUBSTEPS), task=mp.Task.position()
        )
        self.names = robot.joint_names
        self.rate, self.speed, self.grip = rate, speed, grip
        self.reset()

    def reset(self):
        """Forget what was commanded: the next call starts where the arm is."""
        self.servo.reset()
        self.q = self.qd = None

    def __call__(self, action, observation):
        """``<motor>.pos`` [deg] for the next frame."""
        measured = np.radians([observation[f"{name}.pos"] for name in self.names])
        if self.q is None or not np.isfinite(self.q).all():
            self.q, self.qd = measured, np.zeros(len(measured))
        # a reading that is not a number: where the motor was sent
        measured = np.where(np.isfinite(measured), measured, self.q)
        self.q = measured + np.clip(self.q - measured, -self.LEASH, self.LEASH)
        twist = np.zeros(6)
        twist[:3] = [self.speed * float(action[f"delta_{axis}"]) for axis in "xyz"]
        for _ in range(self.SUBSTEPS):
            self.qd = self.servo.step(self.q, self.qd, twist, "base")
            self.q = self.q + self.servo.dt * self.qd
        positions = np.degrees(self.q)
        command = {
            f"{name}.pos": float(x)
            for name, x in zip(self.names, positions, strict=True)
        }
        if "gripper.pos" in observation:  # 0: close, 1: stay, 2: open
            opens = float(action.get("gripper", 1.0)) - 1.0
            moved = observation["gripper.pos"] + self.grip * opens / self.rate
            command["gripper.pos"] = float(np.clip(moved, 0.0, 100.0))
        return command


# %%
# In LeRobot, a ``RobotActionProcessorStep`` hands both dictionaries to it. Load the arm
# from the URDF file of your calibration, so that its joints have the names, zeros and
# signs of the motors, and set ``use_degrees=True`` in the robot's configuration:
#
# .. code-block:: python
#
#     from lerobot.processor import (
#         RobotActionProcessorStep, RobotProcessorPipeline, TransitionKey,
#         robot_action_observation_to_transition, transition_to_robot_action,
#     )
#
#     class ServoAction(RobotActionProcessorStep):
#         def __init__(self, step):
#             self.step = step
#
#         def action(self, action):
#             return self.step(action, self.transition[TransitionKey.OBSERVATION])
#
#         def reset(self):
#             self.step.reset()
#
#         def transform_features(self, features):
#             return features
#
#     arm = mp.Robot.from_urdf("so101_new_calib.urdf", tool="gripper_frame_link",
#                              joints=list(motors_without_gripper))
#     pipeline = RobotProcessorPipeline(
#         steps=[ServoAction(ServoStep(arm))],
#         to_transition=robot_action_observation_to_transition,
#         to_output=transition_to_robot_action,
#     )
#     robot.send_action(pipeline((teleop.get_action(), robot.get_observation())))
#
# Here the loop is simulated: motors that lag by 80 ms, and an operator who pushes the
# gripper outward for 5 s and pulls it back for 2 s.
RATE, LAG = 30.0, 0.08
robot = mp.load_robot("so100")
step = ServoStep(robot, rate=RATE)
kinematics = robot.kinematics()
q = np.array([0.3, 1.2, -1.8, 0.4, 0.0])
grip, log = 50.0, []
for k in range(round(7 * RATE)):
    outward = 1.0 if k < 5 * RATE else -1.0
    action = {"delta_x": 0.0, "delta_y": -outward, "delta_z": 0.0, "gripper": 2}
    observation = {
        f"{name}.pos": x
        for name, x in zip(robot.joint_names, np.degrees(q), strict=True)
    }
    command = step(action, observation | {"gripper.pos": grip})
    goal = np.radians([command[f"{name}.pos"] for name in robot.joint_names])
    speed = (goal - (log[-1]["goal"] if log else q)) * RATE
    q = q + (goal - q) * (1 - np.exp(-1 / (RATE * LAG)))
    grip = command["gripper.pos"]
    pose, gauge = kinematics.pose(q), step.servo.gauge
    log.append({"goal": goal, "tool": pose[:3, 3], "speed": speed, "wall": gauge.wall})
print(sorted(command))

# %%
# The gripper slows down at the edge of its reach and stays there; it comes back as soon
# as it is pulled, as fast as the joints can. No joint is faster than its limit.
times = np.arange(len(log)) / RATE
way = -np.array([each["tool"][1] for each in log])
shares = np.abs([each["speed"] for each in log]) / robot.limits.velocity
walls = np.array([each["wall"] for each in log])
edge = (times > 3.5) & (times < 5.0)
print(f"pushed outward: {way[edge].mean():.2f} m, wall {walls[edge].mean():.1f}")
print(f"1 s after the pull: {way[times >= 6.0][0]:.2f} m")
assert walls[edge].min() > 0.5 and np.ptp(way[edge]) < 0.02
assert way[times >= 6.0][0] < way[edge].mean() - 0.04
assert shares.max() < 1 + 1e-6
figure, (above, below) = plt.subplots(
    2, 1, figsize=(8.0, 4.6), sharex=True, layout="constrained"
)
above.plot(times, way, color="#0072B2")
above.fill_between(
    times, 0, 1, where=walls > 0.5, transform=above.get_xaxis_transform(), color="0.9"
)
above.set(ylabel="gripper outward [m]")
below.plot(times, 100 * shares.max(axis=1), color="#D55E00")
below.set(xlabel="time [s]", ylabel="fastest joint [% of limit]", ylim=(0, 105))
for ax in (above, below):
    ax.spines[["top", "right"]].set_visible(False)
plt.show()

# %%
# Grey: the command points at the edge of the reach, ``gauge.wall`` above 0.5. A program
# can make the gamepad rumble there, see :doc:`live_gamepad`.
