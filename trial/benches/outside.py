"""Causes outside the catalogue: of the gear, the spring, the contact with something, the mounting, the drive of a tendon, the encoder."""
from dataclasses import dataclass
from typing import Callable

import numpy as np

from catalogue import each_joint, everywhere, has_moments, is_chain, weighed
from loads import shape
from scales import deflection_scale, duration
from statics import clean_readings
from truth import Slider, Truth


@dataclass(frozen=True)
class Outside:
    words: str
    put: Callable  # (truth, bench, place, amount, random)
    size: Callable  # (bench, place) -> the amount from which the draw starts
    possible: Callable
    places: Callable = each_joint
    most: float = 1e9  # times the size


def travel(bench, place):
    """The least and the largest nominal coordinate of a joint, rad (m)."""
    nominal = clean_readings(bench, Truth.none(bench.size))
    all_q = np.concatenate([run.imposed if run.is_held else read[:, place] for run, read in zip(bench.runs, nominal)])
    return float(all_q.min()), float(all_q.max())


def spot(bench, place, random, low, high):
    """A coordinate at a share of the travel, and the travel's width."""
    first, last = travel(bench, place)
    return first + random.uniform(low, high) * (last - first), last - first


def torque(share):
    return lambda b, p: share * b.stiffness[p] * deflection_scale(b)[p]


def turned(share):
    return lambda b, p: share * deflection_scale(b)[p]


def put_cogging(truth, bench, place, amount, random):
    """A ripple of 1.5 to 6 periods over the travel, too weak for jumps."""
    _, width = spot(bench, place, random, 0, 1)
    waves, phase = 2 * np.pi * random.uniform(1.5, 6) / width, random.uniform(0, 2 * np.pi)
    largest = np.inf if bench.is_held else 0.6 * bench.stiffness[place] / waves
    truth.joints[place].beside.append(lambda q: min(amount, largest) * np.sin(waves * q + phase))


def put_tooth(truth, bench, place, amount, random):
    """A lag of the joint behind its motor over some hundredths of the travel."""
    where, width = spot(bench, place, random, 0.25, 0.75)
    half = random.uniform(0.04, 0.1) * width
    lag = amount if bench.is_held else min(amount, 0.7 * half)
    truth.joints[place].shift = lambda time, q: -lag * np.exp(-((q - where) / half) ** 2)


def put_cable(truth, bench, place, amount, random):
    """A cable in a sheath: it pulls beyond a coordinate, and rubs in proportion to its pull."""
    where, width = spot(bench, place, random, 0.45, 0.7)
    stiffness, mu = amount / width, random.uniform(0.3, 0.8)
    pull = lambda q: stiffness * (q - where + abs(q - where)) / 2
    truth.joints[place].beside.append(pull)
    truth.joints[place].sliders.append(Slider(20 * bench.stiffness[place], lambda q, d: (mu * pull(q), mu * pull(q)), True))


def put_ball(truth, bench, place, amount, random):
    """A round thing that the joint meets, with the law of Hertz: force as the power 1.5 of the indentation."""
    where, width = spot(bench, place, random, 0.4, 0.7)
    truth.joints[place].beside.append(lambda q: amount * ((q - where + abs(q - where)) / (2 * width)) ** 1.5)


def put_dirt(truth, bench, place, amount, random):
    where, width = spot(bench, place, random, 0.25, 0.75)
    half = random.uniform(0.08, 0.2) * width

    def limit(q, d):
        slip = amount * np.exp(-((q - where) / half) ** 2) + 1e-12
        return slip, slip
    truth.joints[place].sliders.append(Slider(300 * bench.stiffness[place], limit, True))


def put_warming(truth, bench, place, amount, random):
    share, tau = amount / (1 + amount), random.uniform(0.2, 0.6) * duration(bench)
    truth.joints[place].share = lambda time: 1 - share * (1 - np.exp(-time / tau))


def put_break(truth, bench, place, amount, random):
    share, when = amount / (1 + amount), random.uniform(0.3, 0.7) * duration(bench)
    truth.joints[place].share = lambda time: np.where(time > when, 1 - share, 1.0)


def put_slip(truth, bench, place, amount, random):
    when, step = random.uniform(0.3, 0.7) * duration(bench), amount * random.choice([-1, 1])
    truth.joints[place].shift = lambda time, q: np.where(time > when, step, 0.0)


def put_table(truth, bench, place, amount, random):
    nominal = np.concatenate(clean_readings(bench, Truth.none(bench.size)))
    heights = shape(nominal, bench.length)[1][:, -1, 1]
    truth.table = (float(np.quantile(heights, random.uniform(0.2, 0.4))), amount)


def put_balance(truth, bench, place, amount, random):
    """A spring between the base and the first link: a torque as the sine of the angle from where it is slack."""
    slack = random.uniform(-1.5, 1.5)
    truth.joints[0].beside.append(lambda q: amount * np.sin(q - slack))


def put_curling(truth, bench, place, amount, random):
    truth.curling = amount * random.choice([-1, 1])


def put_delay(truth, bench, place, amount, random):
    truth.load_delay = amount


def turns(b):
    return b.alone != "prismatic" and b.kind != "flexure"


def one_history(b):
    return b.clock and len(b.runs) == 1


def swept(b):
    return b.sweep


CAUSES = (
    Outside("a motor's torque cogs many times over the travel", put_cogging, torque(0.03), turns, most=30),
    Outside("a tooth of the gear is broken", put_tooth, turned(0.2), turns, most=20),
    Outside("a cable in its sheath tugs beyond an angle", put_cable, torque(0.3), swept),
    Outside("the joint meets something round", put_ball, torque(0.5), lambda b: True),
    Outside("dirt rubs in one part of the travel", put_dirt, torque(0.1), swept, most=20),
    Outside("a spring softens as it warms up", put_warming, lambda b, p: 0.1, lambda b: one_history(b) and swept(b), most=40),
    Outside("a leaf of a spring breaks", put_break, lambda b, p: 0.1, lambda b: one_history(b) and swept(b), most=40),
    Outside("the clamp slips once", put_slip, turned(0.1), one_history),
    Outside("the end point touches a table", put_table, lambda b, p: b.stiffness[0] / b.length.sum() ** 2, lambda b: is_chain(b) and weighed(b),
            everywhere),
    Outside("a spring from the base balances the arm", put_balance, torque(0.3), lambda b: b.kind in ("poses", "sweep"), lambda b: [0]),
    Outside("a lever that changes with the angle", put_curling, lambda b, p: 0.2, has_moments, everywhere, most=8),
    Outside("the load at the joints lags behind its gauge", put_delay, lambda b, p: 0.03 * duration(b), has_moments, everywhere, most=10),
)
