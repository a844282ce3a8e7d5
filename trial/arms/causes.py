"""The causes that a trial plants: those of the catalogue of effects, by its ids, and others.

A cause acts at one of its places (joints or links, from 1; 0 where it has none) with an amount, which the draw scales until the cause
changes the readings by so many standard deviations.
"""
from dataclasses import dataclass
from typing import Callable

import numpy as np

# Designs: any; there and back; pulled by a load cell; weights on the tip; reached angles in the table.
STATIC, TURNING, PULLED, LOADED, READ = "static", "turning", "pulled", "loaded", "read"


@dataclass(frozen=True)
class Cause:
    id: str
    plant: Callable  # (truth, shape, place from 0, amount, random) -> parameters by name
    typical: Callable  # (shape, place) -> amount
    most: float  # times the typical amount
    places: Callable = lambda shape: range(shape.size)
    design: str = STATIC
    words: str = ""  # of a cause outside the catalogue


def direction(random, size=3):
    v = random.normal(size=size)
    return v / np.linalg.norm(v)


def no_place(shape):
    return [-1]


def gravity_places(shape):
    return [j - 1 for j in shape.gravity_joints]


def load_joints(shape):
    """Joints that weights at the tip turn; without gravity's help, all but the last."""
    return gravity_places(shape) or range(shape.size - 1)


def torque_scale(shape, place):
    """A torque, or force, that turns a joint by a tenth of a milliradian, or moves it by as little."""
    return shape.links[place].stiffness * 1e-4


# of the catalogue

def zero(truth, shape, place, amount, random):
    a = amount * random.choice([-1, 1])
    truth.zero[place] += a
    return {"a": a}


def gear(truth, shape, place, amount, random):
    a = amount * random.choice([-1, 1])
    truth.gear[place] += a
    return {"g": a}


def stiffness(truth, shape, place, amount, random):
    a = amount if random.uniform() < 0.3 else -amount / (1 + amount)
    truth.softer[place] += a
    return {"a": a}


def encoder_ripple(truth, shape, place, amount, random):
    """Once a turn: the encoder's disc is off its axis."""
    phase = random.uniform(0, 2 * np.pi)
    truth.ripple.append((place, amount, 1.0, phase))
    return {"c": amount * np.sin(phase), "s": amount * np.cos(phase)}


def axis_shift(truth, shape, place, amount, random):
    d = amount * direction(random)
    truth.shift[place] += d
    return dict(zip("xyz", d))


def axis_tilt(truth, shape, place, amount, random):
    axis = np.array(shape.links[place].axis)
    d = direction(random)
    d -= axis * (axis @ d)
    truth.tilt[place] += amount * d / np.linalg.norm(d)
    return {}


def mass(truth, shape, place, amount, random):
    a = amount if random.uniform() < 0.6 else -amount / (1 + amount)
    truth.heavier[place] += a
    return {"m": a * shape.links[place].mass}


def centre(truth, shape, place, amount, random):
    d = amount * direction(random)
    truth.centre[place] += d
    return dict(zip(("d_x", "d_y", "d_z"), d))


def tool_mass(truth, shape, place, amount, random):
    truth.payload += amount
    return {"m": amount}


def load_offset(truth, shape, place, amount, random):
    d = amount * direction(random)
    truth.load_offset += d
    return dict(zip(("d_x", "d_y", "d_z"), d))


def compensation(truth, shape, place, amount, random):
    truth.compensated += amount
    return {"a": amount}


def base_tilt(truth, shape, place, amount, random):
    d = amount * direction(random, 2)
    truth.base_tilt[:2] += d
    return {"r_x": d[0], "r_y": d[1]}


def base_compliance(truth, shape, place, amount, random):
    c = amount * random.uniform(0.5, 1, 2)
    truth.base_compliance += c
    return {"c_x": c[0], "c_y": c[1]}


def tool_shift(truth, shape, place, amount, random):
    d = amount * direction(random)
    truth.tip_shift += d
    return dict(zip(("d_x", "d_y", "d_z"), d))


def tracker_offset(truth, shape, place, amount, random):
    d = amount * direction(random)
    truth.tracker_shift += d
    return {}


def tracker_turn(truth, shape, place, amount, random):
    truth.tracker_turn += amount * direction(random)
    return {}


def angle_bias(truth, shape, place, amount, random):
    b = amount * random.choice([-1, 1])
    truth.angle_bias[place] += b
    return {"b": b}


def angle_scale(truth, shape, place, amount, random):
    g = amount * random.choice([-1, 1])
    truth.angle_scale[place] += g
    return {"g": g}


def tracker_scale(truth, shape, place, amount, random):
    a = amount * random.choice([-1, 1])
    truth.tracker_scale += a
    return {"a": a}


def friction(truth, shape, place, amount, random):
    truth.friction[place] += amount
    return {"tau_c": amount}


def backlash(truth, shape, place, amount, random):
    truth.play[place] = amount
    return {"b": amount}


def bending(truth, shape, place, amount, random):
    truth.bending[place] = 1 / amount
    return {"f": amount}


def gas_spring(truth, shape, place, amount, random):
    """From the first link to the second, preloaded by the amount, with a force that falls by half over its stroke."""
    reach = shape.length
    stiffness = 0.5 * amount / (0.3 * reach)
    truth.gas_spring = (stiffness, amount / stiffness + 0.3 * reach, (-0.1 * reach, 0.05 * reach, 0.12 * reach), 1,
                        tuple(0.12 * reach * np.array([0.6, 0.5, 0.6])))
    return {}


def hardening(truth, shape, place, amount, random):
    truth.hardening += amount
    return {"c": amount}


def force_gain(truth, shape, place, amount, random):
    g = amount * random.choice([-1, 1])
    truth.force_gain += g
    return {"g": g}


def force_bias(truth, shape, place, amount, random):
    b = amount * direction(random)
    truth.force_bias += b
    return dict(zip(("F_x", "F_y", "F_z"), b))


def belt(truth, shape, place, amount, random):
    """An elastic element that slips, beside a joint's spring."""
    truth.belt[place] = (0.6 * shape.links[place].stiffness, amount)
    return {}


def loose_flange(truth, shape, place, amount, random):
    truth.loose_flange = amount
    return {"b_y": amount}


# outside the catalogue

def ripple(truth, shape, place, amount, random):
    truth.ripple.append((place, amount, random.uniform(4, 25), random.uniform(0, 2 * np.pi)))
    return {}


def coupling(truth, shape, place, amount, random):
    """As of a wrist whose gears turn with each other, with a wrong compensation."""
    truth.coupling[place - 1] = amount * random.choice([-1, 1])
    return {}


def cable(truth, shape, place, amount, random):
    reach = shape.length
    overhead = np.array([random.uniform(-0.3, 0.3), random.uniform(-0.3, 0.3), random.uniform(0.7, 1.0)]) * reach
    truth.cable = (amount, 0.35 * reach, tuple(overhead), max(1, shape.size - 3), (0, 0, 0.02 * reach))
    return {}


def uneven(truth, shape, place, amount, random):
    truth.uneven[place] = amount * random.choice([-1, 1])
    return {}


def floor(truth, shape, place, amount, random):
    """Something soft that the lowest poses touch."""
    truth.floor = (shape.reach[0] + 0.22 * shape.length, amount)
    return {}


def growth(truth, shape, place, amount, random):
    truth.growth = amount
    return {}


def sinking(truth, shape, place, amount, random):
    truth.sinking = amount * direction(random, 2)
    return {}


def bump(truth, shape, place, amount, random):
    truth.bump = amount * direction(random)
    return {}


def of_tracker(shape, place):
    return 3 * shape.tracker


def angle(shape, place):
    return 3 * shape.tracker / shape.length


def weighed(shape):
    return [-1] if shape.gravity_joints else []


def heavy_links(shape):
    return [i for i in range(1, shape.size) if shape.links[i].mass > 0.01] if shape.gravity_joints else []


def long_links(shape):
    return [i for i in range(1, shape.size - 1) if np.linalg.norm(shape.links[i + 1].place) > 0 and shape.links[i].kind == "hinge"]


def encoders(shape):
    return range(shape.size) if shape.encoder > 0 else []


def second_joint(shape):
    return [1] if shape.gravity_joints else []


def softness(shape, place):
    """Of a gear that turns the stretched arm by ten standard deviations of the tracker under a tenth of its load."""
    return 100 * shape.tracker / (9.81 * shape.payload * shape.length**2)


def curvature(shape, place):
    largest = 9.81 * shape.payload * shape.length / shape.stiffness[1]
    return 0.3 / largest**2


INSIDE = (
    Cause("joint_zero", zero, lambda s, p: s.length * angle(s, p) if s.links[p].kind == "slide" else angle(s, p), 100),
    Cause("joint_scale", gear, angle, 100),
    Cause("encoder_ripple", encoder_ripple, angle, 100, places=lambda s: [i for i in range(s.size) if s.links[i].kind == "hinge"]),
    Cause("axis_shift", axis_shift, of_tracker, 100),
    Cause("axis_tilt", axis_tilt, angle, 100),
    Cause("joint_stiffness", stiffness, lambda s, p: 0.2, 12, places=load_joints),
    Cause("nonlinear_spring", hardening, curvature, 100, places=weighed, design=LOADED),
    Cause("joint_friction", friction, torque_scale, 100, design=TURNING),
    Cause("hysteresis", belt, torque_scale, 100, design=TURNING),
    Cause("backlash", backlash, angle, 100, places=gravity_places),
    Cause("joint_balance", gas_spring, lambda s, p: 9.81 * s.payload * 0.3, 30, places=second_joint),
    Cause("link_mass", mass, lambda s, p: 0.1, 20, places=heavy_links),
    Cause("link_centre", centre, lambda s, p: 0.01 * s.length, 15, places=heavy_links),
    Cause("link_flexibility", bending, lambda s, p: softness(s, p) / s.length, 50, places=long_links),
    Cause("tool_mass", tool_mass, lambda s, p: 0.05 * s.payload, 12, places=weighed),
    Cause("tool_play", loose_flange, angle, 300, places=weighed),
    Cause("gravity_compensation", compensation, lambda s, p: 0.2, 5, places=weighed),
    Cause("mount_tilt", base_tilt, angle, 100, places=no_place),
    Cause("mount_compliance", base_compliance, softness, 50, places=weighed),
    Cause("tracker_offset", tracker_offset, of_tracker, 100, places=no_place),
    Cause("tracker_turn", tracker_turn, angle, 100, places=no_place),
    Cause("tracker_scale", tracker_scale, angle, 100, places=no_place),
    Cause("tool_offset", tool_shift, of_tracker, 100, places=no_place),
    Cause("wrench_scale", force_gain, lambda s, p: 0.05, 15, places=no_place, design=PULLED),
    Cause("wrench_bias", force_bias, lambda s, p: 0.05 * 9.81 * s.payload, 15, places=no_place, design=PULLED),
    Cause("load_offset", load_offset, lambda s, p: 0.01 * s.length, 20, places=weighed, design=LOADED),
    Cause("angle_bias", angle_bias, lambda s, p: 3 * s.encoder, 100, places=encoders, design=READ),
    Cause("angle_scale", angle_scale, lambda s, p: 3 * s.encoder, 100, places=encoders, design=READ),
)

OUTSIDE = (
    Cause("unknown", ripple, angle, 100, words="a joint's position ripples many times a turn"),
    Cause("unknown", coupling, angle, 100, words="a joint turns along with the one before", places=lambda s: range(1, s.size)),
    Cause("unknown", cable, lambda s, p: 0.2 * s.payload * 9.81 / s.length, 100, places=no_place, words="a cable from overhead pulls at the forearm"),
    Cause("unknown", uneven, lambda s, p: 0.1, 8, places=load_joints, words="a joint is stiffer at some angles"),
    Cause("unknown", floor, lambda s, p: 5 * s.payload * 9.81 / s.length, 100, places=weighed, words="the lowest poses touch something soft"),
    Cause("unknown", growth, angle, 100, places=no_place, words="the arm grows with the temperature of the day"),
    Cause("unknown", sinking, angle, 100, places=no_place, words="the base sinks to one side in the course of the session"),
    Cause("unknown", bump, of_tracker, 100, places=no_place, words="the tracker was moved half-way"),
)
