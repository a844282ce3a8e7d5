"""The causes that a trial plants: those of the catalogue of effects, by its ids, and others.

A cause acts at one of its places (joints or links, from 1; 0 where it has none) with an amount, which the draw scales until the cause
changes the readings by so many standard deviations.
"""
from dataclasses import dataclass
from typing import Callable

import numpy as np

STATIC, TURNING, PULLED = "static", "turning", "pulled"  # any design; one that goes there and back; one that pulls with a load cell


@dataclass(frozen=True)
class Cause:
    id: str
    plant: Callable  # (truth, shape, place from 0, amount, random) -> parameters by name
    typical: Callable  # shape, place -> amount
    most: float  # times the typical amount
    places: Callable = lambda shape: range(shape.size)
    design: str = STATIC
    words: str = ""  # of a cause outside the catalogue
    local: bool = True  # whether its place is part of the answer


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
    return {"a": a}


def stiffness(truth, shape, place, amount, random):
    a = amount if random.uniform() < 0.3 else -amount / (1 + amount)
    truth.softer[place] += a
    return {"a": a}


def frame_shift(truth, shape, place, amount, random):
    d = amount * direction(random)
    truth.shift[place] += d
    return dict(zip(("d_x", "d_y", "d_z"), d))


def frame_tilt(truth, shape, place, amount, random):
    d = amount * direction(random)
    truth.tilt[place] += d
    return dict(zip(("r_x", "r_y", "r_z"), d))


def mass(truth, shape, place, amount, random):
    a = amount if random.uniform() < 0.6 else -amount / (1 + amount)
    truth.heavier[place] += a
    return {"a": a}


def centre(truth, shape, place, amount, random):
    d = amount * direction(random)
    truth.centre[place] += d
    return dict(zip(("c_x", "c_y", "c_z"), d))


def payload(truth, shape, place, amount, random):
    truth.payload += amount
    return {"weight": 9.81 * amount}


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


def tracker_frame(truth, shape, place, amount, random):
    d, r = amount * direction(random), amount / shape.length * direction(random)
    truth.tracker_shift += d
    truth.tracker_turn += r
    return {}


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
    return {"EI": 1 / amount}


def gas_spring(truth, shape, place, amount, random):
    """From the base to the second link, preloaded by the amount, with a force that falls by half over its stroke."""
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
    return dict(zip(("b_x", "b_y", "b_z"), b))


# outside the catalogue

def ripple(truth, shape, place, amount, random):
    truth.ripple.append((place, amount, random.uniform(4, 25), random.uniform(0, 2 * np.pi)))
    return {}


def belt(truth, shape, place, amount, random):
    """An elastic element that slips, beside a joint's spring."""
    truth.belt[place] = (0.6 * shape.links[place].stiffness, amount)
    return {}


def cable(truth, shape, place, amount, random):
    reach = shape.length
    overhead = np.array([random.uniform(-0.3, 0.3), random.uniform(-0.3, 0.3), random.uniform(0.7, 1.0)]) * reach
    truth.cable = (amount, 0.35 * reach, tuple(overhead), max(1, shape.size - 3), (0, 0, 0.02 * reach))
    return {}


def loose_flange(truth, shape, place, amount, random):
    truth.loose_flange = amount
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


def not_scara(shape):
    return [-1] if shape.gravity_joints else []


INSIDE = (
    Cause("joint_zero", zero, lambda s, p: s.tracker * 3 if s.links[p].kind == "slide" else angle(s, p), 100),
    Cause("joint_scale", gear, lambda s, p: angle(s, p), 100),
    Cause("joint_stiffness", stiffness, lambda s, p: 0.2, 12, places=load_joints),
    Cause("frame_shift", frame_shift, of_tracker, 100),
    Cause("frame_tilt", frame_tilt, angle, 100),
    Cause("link_mass", mass, lambda s, p: 0.1, 20, places=lambda s: [i for i in range(1, s.size) if s.links[i].mass > 0.01] if s.gravity_joints else [2]),
    Cause("link_centre", centre, lambda s, p: 0.01 * s.length, 15, places=lambda s: range(1, s.size - 1) if s.gravity_joints else []),
    Cause("tip_payload", payload, lambda s, p: 0.05 * s.payload, 12, places=no_place),
    Cause("base_tilt", base_tilt, angle, 100, places=no_place),
    Cause("base_compliance", base_compliance, lambda s, p: 0.2 / s.stiffness[0], 20, places=not_scara),
    Cause("tool_shift", tool_shift, of_tracker, 100, places=no_place),
    Cause("tracker_frame", tracker_frame, of_tracker, 100, places=no_place),
    Cause("tracker_scale", tracker_scale, angle, 100, places=no_place),
    Cause("joint_friction", friction, torque_scale, 100, design=TURNING),
    Cause("backlash", backlash, lambda s, p: angle(s, p), 100, places=gravity_places),
    Cause("link_bending", bending, lambda s, p: 0.3 / (s.stiffness[p] * s.length / s.size), 20,
          places=lambda s: [i for i in range(1, s.size - 1) if s.links[i + 1].place != (0, 0, 0) and s.links[i].kind == "hinge"]),
    Cause("counterweight", gas_spring, lambda s, p: 9.81 * s.payload * 0.3, 30, places=not_scara),
    Cause("nonlinear_spring", hardening, lambda s, p: 0.1 / (np.max([9.81 * s.payload * s.length, 1e-3 * s.stiffness.min()]) / s.stiffness[:3].min())**2,
          100, places=not_scara),
    Cause("force_gain", force_gain, lambda s, p: 0.05, 15, places=no_place, design=PULLED),
    Cause("force_bias", force_bias, lambda s, p: 0.05 * 9.81 * s.payload, 15, places=no_place, design=PULLED),
)

OUTSIDE = (
    Cause("unknown", ripple, angle, 100, words="a joint's position ripples with its angle"),
    Cause("unknown", belt, torque_scale, 100, design=TURNING, words="a belt beside a joint's spring slips"),
    Cause("unknown", cable, lambda s, p: 0.2 * s.payload * 9.81 / s.length, 100, places=no_place, words="a cable from overhead pulls at the forearm", local=False),
    Cause("unknown", loose_flange, angle, 300, places=not_scara, words="the flange is loose: the tool tips", local=False),
    Cause("unknown", floor, lambda s, p: 5 * s.payload * 9.81 / s.length, 100, places=not_scara, words="the lowest poses touch something soft", local=False),
    Cause("unknown", growth, angle, 100, places=no_place, words="the arm grows with the temperature of the day", local=False),
    Cause("unknown", sinking, angle, 100, places=no_place, words="the base sinks to one side in the course of the session", local=False),
    Cause("unknown", bump, of_tracker, 100, places=no_place, words="the tracker was moved half-way", local=False),
)
