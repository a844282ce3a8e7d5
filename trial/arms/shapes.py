"""Four arms of public shape: lengths, masses and servos. SI units, radians.

industrial  KUKA KR 210 L150: frames and masses of the URDF of the Udacity robotics course (RoboND-Kinematics-Project, kr210.urdf.xacro).
            Gear stiffnesses are of the order that Dumas et al. (2011, Robotics and Computer-Integrated Manufacturing 27, 881-888) identify on a KR 240-2.
collaborative  Franka Emika Panda: frames of the maker's franka_description; masses and centres by Gaz et al. (2019, IEEE Robotics and
            Automation Letters). Gear stiffnesses are of the order of harmonic drives of this size.
hobby       SO-ARM100, five servos: frames, masses and the servos' gain of MuJoCo Menagerie (trs_so_arm100, Apache-2.0).
scara       Adept Cobra s600: links of 325 and 275 mm and a stroke of 210 mm from its data sheet; masses and stiffnesses are estimates.

Trackers: 0.05 mm is a laser tracker at a few metres, 0.02 mm at one metre, 0.3 mm a motion capture system.
"""
from dataclasses import dataclass

import numpy as np

HALF_PI = np.pi / 2


@dataclass(frozen=True)
class Link:
    """A link and the joint that moves it: its frame in that of the link before, at joint coordinate zero."""
    joint: str
    place: tuple  # m
    turn: tuple  # roll, pitch, yaw, rad
    axis: tuple
    mass: float
    centre: tuple
    stiffness: float  # of the servo and gear, N m/rad or N/m
    limits: tuple
    kind: str = "hinge"  # or "slide"


@dataclass(frozen=True)
class Shape:
    name: str
    links: tuple
    tip: tuple  # of the measured point in the last link, m
    payload: float  # kg
    tracker: float  # standard deviation of a coordinate, m
    model: str  # the format of the nominal model: "urdf" or "mjcf"
    reach: tuple  # least height and least distance from the first axis of the tip, m
    gravity_joints: tuple  # joints, from 1, which gravity keeps on one side
    encoder: float = 0.0  # standard deviation of a measured joint coordinate; 0 where none is measured
    count: float = 0.0  # of the encoder

    @property
    def size(self):
        return len(self.links)

    @property
    def stiffness(self):
        return np.array([link.stiffness for link in self.links])

    @property
    def limits(self):
        return np.array([link.limits for link in self.links])

    @property
    def length(self):
        """Of the stretched arm."""
        return sum(np.linalg.norm(link.place) for link in self.links[1:]) + np.linalg.norm(self.tip)


def hinges(rows):
    return tuple(Link(f"joint_{i + 1}", *row) for i, row in enumerate(rows))


INDUSTRIAL = Shape(
    "industrial",
    hinges([
        ((0, 0, 0.33), (0, 0, 0), (0, 0, 1), 138, (0, 0, 0.4), 3.8e6, (-3.0, 3.0)),
        ((0.35, 0, 0.42), (0, 0, 0), (0, 1, 0), 95, (0, 0, 0.44751), 3.5e6, (-0.75, 1.4)),
        ((0, 0, 1.25), (0, 0, 0), (0, 1, 0), 71, (0.18842, 0.18344, -0.042799), 2.5e6, (-2.2, 1.0)),
        ((0.96, 0, -0.054), (0, 0, 0), (1, 0, 0), 17, (0.27146, -0.007326, 0), 5.0e5, (-3.0, 3.0)),
        ((0.54, 0, 0), (0, 0, 0), (0, 1, 0), 7, (0, 0, 0), 4.0e5, (-2.0, 2.0)),
        ((0.193, 0, 0), (0, 0, 0), (1, 0, 0), 0.5, (0, 0, 0), 2.0e5, (-3.0, 3.0)),
    ]),
    tip=(0.15, 0.06, 0.04), payload=120, tracker=5e-5, model="urdf", reach=(0.3, 0.7), gravity_joints=(2, 3, 5))

COLLABORATIVE = Shape(
    "collaborative",
    hinges([
        ((0, 0, 0.333), (0, 0, 0), (0, 0, 1), 4.970684, (0.003875, 0.002081, -0.1750), 1.4e4, (-2.8, 2.8)),
        ((0, 0, 0), (-HALF_PI, 0, 0), (0, 0, 1), 0.646926, (-0.003141, -0.02872, 0.003495), 1.4e4, (-1.7, 1.7)),
        ((0, -0.316, 0), (HALF_PI, 0, 0), (0, 0, 1), 3.228604, (0.027518, 0.039252, -0.066502), 1.1e4, (-2.8, 2.8)),
        ((0.0825, 0, 0), (HALF_PI, 0, 0), (0, 0, 1), 3.587895, (-0.05317, 0.104419, 0.027454), 1.1e4, (-3.0, -0.1)),
        ((-0.0825, 0.384, 0), (-HALF_PI, 0, 0), (0, 0, 1), 1.225946, (-0.011953, 0.041065, -0.038437), 6.0e3, (-2.8, 2.8)),
        ((0, 0, 0), (HALF_PI, 0, 0), (0, 0, 1), 1.666555, (0.060149, -0.014117, -0.010517), 6.0e3, (0.0, 3.6)),
        ((0.088, 0, 0), (HALF_PI, 0, 0), (0, 0, 1), 0.735522, (0.010517, -0.004252, 0.061597), 6.0e3, (-2.8, 2.8)),
    ]),
    tip=(0.05, 0.03, 0.137), payload=3, tracker=3e-4, model="mjcf", reach=(0.15, 0.25), gravity_joints=(2, 4, 6), encoder=5e-5)

HOBBY = Shape(
    "hobby",
    hinges([
        ((0, -0.0452, 0.0165), (HALF_PI, 0, 0), (0, 1, 0), 0.119226, (-9.07886e-05, 0.0590972, 0.031089), 50, (-2.2, 2.2)),
        ((0, 0.1025, 0.0306), (HALF_PI, 0, 0), (1, 0, 0), 0.162409, (-1.72052e-05, 0.0701802, 0.00310545), 50, (-3.1, 0.2)),
        ((0, 0.11257, 0.028), (-HALF_PI, 0, 0), (1, 0, 0), 0.147968, (-0.00339604, 0.00137796, 0.0768007), 50, (0.0, 3.1)),
        ((0, 0.0052, 0.1349), (-HALF_PI, 0, 0), (1, 0, 0), 0.0661321, (-0.00852653, -0.0352279, -2.34622e-05), 50, (-2.0, 1.8)),
        ((0, -0.0601, 0), (0, HALF_PI, 0), (0, 1, 0), 0.1132303, (0.0009, -0.0325, 0.0005), 50, (-3.1, 3.1)),
    ]),
    tip=(0.012, -0.098, 0.0), payload=0.4, tracker=3e-4, model="mjcf", reach=(0.04, 0.08), gravity_joints=(2, 3, 4), encoder=8e-4,
    count=2 * np.pi / 4096)

SCARA = Shape(
    "scara",
    (Link("joint_1", (0, 0, 0.342), (0, 0, 0), (0, 0, 1), 9.0, (0.15, 0, 0.02), 9.0e4, (-1.8, 1.8)),
     Link("joint_2", (0.325, 0, 0.045), (0, 0, 0), (0, 0, 1), 7.5, (0.12, 0, 0.06), 4.0e4, (-2.6, 2.6)),
     Link("quill", (0.275, 0, -0.05), (0, 0, 0), (0, 0, -1), 1.2, (0, 0, 0.05), 1.2e6, (0.0, 0.21), "slide"),
     Link("joint_4", (0, 0, -0.04), (0, 0, 0), (0, 0, 1), 0.4, (0, 0, 0), 1.5e3, (-3.1, 3.1))),
    tip=(0.06, 0.02, -0.03), payload=5, tracker=2e-5, model="urdf", reach=(0.0, 0.15), gravity_joints=())

SHAPES = (INDUSTRIAL, COLLABORATIVE, HOBBY, SCARA)
