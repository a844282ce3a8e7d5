"""Effects that nobody could tell from a planted one at these readings: what they change differs by less than the noise can show."""
from dataclasses import dataclass, replace
from typing import Callable

import numpy as np

from causes import angle, encoders, gravity_places, heavy_links, load_joints, long_links, no_place, of_tracker, softness, weighed
from experiment import clean_readings
from truth import Truth

UNTOLD = 2.0  # standard deviations of all readings together: two nats of likelihood
NEAR = 0.3  # of the change that a linear forecast at the first few readings may leave, for all readings to be tried
FEW = 8


@dataclass(frozen=True)
class Row:
    """An effect with its parameters as a vector, in units that suit a first step."""
    id: str
    size: int
    put: Callable  # (truth, place, values)
    unit: Callable  # (shape, place) -> a small value
    places: Callable = lambda shape: range(shape.size)


def add(name):
    def put(truth, place, x):
        getattr(truth, name)[place] += x if x.size > 1 else x[0]
    return put


def add_whole(name):
    def put(truth, place, x):
        setattr(truth, name, getattr(truth, name) + (x if x.size > 1 else x[0]))
    return put


def put_ripple(truth, place, x):
    truth.ripple.append((place, float(np.hypot(*x)), 1.0, float(np.arctan2(x[0], x[1]))))


def put_tilt(truth, place, x):
    truth.base_tilt[:2] += x


def put_bending(truth, place, x):
    if x[0] > 0:
        truth.bending[place] = 1 / x[0]


def put_compliance(truth, place, x):
    truth.base_compliance = np.maximum(x, 0)


def put_play(truth, place, x):
    truth.play[place] = x[0]


def put_flange(truth, place, x):
    truth.loose_flange = abs(x[0])


ROWS = (
    Row("joint_zero", 1, add("zero"), angle),
    Row("joint_scale", 1, add("gear"), angle),
    Row("encoder_ripple", 2, put_ripple, angle, lambda s: [i for i in range(s.size) if s.links[i].kind == "hinge"]),
    Row("axis_shift", 3, add("shift"), of_tracker),
    Row("axis_tilt", 3, add("tilt"), angle),
    Row("joint_stiffness", 1, add("softer"), lambda s, p: 0.05, load_joints),
    Row("backlash", 1, put_play, angle, gravity_places),
    Row("link_mass", 1, add("heavier"), lambda s, p: 0.1, heavy_links),
    Row("link_centre", 3, add("centre"), lambda s, p: 0.01 * s.length, heavy_links),
    Row("link_flexibility", 1, put_bending, lambda s, p: softness(s, p) / s.length, long_links),
    Row("tool_mass", 1, add_whole("payload"), lambda s, p: 0.05 * s.payload, weighed),
    Row("gravity_compensation", 1, add_whole("compensated"), lambda s, p: 0.1, weighed),
    Row("tool_play", 1, put_flange, angle, weighed),
    Row("mount_tilt", 2, put_tilt, angle, no_place),
    Row("mount_compliance", 2, put_compliance, softness, weighed),
    Row("tracker_offset", 3, add_whole("tracker_shift"), of_tracker, no_place),
    Row("tracker_turn", 3, add_whole("tracker_turn"), angle, no_place),
    Row("tracker_scale", 1, add_whole("tracker_scale"), angle, no_place),
    Row("tool_offset", 3, add_whole("tip_shift"), of_tracker, no_place),
    Row("wrench_scale", 1, add_whole("force_gain"), lambda s, p: 0.05, no_place),
    Row("wrench_bias", 3, add_whole("force_bias"), lambda s, p: 0.5 * s.payload, no_place),
    Row("load_offset", 3, add_whole("load_offset"), lambda s, p: 0.01 * s.length, no_place),
    Row("angle_bias", 1, add("angle_bias"), lambda s, p: s.encoder, encoders),
    Row("angle_scale", 1, add("angle_scale"), lambda s, p: s.encoder, encoders),
)


def whitened(bench, readings):
    parts = []
    for places, reached in readings:
        parts.append((places / bench.shape.tracker).ravel())
        if bench.angles:
            parts.append((reached / bench.shape.encoder).ravel())
    return np.concatenate(parts)


class Change:
    """What a planted effect changes on a bench, in standard deviations of the noise."""

    def __init__(self, bench, nominal, readings):
        self.bench, self.nominal = bench, whitened(bench, nominal)
        self.planted = whitened(bench, readings) - self.nominal

    @classmethod
    def of_first(cls, count, bench, nominal, readings):
        """At the first readings of each run alone."""
        runs = [replace(run, commands=run.commands[:count], forces=run.forces[:count]) for run in bench.runs]
        first = [[(places[:count], reached[:count]) for places, reached in all_runs] for all_runs in (nominal, readings)]
        return cls(replace(bench, runs=runs), *first)

    def by(self, row, place, x):
        truth = Truth(self.bench.shape.size)
        row.put(truth, place, x)
        return whitened(self.bench, clean_readings(self.bench, truth)) - self.nominal

    def columns(self, row, place):
        """For a unit of each parameter."""
        unit = row.unit(self.bench.shape, place)
        return np.stack([self.by(row, place, unit * e) for e in np.eye(row.size)], 1)

    def is_near(self, row, place):
        columns = self.columns(row, place)
        best = np.linalg.lstsq(columns, self.planted, rcond=None)[0]
        return np.linalg.norm(self.planted - columns @ best) < NEAR * np.linalg.norm(self.planted)

    def is_imitated(self, row, place):
        """Whether the row's best parameters leave less than anybody can tell, by Gauss-Newton steps."""
        columns, x, left = self.columns(row, place), np.zeros(row.size), self.planted
        for _ in range(4):
            x = x + row.unit(self.bench.shape, place) * np.linalg.lstsq(columns, left, rcond=None)[0]
            left = self.planted - self.by(row, place, x)
            if np.linalg.norm(left) < UNTOLD:
                return True
        return False


def aliases(bench, nominal, readings, planted):
    """Keys of the single effects that imitate a single planted one."""
    whole, few = Change(bench, nominal, readings), Change.of_first(FEW, bench, nominal, readings)
    found = []
    for row in ROWS:
        for place in row.places(bench.shape):
            if (row.id, place) == (planted.cause.id, planted.place):
                continue
            try:
                if few.is_near(row, place) and whole.is_imitated(row, place):
                    found.append(row.id + (f"({place + 1})" if place >= 0 else ""))
            except (ArithmeticError, ValueError):  # so much of it that nothing stands, or a mass is negative: no model of MuJoCo's
                continue
    return found
