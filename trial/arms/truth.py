"""What is true of an arm, its bench and its instruments, where it departs from the nominal model."""
from dataclasses import dataclass, field

import numpy as np


def zeros(*shape):
    return field(default_factory=lambda: np.zeros(shape))


@dataclass
class Truth:
    """Every departure is nought in the nominal model. Lists are by link, from the base on; SI units, radians."""
    size: int
    # servos: the joint turns to zero + (1 + gear) command + the sum of amplitude sin(waves command + phase)
    zero: np.ndarray = None
    gear: np.ndarray = None
    ripple: list = field(default_factory=list)  # (link, amplitude, waves, phase)
    coupling: dict = field(default_factory=dict)  # link -> share of its command by which the next joint turns too
    # gears
    softer: np.ndarray = None  # stiffness times (1 + softer)
    hardening: np.ndarray = None  # torque k d (1 + hardening d^2)
    uneven: np.ndarray = None  # stiffness times 1 + uneven sin(3 q)
    friction: np.ndarray = None  # dry, N m or N
    play: dict = field(default_factory=dict)  # link -> half the width
    belt: dict = field(default_factory=dict)  # link -> (stiffness, torque at which it slips), beside the spring
    # links: translation in the frame of the link before, rotation vector in the link's own
    shift: np.ndarray = None
    tilt: np.ndarray = None
    heavier: np.ndarray = None  # mass times (1 + heavier)
    centre: np.ndarray = None
    bending: dict = field(default_factory=dict)  # link -> rigidity EI, N m^2
    # mounting and tool
    base_shift: np.ndarray = zeros(3)
    base_tilt: np.ndarray = zeros(3)
    base_compliance: np.ndarray = zeros(2)  # rotation about the world's x and y, rad/(N m)
    tip_shift: np.ndarray = zeros(3)
    load_offset: np.ndarray = zeros(3)  # of the load from the measured point, in the last link
    compensated: float = 0.0  # share of the nominal weights that the servos hold without yielding
    payload: float = 0.0  # kg at the measured point, beside the weights in the table
    loose_flange: float = 0.0  # half the angle by which the tool tips, about the last link's y axis
    # other bodies
    gas_spring: tuple = ()  # stiffness, free length, point of the first link, where it is in the base at rest, link, point of the link: it pushes
    cable: tuple = ()  # the same between the world and a link: it only pulls
    floor: tuple = ()  # height, stiffness: it holds up the measured point
    # what changes from reading to reading: a share of the whole change, by reading
    growth: float = 0.0  # of every length, at the last reading
    sinking: np.ndarray = zeros(2)  # of the base, rotation about x and y by the last reading
    # instruments
    angle_bias: np.ndarray = None  # of reached joint coordinates, as they are read
    angle_scale: np.ndarray = None
    tracker_shift: np.ndarray = zeros(3)
    tracker_turn: np.ndarray = zeros(3)
    tracker_scale: float = 0.0
    bump: np.ndarray = zeros(3)  # shift of the tracker half-way
    force_gain: float = 0.0
    force_bias: np.ndarray = zeros(3)

    def __post_init__(self):
        for name, width in (("zero", 0), ("gear", 0), ("softer", 0), ("hardening", 0), ("uneven", 0), ("friction", 0), ("heavier", 0), ("angle_bias", 0),
                            ("angle_scale", 0), ("shift", 3), ("tilt", 3), ("centre", 3)):
            if getattr(self, name) is None:
                setattr(self, name, np.zeros((self.size, width) if width else self.size))

    @property
    def has_memory(self):
        return bool(self.friction.any() or self.belt)

    def turned_to(self, command):
        """Where the motors' sides of the joints are."""
        turned = self.zero + (1 + self.gear) * command
        for link, amplitude, waves, phase in self.ripple:
            turned[link] += amplitude * np.sin(waves * command[link] + phase)
        for link, share in self.coupling.items():
            turned[link + 1] += share * command[link]
        return turned
