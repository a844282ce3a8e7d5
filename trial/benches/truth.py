"""Departures of a chain, its bench and its instruments from the nominal model. Every one is nought in the nominal model."""
from dataclasses import dataclass, field

import numpy as np


@dataclass
class Slider:
    """A contact that carries a torque up to a limit and slips there.

    The limit is a function of the joint's coordinate, rad, and deflection, rad: torques, N m, for motion up and down, both positive.
    """
    stiffness: float  # N m/rad, before it slips
    limit: object
    on_turn: bool  # whether it follows the turn of the joint; else the deflection of its spring from the command


@dataclass
class JointTruth:
    """One joint. A joint that slides has N for N m and m for rad."""
    softer: float = 0.0  # stiffness times (1 + softer)
    rest: float = 0.0  # added to the rest angle, rad
    hardening: float = 0.0  # torque k d (1 + hardening d^2), 1/rad^2
    play: float = 0.0  # half the play, rad
    uneven: float = 0.0  # torque k d (1 + uneven) for d > 0, (1 - uneven) for d < 0
    knee: tuple = ()  # deflection, share of the stiffness that is lost beyond it
    stop: tuple = ()  # deflection, stiffness beyond it, N m/rad
    sliders: list = field(default_factory=list)
    arms: list = field(default_factory=list)  # Maxwell: stiffness N m/rad, time constant s
    plastic: tuple = ()  # torque at which it yields, slope of the yielding
    beside: list = field(default_factory=list)  # further restoring torques, N m: functions of the joint's coordinate, rad
    share: object = None  # of its stiffness, by reading: a function of all times (s)
    shift: object = None  # of its rest angle, rad: a function of all times and coordinates


@dataclass
class Truth:
    joints: list
    coupling: float = 0.0  # N m/rad
    length: np.ndarray = None  # relative errors by link
    mass: float = 0.0  # relative error of all nominal masses
    line_mass: float = 0.0  # of every link, kg/m, beside its nominal mass
    payload: float = 0.0  # weight at the end point, N
    eccentricity: float = 0.0  # of the force on the end point, m, to the left of the last link
    force_bias: np.ndarray = None  # of the load cell that regulates a force on the end point, N
    force_turn: float = 0.0  # of the force on the end point, rad
    arms_of_loads: float = 0.0  # relative error of all moments of tendons and pressures
    capstan: float = 0.0  # friction of a tendon between neighbouring joints
    rest_loss: float = 0.0  # rest angles times exp(-rest_loss (i - 1))
    curling: float = 0.0  # moments of tendons and pressures times (1 + curling q_i), 1/rad
    load_delay: float = 0.0  # time constant by which tendon or pressure follows its gauge, s
    table: tuple = ()  # height m, stiffness N/m: it holds up the end point
    # instruments
    zero: float = 0.0  # of the load sensor, N m
    gain: float = 0.0
    drift: float = 0.0  # N m/s
    lag: float = 0.0  # s
    reading_scale: float = 0.0  # of the coordinates that are read
    disc: dict = field(default_factory=dict)  # joint -> amplitude rad, phase: an encoder off its axis

    @classmethod
    def none(cls, size):
        return cls([JointTruth() for _ in range(size)], length=np.zeros(size), force_bias=np.zeros(2))
