"""Torques of weights, forces, tendons and pressures about the joints of a planar chain, at many shapes at once."""
import numpy as np

from bench import GRAVITY


def shape(q, length):
    """Unit vectors along the links and the places of joints and end point: (reading, link, 2), (reading, link + 1, 2)."""
    theta = np.cumsum(q, axis=1)
    along = np.stack([np.cos(theta), np.sin(theta)], axis=2)
    places = np.concatenate([np.zeros((len(q), 1, 2)), np.cumsum(along * length[:, None], axis=1)], axis=1)
    return along, places


def moments(places, point, force, last):
    """Of a force at a point of link `last` (from 0), about each joint: (reading, joint), N m."""
    arm = point[:, None, :] - places[:, :-1, :]
    result = arm[:, :, 0] * force[:, 1:] - arm[:, :, 1] * force[:, :1]
    result[:, last + 1:] = 0.0
    return result


def tensions(value, joints, mu):
    """(reading, joint): a tendon's tension at each joint that it passes, with friction between neighbours; relaxed at first."""
    result = np.tile(value[:, None], (1, joints))
    if mu > 0:
        for j in range(1, joints):
            for i in range(1, len(value)):
                result[i, j] = np.clip(result[i - 1, j], result[i, j - 1] * np.exp(-mu), result[i, j - 1] * np.exp(mu))
    return result


def delayed(value, time, tau):
    """A first-order lag of what goes straight between readings; at rest at first."""
    if tau <= 0:
        return value
    result = [value[0]]
    for i in range(1, len(value)):
        interval = time[i] - time[i - 1]
        slope = (value[i] - value[i - 1]) / interval
        left = result[-1] - value[i - 1] + slope * tau
        result.append(value[i] - slope * tau + left * np.exp(-interval / tau))
    return np.array(result)


class Loads:
    """Of one run. `torques(q, d)` gives (reading, joint), N m."""

    def __init__(self, bench, truth, run):
        self.bench, self.truth, self.run = bench, truth, run
        self.length = bench.length * (1 + truth.length)
        self.weights = truth.line_mass * self.length * GRAVITY
        if bench.mass is not None:
            self.weights = self.weights + bench.mass * (1 + truth.mass) * GRAVITY
        if run.value is not None:
            value = delayed(run.value, run.time, truth.load_delay)
            self.pull = tensions(value, bench.size, truth.capstan if bench.load == "tendon" else 0.0) * bench.lever * (1 + truth.arms_of_loads)
        self.force = self.force_on_end()

    def force_on_end(self):
        """True forces on the end point; a servo regulates on a load cell that has a bias."""
        force = np.zeros((len(self.run.time), 2)) if self.run.force is None else self.run.force.copy()
        if self.run.control == "force" and not self.run.loaded_by:
            force -= self.truth.force_bias
        c, s = np.cos(self.truth.force_turn), np.sin(self.truth.force_turn)
        return force @ np.array([[c, s], [-s, c]])

    def torques(self, q, d):
        bench, truth = self.bench, self.truth
        along, places = shape(q, self.length)
        end = places[:, -1]
        last = bench.size - 1
        total = np.zeros_like(q)
        down = np.array([[0.0, -1.0]])
        if bench.plane == "vertical":
            for j, weight in enumerate(self.weights):
                if weight:
                    total += moments(places, (places[:, j] + places[:, j + 1]) / 2, weight * down.repeat(len(q), 0), j)
            if truth.payload:
                total += moments(places, end, truth.payload * down.repeat(len(q), 0), last)
        left = np.stack([-along[:, last, 1], along[:, last, 0]], axis=1)
        if np.any(self.force):
            total += moments(places, end + truth.eccentricity * left, self.force, last)
        if self.run.link_force is not None:
            link = bench.link - 1
            total += moments(places, places[:, link] + bench.at * along[:, link] * self.length[link], self.run.link_force, link)
        if self.run.value is not None:
            total += self.pull * (1 + truth.curling * q)
        if truth.table:
            height, stiffness = truth.table
            total += moments(places, end, -down * (stiffness * np.maximum(0.0, height - end[:, 1]))[:, None], last)
        if truth.coupling:
            total[:, 1:] += truth.coupling * d[:, :-1]
            total[:, :-1] += truth.coupling * d[:, 1:]
        return total
