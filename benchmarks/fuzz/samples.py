"""Valid files of every format that the package reads, small, with most of what each format has."""

import io
import struct
import tempfile
from pathlib import Path

import numpy as np

import manipplan as mp

#: Corners and faces of a wedge.
CORNERS = np.array([[0, 0, 0], [0.2, 0, 0], [0, 0.2, 0], [0, 0, 0.2], [0.2, 0.2, 0]], dtype=float)
FACES = np.array([[0, 2, 1], [1, 2, 4], [0, 1, 3], [0, 3, 2], [1, 4, 3], [2, 3, 4]])

URDF = """<?xml version="1.0"?>
<robot name="two">
  <material name="grey"><color rgba="0.5 0.5 0.5 1"/></material>
  <link name="base"><inertial><origin xyz="0 0 0.1" rpy="0 0 0"/><mass value="2"/>
    <inertia ixx="0.1" ixy="0" ixz="0" iyy="0.1" iyz="0" izz="0.1"/></inertial>
    <visual><geometry><box size="0.1 0.1 0.1"/></geometry><material name="grey"/></visual>
    <collision name="c"><origin xyz="0 0 0.05"/><geometry><cylinder radius="0.05" length="0.1"/></geometry></collision></link>
  <link name="upper"><collision><origin xyz="0.25 0 0"/><geometry><box size="0.5 0.1 0.1"/></geometry></collision>
    <collision><origin xyz="0.1 0 0" rpy="0 1.57 0"/><geometry><MESH/></geometry></collision></link>
  <link name="fore"><collision><origin xyz="0.2 0 0"/><geometry><sphere radius="0.08"/></geometry></collision></link>
  <link name="tip"/><link name="left"/><link name="right"/>
  <joint name="turn" type="revolute"><parent link="base"/><child link="upper"/><origin xyz="0 0 0.1"/><axis xyz="0 0 1"/>
    <limit lower="-2" upper="2" velocity="1.5" effort="10"/><dynamics damping="0.1" friction="0.2"/></joint>
  <joint name="spin" type="continuous"><parent link="upper"/><child link="fore"/><origin xyz="0.5 0 0.2"/>
    <axis xyz="0.6 0 0.8"/><limit velocity="0.3" effort="20"/></joint>
  <joint name="end" type="fixed"><parent link="fore"/><child link="tip"/><origin xyz="0.3 0 0" rpy="0.1 0.2 0.3"/></joint>
  <joint name="finger" type="prismatic"><parent link="fore"/><child link="left"/><axis xyz="0 1 0"/>
    <limit lower="0" upper="0.1" velocity="0.3" effort="20"/></joint>
  <joint name="mirror" type="prismatic"><parent link="fore"/><child link="right"/><axis xyz="0 -1 0"/>
    <limit lower="0" upper="0.1" velocity="0.3" effort="20"/><mimic joint="finger" multiplier="2" offset="0.01"/></joint>
</robot>
"""
SRDF = """<?xml version="1.0"?>
<robot name="two">
  <group name="arm"><joint name="turn"/><joint name="spin"/><chain base_link="base" tip_link="tip"/></group>
  <end_effector name="tool" parent_link="tip" group="arm"/>
  <group_state name="home" group="arm"><joint name="turn" value="0.1"/><joint name="spin" value="-0.2"/></group_state>
  <group_state name="up" group="arm"><joint name="turn" value="1"/><joint name="spin" value="0"/></group_state>
  <virtual_joint name="fix" type="fixed" parent_frame="world" child_link="base"/>
  <passive_joint name="finger"/>
  <disable_collisions link1="base" link2="upper" reason="Adjacent"/>
  <disable_collisions link1="base" link2="fore" reason="Never"/>
</robot>
"""
MJCF = """<mujoco model="arm">
  <compiler angle="radian" meshdir="." autolimits="true"/>
  <option timestep="0.002" gravity="0 0 -9.81"/>
  <default><geom friction="1"/><default class="v"><geom type="box" size="0.1 0.1 0.1" contype="0" conaffinity="0"/></default>
    <default class="j"><joint axis="0 0 1" range="-2 2" armature="0.1" damping="0.2"/></default></default>
  <asset><mesh name="wedge" file="wedge.stl" scale="0.5 0.5 0.5"/>
    <mesh name="own" vertex="0 0 0 0.1 0 0 0 0.1 0 0 0 0.1"/></asset>
  <worldbody>
    <geom name="floor" type="plane" size="1 1 0.1" pos="0 0 -0.5"/><light pos="0 0 3"/>
    <body name="a" pos="0 0 0.1" quat="1 0 0 0"><inertial pos="0 0 0.1" mass="1" diaginertia="0.1 0.1 0.1"/>
      <joint name="turn" class="j"/><geom name="g" type="capsule" size="0.05" fromto="0 0 0 0.3 0 0"/><geom class="v"/>
      <geom type="mesh" mesh="wedge"/>
      <body name="b" pos="0.4 0 0" axisangle="0 0 1 0.3"><joint name="slide" type="slide" axis="0 1 0" range="0 1"/>
        <geom type="cylinder" size="0.04 0.1" mass="0.5"/><site name="s" pos="0.1 0 0"/>
        <body name="c" pos="0.2 0 0"><geom type="sphere" size="0.05"/></body></body></body>
  </worldbody>
  <actuator><position joint="turn" kp="10"/></actuator>
  <keyframe><key name="home" qpos="0.1 0.2"/></keyframe>
</mujoco>
"""
CELL = """<mujoco>
  <compiler angle="degree"/>
  <asset><mesh name="wedge" vertex="0 0 0 0.1 0 0 0 0.1 0 0 0 0.1" scale="2 2 2"/><mesh name="file" file="wedge.stl"/></asset>
  <worldbody>
    <geom name="floor" type="plane" size="1 1 0.1" pos="0 0 -0.1"/>
    <body name="table" pos="0.5 0 0.2" euler="10 20 30"><geom name="top" type="box" size="0.2 0.3 0.01"/>
      <geom type="cylinder" size="0.02 0.1" pos="0 0 -0.1"/>
      <body name="cup" pos="0 0.1 0.1"><geom name="cup" type="capsule" fromto="0 0 0 0.1 0.1 0.1" size="0.03"/></body></body>
    <body name="ball" pos="1 0 0"><geom name="ball" type="sphere" size="0.05"/></body>
    <body name="wedge" pos="0 0.6 0.3"><geom name="wedge" type="mesh" mesh="wedge"/><geom type="mesh" mesh="file"/></body>
    <body name="moving" pos="0 0 1"><joint name="j" type="hinge" axis="0 0 1"/><geom type="box" size="0.1 0.1 0.1"/></body>
  </worldbody>
</mujoco>
"""
SCENE = """obstacles:
- {name: table, shape: box, size: [1.0, 0.8, 0.05], position: [0.5, 0.0, -0.05], rotation: [0.0, 0.0, 0.3]}
- {shape: sphere, radius: 0.1, position: [0.4, 0.4, 0.4]}
- {shape: capsule, radius: 0.05, length: 0.4, position: [0, 0.6, 0.3], rotation: [[1, 0, 0], [0, 0, -1], [0, 1, 0]]}
- {shape: cylinder, radius: 0.05, length: 0.4}
- {name: floor, shape: plane, position: [0, 0, -0.1]}
- {name: wedge, shape: mesh, file: wedge.stl, scale: 0.5, position: [1, 1, 0]}
- name: triangles
  shape: mesh
  triangles:
  - [[0, 0, 0], [0, 0.1, 0], [0.1, 0, 0]]
  - [[0, 0, 0], [0.1, 0, 0], [0, 0, 0.1]]
  - [[0, 0, 0], [0, 0, 0.1], [0, 0.1, 0]]
allowed: [[table, floor], [table, wedge]]
"""
MOVEIT_TEXT = """cell
* table
0.5 0 0.1
0 0 0 1
2
box
1 0.8 0.05
0 0 0
0 0 0.38268343 0.92387953
0.5 0.5 0.5 1
cylinder
0.05 0.3
0.1 0.1 -0.2
0 0 0 1
0 0 0 0
1
handle
0 0 0
0 0 0 1
* floor
0 0 0
0 0 0 1
1
plane
0 0 1 0.1
0 0 0
0 0 0 1
0 0 0 0
0
* wedge
0 0 0
0 0 0 1
2
mesh
4 4
0 0 0
0.1 0 0
0 0.1 0
0 0 0.1
0 2 1
0 1 3
0 3 2
1 2 3
0.5 0.5 0.5
0 0 0 1
0 0 0 0
sphere
0.1
1 1 1
0 0 0 1
0 0 0 0
0
.
"""
MOVEIT_YAML = """name: cell
robot_model_name: panda
fixed_frame_transforms:
- header: {frame_id: world}
  child_frame_id: base
  transform: {translation: {x: 0.1, y: 0, z: 0}, rotation: {x: 0, y: 0, z: 0, w: 1}}
allowed_collision_matrix:
  entry_names: [table, hand]
  entry_values:
  - enabled: [false, true]
  - enabled: [true, false]
link_padding: [{link_name: hand, padding: 0.0}]
world:
  octomap: {header: {frame_id: world}, octomap: {data: []}}
  collision_objects:
  - header: {frame_id: base}
    id: table
    operation: 0
    pose: {position: [0, 0, 0.1], orientation: [0, 0, 0, 1]}
    primitives:
    - {type: 1, dimensions: [1, 0.8, 0.05]}
    - {type: cylinder, dimensions: [0.3, 0.05]}
    primitive_poses:
    - {position: {x: 0.5, y: 0, z: 0}, orientation: {x: 0, y: 0, z: 0, w: 1}}
    - {position: [0.5, 0, -0.2], orientation: [0, 0, 0.38268343, 0.92387953]}
  - header: {frame_id: world}
    id: wedge
    meshes:
    - vertices: [[0, 0, 0], [0.1, 0, 0], [0, 0.1, 0], {x: 0, y: 0, z: 0.1}]
      triangles: [{vertex_indices: [0, 2, 1]}, {vertex_indices: [0, 1, 3]}, {vertex_indices: [0, 3, 2]}]
    - {resource: wedge.stl, dimensions: [0.5, 0.5, 0.5]}
    mesh_poses: [{position: [0.5, 0.5, 0.5]}, {position: [1, 1, 1]}]
    planes: [{coef: [0, 0, 1, 0.5]}]
    plane_poses: [{position: [0, 0, 0]}]
"""


def meshes() -> dict[str, bytes]:
    """The wedge in every format, by name of file."""
    triangles = CORNERS[FACES]
    facets = ""
    for corners in triangles:
        lines = "".join(f"  vertex {x:g} {y:g} {z:g}\n" for x, y, z in corners)
        facets += f"facet normal 0 0 1\n outer loop\n{lines} endloop\nendfacet\n"
    rows = b"".join(struct.pack("<12fH", 0, 0, 1, *corners.ravel(), 0) for corners in triangles)
    corners_text = "\n".join(" ".join(f"{x:g}" for x in corner) for corner in CORNERS)
    head = f"element vertex {len(CORNERS)}\nproperty float x\nproperty float y\nproperty float z\nelement face {len(FACES)}\n"
    head += "property list uchar int vertex_indices\nend_header\n"
    packed = CORNERS.astype("<f4").tobytes() + b"".join(struct.pack("<B3i", 3, *face) for face in FACES)
    return {
        "wedge.stl": b"binary".ljust(80) + struct.pack("<I", len(triangles)) + rows,
        "text.stl": f"solid wedge\n{facets}endsolid wedge\n".encode(),
        "wedge.obj": (
            "# wedge\nmtllib none.mtl\no wedge\n"
            + "".join(f"v {line}\n" for line in corners_text.splitlines())
            + "vn 0 0 1\nvt 0 0\ng sides\nusemtl grey\ns off\n"
            + "".join(f"f {a + 1}/1/1 {b + 1}/1/1 {c + 1}/1/1\n" for a, b, c in FACES.tolist())
        ).encode(),
        "wedge.dae": _collada().encode(),
        "text.ply": (
            f"ply\nformat ascii 1.0\ncomment wedge\n{head}{corners_text}\n"
            + "".join("3 " + " ".join(map(str, face)) + "\n" for face in FACES.tolist())
        ).encode(),
        "wedge.ply": f"ply\nformat binary_little_endian 1.0\n{head}".encode() + packed,
    }


def _collada() -> str:
    numbers = " ".join(f"{x:g}" for x in CORNERS.ravel())
    faces = " ".join(map(str, FACES.ravel()))
    return f"""<?xml version="1.0" encoding="utf-8"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
  <asset><unit meter="1" name="meter"/><up_axis>Z_UP</up_axis></asset>
  <library_geometries><geometry id="wedge" name="wedge"><mesh>
    <source id="corners"><float_array id="array" count="{CORNERS.size}">{numbers}</float_array>
      <technique_common><accessor source="#array" count="{len(CORNERS)}" stride="3"><param name="X" type="float"/>
        <param name="Y" type="float"/><param name="Z" type="float"/></accessor></technique_common></source>
    <vertices id="vertices"><input semantic="POSITION" source="#corners"/></vertices>
    <triangles count="{len(FACES)}"><input semantic="VERTEX" source="#vertices" offset="0"/><p>{faces}</p></triangles>
  </mesh></geometry></library_geometries>
  <library_visual_scenes><visual_scene id="scene"><node id="node"><matrix>1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1</matrix>
    <instance_geometry url="#wedge"/></node></visual_scene></library_visual_scenes>
  <scene><instance_visual_scene url="#scene"/></scene>
</COLLADA>
"""


def urdf(mesh: str) -> bytes:
    """The URDF with the mesh of the file `mesh`."""
    return URDF.replace("<MESH/>", f'<mesh filename="package://{mesh}" scale="0.5 0.5 0.5"/>').encode()


def trajectories() -> dict[str, bytes]:
    """A motion in every format, by name of file; `recorded.csv` without velocities."""
    t = np.linspace(0.0, 1.0, 6)
    motion = mp.Trajectory(t=t, q=np.stack([t, t**2], axis=1), qd=np.stack([t**0, 2 * t], axis=1), joint_names=("a", "b"))
    with tempfile.TemporaryDirectory() as folder:
        files = {name: Path(folder) / name for name in ("motion.csv", "motion.json", "motion.yaml", "motion.npz")}
        motion.to_csv(files["motion.csv"])
        motion.to_json(files["motion.json"])
        motion.to_ros(files["motion.yaml"])
        motion.to_npz(files["motion.npz"])
        made = {name: file.read_bytes() for name, file in files.items()}
    recorded = "time,q_a,q_b\n" + "".join(f"{a:g},{a:g},{a * a:g}\n" for a in t)
    packed = io.BytesIO()
    np.savez_compressed(packed, t=motion.t, q=motion.q, qd=motion.qd, joint_names=np.array(motion.joint_names))
    return made | {"recorded.csv": recorded.encode(), "packed.npz": packed.getvalue()}


def plan() -> bytes:
    """A plan of the planar arm beside a ball, as it is saved."""
    arm = mp.planar_arm([0.4, 0.4, 0.4])
    scene = mp.Scene([mp.Sphere(radius=0.05, position=(0.0, 2.0, 0.0), name="ball")])
    found = mp.plan(arm, [0.1, 0.2, 0.3], [0.6, 0.5, 0.4], scene, shape=mp.PathShape(degree=1))
    with tempfile.TemporaryDirectory() as folder:
        found.save(folder)
        return (Path(folder) / "plan.json").read_bytes()
