"""A bench as its owner knows it: the nominal chain, its loads, its runs, its instrument."""
from dataclasses import dataclass

import numpy as np

GRAVITY = 9.81  # m/s^2


@dataclass
class Run:
    """One loading history; arrays are by reading."""
    id: str
    control: str  # "angle", "displacement", "torque", "force" or "command"
    time: np.ndarray  # s
    command: np.ndarray  # (reading, joint): rest angles, rad
    imposed: np.ndarray = None  # of a joint alone: its angle rad, or torque N m (m, N)
    force: np.ndarray = None  # (reading, 2) on the end point, N
    value: np.ndarray = None  # of a tendon N, or a pressure Pa
    link_force: np.ndarray = None  # (reading, 2), N
    begins: str = "relaxed"
    loaded_by: str = ""

    @property
    def is_held(self):
        """Whether the coordinate is imposed and the load read."""
        return self.control in ("angle", "displacement")


@dataclass
class Bench:
    kind: str
    stiffness: np.ndarray  # N m/rad, or N/m
    runs: list
    alone: str = ""  # "revolute" or "prismatic": a joint alone
    length: np.ndarray = None  # m
    mass: np.ndarray = None  # kg, of the nominal links; none where the model has no weight
    plane: str = "horizontal"
    load: str = ""  # "tendon", "pressure" or "force"
    lever: np.ndarray = None  # radii m, or volumes m^3, by joint
    link: int = 0  # from 1: of a force on a link
    at: float = 1.0
    sigma: float = 0.0  # true standard deviation of the sensor
    declared: float = 0.0
    count: float = 0.0  # of the display or encoder; 0 for none
    sweep: bool = False  # whether the command goes there and back
    clock: bool = True  # whether the times of readings are known
    scales: np.ndarray = None  # by joint: see scales.py

    @property
    def size(self):
        return len(self.stiffness)

    @property
    def noise(self):
        """Standard deviation of a reading, with the rounding to counts."""
        return float(np.hypot(self.sigma, self.count / np.sqrt(12)))

    @property
    def by_sensor(self):
        """Whether a load sensor of a joint alone is in question."""
        return bool(self.alone) and any(run.is_held or run.loaded_by == "servo" for run in self.runs)

    @property
    def is_held(self):
        return self.runs[0].is_held
