"""The effects of the catalogue that these benches can show, by its ids and with its parameters (docs/effects.md).

A row puts its effect into a truth; the trial plants rows and fits them to each other's readings.
"""
from dataclasses import dataclass
from typing import Callable

import numpy as np

from scales import deflection_scale, duration, mean_deflection
from truth import Slider

RIGID = 1e4  # stiffness of a dry contact that sticks, over the joint's


def everywhere(bench):
    return [-1]


def each_joint(bench):
    return list(range(bench.size))


def always(bench):
    return True


@dataclass(frozen=True)
class Row:
    id: str
    names: tuple  # of its parameters
    put: Callable  # (truth, bench, place from 0 or -1, values)
    drawn: Callable  # (bench, place, random) -> values of an effect that is to be planted, before it is scaled
    starts: Callable  # (bench, place) -> list of values from which a fit starts
    places: Callable = everywhere
    possible: Callable = always
    positive: bool = True  # whether no parameter is below zero
    scaled: tuple = (0,)  # parameters that make it stronger
    most: float = 1e9  # times the drawn values
    planted: bool = True  # whether the trial plants it
    alone: bool = False  # whether it is planted without another effect


def one_of(drawn):
    """A parameter of either sign, drawn or started at a size."""
    return {"drawn": lambda b, p, r: [drawn(b, p) * r.choice([-1, 1])], "starts": lambda b, p: [[drawn(b, p)], [-drawn(b, p)]],
            "positive": False}


def size_of(size):
    """A positive parameter, drawn or started at a size."""
    return {"drawn": lambda b, p, r: [size(b, p)], "starts": lambda b, p: [[size(b, p)], [3 * size(b, p)]]}


def ratio(value):
    return lambda bench, place: value


def of_deflection(share):
    return lambda bench, place: share * (deflection_scale(bench)[place] if place >= 0 else mean_deflection(bench))


def joints_of(truth, place):
    return truth.joints if place < 0 else [truth.joints[place]]


def all_torques(bench):
    return bench.stiffness.mean() * mean_deflection(bench)


def thresholds(second):
    """Starts of a row with an angle beyond which something happens."""
    return lambda b, p: [[share * of_deflection(1)(b, p), second(b, p)] for share in (0.15, 0.4, 0.7)]


def of_stiffness(times):
    return lambda b, p: times * (b.stiffness[p] if p >= 0 else b.stiffness.mean())


# joints

def put_stiffness(truth, bench, place, x):
    for joint in joints_of(truth, place):
        joint.softer += x[0]


def put_rest(truth, bench, place, x):
    for joint in joints_of(truth, place):
        joint.rest += x[0]


def put_hardening(truth, bench, place, x):
    for joint in truth.joints:
        joint.hardening += x[0]


def put_play(truth, bench, place, x):
    truth.joints[place].play = x[0]


def put_stop(truth, bench, place, x):
    for joint in joints_of(truth, place):
        joint.stop = tuple(x)


def put_coupling(truth, bench, place, x):
    truth.coupling += x[0]


def put_uneven(truth, bench, place, x):
    for joint in truth.joints:
        joint.uneven += x[0]


def put_knee(truth, bench, place, x):
    for joint in joints_of(truth, place):
        joint.knee = tuple(x)


def put_arms(truth, bench, place, x):
    for joint, k in zip(truth.joints, bench.stiffness):
        joint.arms += [(m * k, max(tau, 1e-9)) for m, tau in zip(x[::2], x[1::2])]


def put_plastic(truth, bench, place, x):
    for joint in truth.joints:
        joint.plastic = tuple(x)


def put_hysteresis(truth, bench, place, x):
    """Jenkins elements: stiffness r k_i; slip torque r k d with the mean stiffness k, at one joint with its own."""
    for j, joint in enumerate(truth.joints):
        if place in (-1, j):
            k = bench.stiffness.mean() if place < 0 else bench.stiffness[j]
            for r, d in zip(x[::2], x[1::2]):
                joint.sliders.append(Slider(r * bench.stiffness[j], lambda q, e, slip=r * k * d: (slip, slip), False))


def put_contact(truth, bench, limit):
    for joint, k in zip(truth.joints, bench.stiffness):
        joint.sliders.append(Slider(RIGID * k, limit, True))


def put_friction(truth, bench, place, x):
    put_contact(truth, bench, lambda q, d: (x[0], x[0]))


def put_load_friction(truth, bench, place, x):
    put_contact(truth, bench, lambda q, d: (x[0] * (1 + x[1] * abs(d)),) * 2)


def put_direction_friction(truth, bench, place, x):
    put_contact(truth, bench, lambda q, d: (x[0] * (1 + x[1]), x[0] * max(0.0, 1 - x[1])))


def put_rest_loss(truth, bench, place, x):
    truth.rest_loss += x[0]


# links, weights, loads

def put_length(truth, bench, place, x):
    truth.length[slice(None) if place < 0 else place] += x[0]


def put_number(name):
    def put(truth, bench, place, x):
        setattr(truth, name, getattr(truth, name) + x[0])
    return put


def put_force_bias(truth, bench, place, x):
    truth.force_bias = truth.force_bias + np.array(x)


def is_chain(b):
    return not b.alone


def several(b):
    return b.size > 1


def weighed(b):
    return b.plane == "vertical"


def tip_loaded(b):
    return any(run.force is not None for run in b.runs)


def has_moments(b):
    return b.load in ("tendon", "pressure")


def by_cell(b):
    return is_chain(b) and all(run.control == "force" and not run.loaded_by for run in b.runs)


def reverses(b):
    return b.sweep


def turns(b):
    """Friction is planted where the command goes there and back."""
    return b.sweep


def has_rest(b):
    return b.size > 1 and any(np.any(run.command[:, 1:]) for run in b.runs)


def weight_scale(b, place):
    """A weight, N, that turns the stretched chain as far as its loads do."""
    return 0.2 * b.stiffness[0] * mean_deflection(b) / b.length.sum()


def clock(b):
    return b.clock


def sensor_torque(share):
    return lambda b, p: share * all_torques(b)


JOINTS = (
    Row("joint_stiffness", ("a",), put_stiffness, lambda b, p, r: [0.1 * r.choice([-1, 1])], lambda b, p: [[0.1], [-0.3], [1.0]], each_joint,
        positive=False, most=8),
    Row("rest_angle", ("a",), put_rest, places=each_joint, **one_of(of_deflection(0.1))),
    Row("nonlinear_spring", ("c",), put_hardening, lambda b, p, r: [0.1 / mean_deflection(b)**2],
        lambda b, p: [[0.1 / mean_deflection(b)**2]], most=80),
    Row("backlash", ("b",), put_play, places=each_joint, most=12, **size_of(of_deflection(0.05))),
    Row("joint_stop", ("s", "k_s"), put_stop, lambda b, p, r: [r.uniform(0.3, 0.8) * of_deflection(1)(b, p), b.stiffness[p]],
        thresholds(of_stiffness(1)), each_joint, scaled=(1,), most=100),
    Row("joint_coupling", ("kappa",), put_coupling, possible=several, most=4, **one_of(of_stiffness(0.1))),
    Row("viscoelasticity", ("m", "tau"), put_arms, lambda b, p, r: [0.2, duration(b) * np.exp(r.uniform(np.log(0.05), np.log(0.5)))],
        lambda b, p: [[0.2, share * duration(b)] for share in (0.03, 0.15, 0.6)], possible=clock, most=20),
    Row("stiffness_scale", ("a",), put_stiffness, lambda b, p, r: [0.1 * r.choice([-1, 1])], lambda b, p: [[0.1], [-0.3], [1.0]], possible=several,
        positive=False, most=8),
    Row("rest_offset", ("a",), put_rest, possible=several, **one_of(of_deflection(0.1))),
    Row("asymmetric_spring", ("e",), put_uneven, most=8, **one_of(ratio(0.1))),
    Row("piecewise_spring", ("s", "a"), put_knee, lambda b, p, r: [r.uniform(0.2, 0.7) * of_deflection(1)(b, p), 0.2], thresholds(ratio(0.3)),
        possible=several, scaled=(1,), most=4.5),
    Row("piecewise_spring", ("s", "a"), put_knee, lambda b, p, r: [r.uniform(0.2, 0.7) * of_deflection(1)(b, p), 0.2], thresholds(ratio(0.3)),
        each_joint, scaled=(1,), most=4.5),
    Row("joint_stops", ("s", "k_s"), put_stop, lambda b, p, r: [r.uniform(0.3, 0.8) * of_deflection(1)(b, p), b.stiffness.mean()],
        thresholds(of_stiffness(1)), possible=several, scaled=(1,), most=100),
    Row("hysteresis", ("r_1", "d_1"), put_hysteresis, lambda b, p, r: [0.5, r.uniform(0.1, 0.4) * of_deflection(1)(b, p)],
        lambda b, p: [[0.5, share * of_deflection(1)(b, p)] for share in (0.1, 0.4)], possible=lambda b: reverses(b) and several(b),
        most=6, alone=True),
    Row("hysteresis", ("r_1", "d_1"), put_hysteresis, lambda b, p, r: [0.5, r.uniform(0.1, 0.4) * of_deflection(1)(b, p)],
        lambda b, p: [[0.5, share * of_deflection(1)(b, p)] for share in (0.1, 0.4)], each_joint, reverses, most=6, alone=True),
    Row("plastic_set", ("tau_y", "slope"), put_plastic, lambda b, p, r: [r.uniform(0.3, 0.7) * all_torques(b), 0.2],
        lambda b, p: [[share * all_torques(b), 0.2] for share in (0.3, 0.7)], possible=reverses, scaled=(1,), most=80, alone=True),
    Row("joint_friction", ("tau_c",), put_friction, possible=turns, **size_of(lambda b, p: 0.05 * all_torques(b))),
    Row("load_friction", ("tau_c", "growth"), put_load_friction, lambda b, p, r: [0.03 * all_torques(b), 3 / mean_deflection(b)],
        lambda b, p: [[0.05 * all_torques(b), 1 / mean_deflection(b)]], possible=turns, most=12, alone=True),
    Row("direction_friction", ("tau_c", "uneven"), put_direction_friction,
        lambda b, p, r: [0.05 * all_torques(b), r.uniform(0.4, 0.9) * r.choice([-1, 1])],
        lambda b, p: [[0.05 * all_torques(b), 0.4], [0.05 * all_torques(b), -0.4]], possible=turns, positive=False, alone=True),
    Row("tendon_friction", ("mu",), put_rest_loss, possible=has_rest, planted=False, **size_of(ratio(0.02))),
)

CHAINS = (
    Row("link_length", ("a",), put_length, places=each_joint, possible=is_chain, most=12, **one_of(ratio(0.02))),
    Row("length_scale", ("a",), put_length, possible=several, most=12, **one_of(ratio(0.02))),
    Row("gravity", ("rho",), put_number("line_mass"), possible=weighed, **size_of(lambda b, p: weight_scale(b, p) / 9.81 / b.length.sum())),
    Row("mass_scale", ("a",), put_number("mass"), possible=lambda b: weighed(b) and b.mass is not None, most=9, **one_of(ratio(0.1))),
    Row("tip_payload", ("weight",), put_number("payload"), possible=weighed, **size_of(weight_scale)),
    Row("eccentric_load", ("e",), put_number("eccentricity"), possible=tip_loaded, most=15, **one_of(lambda b, p: 0.05 * b.length.mean())),
    Row("rail_misalignment", ("eps",), put_number("force_turn"), possible=tip_loaded, planted=False, **one_of(ratio(0.05))),
    Row("force_bias", ("b_x", "b_y"), put_force_bias, lambda b, p, r: [0, 0], lambda b, p: [[weight_scale(b, p)] * 2], possible=by_cell,
        positive=False, planted=False),
    Row("moment_arm", ("a",), put_number("arms_of_loads"), lambda b, p, r: [0.1 * r.choice([-1, 1])], lambda b, p: [[0.1], [-0.3]],
        possible=has_moments, positive=False, most=7),
    Row("capstan_friction", ("mu",), put_number("capstan"), possible=lambda b: b.load == "tendon" and several(b), most=15, **size_of(ratio(0.05))),
)


def put_disc(truth, bench, place, x):
    truth.disc[place] = (float(np.hypot(*x)), float(np.arctan2(*x)))


def off_axis(bench, place, random):
    phase = random.uniform(0, 2 * np.pi)
    return [10 * bench.noise * np.sin(phase), 10 * bench.noise * np.cos(phase)]


SENSORS = (
    Row("load_zero", ("b",), put_number("zero"), possible=lambda b: b.by_sensor, **one_of(sensor_torque(0.1))),
    Row("load_gain", ("g",), put_number("gain"), possible=lambda b: b.by_sensor, most=7, **one_of(ratio(0.1))),
    Row("load_drift", ("r",), put_number("drift"), possible=lambda b: b.by_sensor and b.clock,
        **one_of(lambda b, p: 0.1 * all_torques(b) / duration(b))),
    Row("load_lag", ("tau",), put_number("lag"), possible=lambda b: b.by_sensor and b.clock and b.is_held, most=10,
        **size_of(lambda b, p: 0.02 * duration(b))),
    Row("encoder_ripple", ("c", "s"), put_disc, off_axis, lambda b, p: [[10 * b.noise, 0.0], [0.0, 10 * b.noise]], each_joint,
        lambda b: b.kind in ("poses", "sweep"), positive=False, scaled=(0, 1)),
    # of the stroke of a joint that slides
    Row("camera_scale", ("a",), put_number("reading_scale"), possible=lambda b: b.alone == "prismatic" and not b.is_held, planted=False,
        **one_of(ratio(0.1))),
)

ROWS = JOINTS + CHAINS + SENSORS
# Rows with one parameter more, of which the simpler row is a special value: no alias of it, for the simpler row says all that is there.
CONTAINS = {("load_friction", "joint_friction"), ("direction_friction", "joint_friction")}


def rows_at(bench):
    """Every row at every place of a bench."""
    return [(row, place) for row in ROWS if row.possible(bench) for place in row.places(bench)]


def key(row, place):
    return row.id + (f"({place + 1})" if place >= 0 else "")
