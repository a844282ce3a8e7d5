"""The nominal model of an arm, as its owner has it: URDF, or MJCF with its servos."""
import numpy as np


def text(values):
    return " ".join(f"{v:.12g}" for v in np.atleast_1d(values))


def rotation(turn):
    """The matrix of roll, pitch and yaw about fixed axes, as in URDF."""
    (cr, cp, cy), (sr, sp, sy) = np.cos(turn), np.sin(turn)
    return np.array([[cy * cp, cy * sp * sr - sy * cr, cy * sp * cr + sy * sr],
                     [sy * cp, sy * sp * sr + cy * cr, sy * sp * cr - cy * sr],
                     [-sp, cp * sr, cp * cr]])


def rotation_about(vector):
    """The matrix of a rotation vector (Rodrigues)."""
    angle = np.linalg.norm(vector)
    x, y, z = np.asarray(vector) / angle if angle > 0 else (0.0, 0.0, 0.0)
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.eye(3) + np.sin(angle) * cross + (1 - np.cos(angle)) * cross @ cross


def quaternion(matrix):
    """w, x, y, z of a rotation matrix: the eigenvector of the largest eigenvalue of Bar-Itzhack's symmetric matrix."""
    m = matrix
    k = np.array([[m[0, 0] + m[1, 1] + m[2, 2], 0, 0, 0],
                  [m[2, 1] - m[1, 2], m[0, 0] - m[1, 1] - m[2, 2], 0, 0],
                  [m[0, 2] - m[2, 0], m[0, 1] + m[1, 0], m[1, 1] - m[0, 0] - m[2, 2], 0],
                  [m[1, 0] - m[0, 1], m[0, 2] + m[2, 0], m[1, 2] + m[2, 1], m[2, 2] - m[0, 0] - m[1, 1]]])
    q = np.linalg.eigh(k, UPLO="L")[1][:, -1]
    return q if q[0] >= 0 else -q


def inertia(link):
    """Of a ball with a radius that suits the link; statics do not depend on it."""
    radius = 0.05 + 0.3 * np.linalg.norm(link.centre)
    return 0.4 * link.mass * radius**2


def urdf(shape):
    lines = ['<?xml version="1.0"?>', f'<robot name="{shape.name}">', '  <link name="base"/>']
    parent = "base"
    for i, link in enumerate(shape.links):
        kind = "revolute" if link.kind == "hinge" else "prismatic"
        ball = inertia(link)
        lines += [f'  <joint name="{link.joint}" type="{kind}">',
                  f'    <origin xyz="{text(link.place)}" rpy="{text(link.turn)}"/>',
                  f'    <parent link="{parent}"/>', f'    <child link="link_{i + 1}"/>', f'    <axis xyz="{text(link.axis)}"/>',
                  f'    <limit lower="{link.limits[0]}" upper="{link.limits[1]}" effort="10000" velocity="2"/>', '  </joint>',
                  f'  <link name="link_{i + 1}">', '    <inertial>', f'      <origin xyz="{text(link.centre)}"/>',
                  f'      <mass value="{link.mass}"/>',
                  f'      <inertia ixx="{ball:.6g}" ixy="0" ixz="0" iyy="{ball:.6g}" iyz="0" izz="{ball:.6g}"/>', '    </inertial>', '  </link>']
        parent = f"link_{i + 1}"
    lines += ['  <joint name="tool_mount" type="fixed">', f'    <origin xyz="{text(shape.tip)}"/>', f'    <parent link="{parent}"/>',
              '    <child link="tip"/>', '  </joint>', '  <link name="tip"/>', '</robot>']
    return "\n".join(lines) + "\n"


def mjcf(shape):
    lines = [f'<mujoco model="{shape.name}">', '  <compiler angle="radian"/>', '  <option gravity="0 0 -9.81"/>', '  <worldbody>',
             '    <body name="base">']
    for i, link in enumerate(shape.links):
        pad = "  " * (i + 3)
        lines += [f'{pad}<body name="link_{i + 1}" pos="{text(link.place)}" quat="{text(quaternion(rotation(link.turn)))}">',
                  f'{pad}  <inertial pos="{text(link.centre)}" mass="{link.mass}" diaginertia="{text([inertia(link)] * 3)}"/>',
                  f'{pad}  <joint name="{link.joint}" type="{link.kind}" axis="{text(link.axis)}" range="{text(link.limits)}"/>']
    lines += ["  " * (shape.size + 3) + f'<site name="tip" pos="{text(shape.tip)}"/>']
    lines += ["  " * (i + 2) + "</body>" for i in range(shape.size, -1, -1)]
    lines += ['  </worldbody>', '  <actuator>']
    lines += [f'    <position joint="{link.joint}" kp="{link.stiffness:.12g}"/>' for link in shape.links]
    return "\n".join(lines + ['  </actuator>', '</mujoco>']) + "\n"


def nominal_model(shape):
    """The file's name and its text."""
    return (f"{shape.name}.urdf", urdf(shape)) if shape.model == "urdf" else (f"{shape.name}.xml", mjcf(shape))
