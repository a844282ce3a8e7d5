"""The torque law of one joint: a history of its torque from a history of its coordinate, and the reverse.

Coordinates are in rad and torques in N m for a joint that turns, in m and N for one that slides. Every history begins relaxed.
"""
import numpy as np

STEPS = 60  # of Newton's method, at most
CLOSE = 1e-12  # of the largest deflection


def beyond(d, half_width):
    """The part of a deflection outside a dead zone."""
    return d - (abs(d + half_width) - abs(d - half_width)) / 2


class JointLaw:
    def __init__(self, stiffness, truth):
        self.nominal, self.truth = stiffness, truth
        self.stiffness = stiffness * (1 + truth.softer)

    @property
    def has_memory(self):
        return bool(self.truth.sliders or self.truth.arms or self.truth.plastic)

    def spring(self, d, q, share):
        """The part without memory, at deflection d, coordinate q and a share of the stiffness."""
        t = self.truth
        x = beyond(d, t.play) if t.play else d
        torque = self.stiffness * share * (x * (1 + t.hardening * x * x) + t.uneven * abs(x) - (t.knee[1] * beyond(x, t.knee[0]) if t.knee else 0.0))
        if t.stop:
            torque = torque + t.stop[1] * beyond(d, t.stop[0])
        for law in t.beside:
            torque = torque + law(q)
        return torque

    @property
    def is_linear(self):
        t = self.truth
        return not (t.hardening or t.play or t.uneven or t.knee or t.stop or t.beside)

    def shares(self, time):
        return np.ones(len(time)) if self.truth.share is None else self.truth.share(time)

    def deflection(self, torque, command, share):
        """By reading: the deflections at which the spring carries the torques, by Newton's method within a bracket."""
        stiffness = self.stiffness * share
        if self.is_linear:
            return torque / stiffness
        d = torque / stiffness
        # the tangents of springs that soften are not below a tenth of the stiffness, nor are those of loads beside them far above it
        reach = 20 * np.max(np.abs(d) + np.abs(self.spring(d * 0, command, share)) / stiffness) + 2 * self.truth.play + 1e-12
        low, high = d * 0 - reach, d * 0 + reach
        h = 1e-7 * reach
        for _ in range(STEPS):
            f = self.spring(d, command + d, share) - torque
            slope = (self.spring(d + h, command + d + h, share) - torque - f) / h
            low, high = np.where(f < 0, d, low), np.where(f < 0, high, d)
            with np.errstate(divide="ignore", invalid="ignore"):
                step = d - f / slope
            step = np.where(f == 0, d, np.where((step > low) & (step < high), step, (low + high) / 2))  # in play without torque it stays
            if np.max(np.abs(step - d)) < CLOSE * reach:
                return step
            d = step
        if np.max(np.abs(f)) > 1e-6 * np.max(np.abs(self.nominal * d)) + 1e-15:
            raise ArithmeticError("no equilibrium of a joint")
        return d

    def deflection_of_one(self, torque, command, share, added):
        """The same of one reading, in plain numbers, which are several times as fast."""
        stiffness = self.stiffness * share + added
        d = torque / stiffness
        if self.is_linear:
            return d
        reach = 20 * (abs(d) + abs(self.spring(0.0, command, share)) / stiffness) + 2 * self.truth.play + 1e-12
        low, high, h = -reach, reach, 1e-7 * reach
        for _ in range(STEPS):
            f = self.spring(d, command + d, share) + added * d - torque
            if f == 0:
                return d
            slope = (self.spring(d + h, command + d + h, share) + added * (d + h) - torque - f) / h
            low, high = (d, high) if f < 0 else (low, d)
            step = d - f / slope if slope != 0 else low
            step = step if low < step < high else (low + high) / 2
            if abs(step - d) < CLOSE * reach:
                return step
            d = step
        if abs(f) > 1e-6 * abs(self.nominal * d) + 1e-15:
            raise ArithmeticError("no equilibrium of a joint")
        return d

    def deflections(self, torques, commands, time):
        """By reading: the deflections under a history of torques."""
        shares = self.shares(time)
        if self.truth.plastic:
            return self.deflection(torques, commands, shares) + self.plastic_set(torques)
        if not self.has_memory:
            return self.deflection(torques, commands, shares)
        sliders, arms = self.truth.sliders, self.truth.arms
        held, carried = [0.0] * len(sliders), [0.0] * len(arms)
        torques, commands, shares, time = (values.tolist() for values in (torques, commands, shares, np.asarray(time)))
        d = self.deflection_of_one(torques[0], commands[0], shares[0], 0.0)
        result = [d]
        for i in range(1, len(torques)):
            before, turn = d, commands[i] - commands[i - 1]
            decay, rates = self.arm_rates(time[i] - time[i - 1])
            state = [0] * len(sliders)
            for _ in range(12):
                rest, added = torques[i], 0.0
                for s, slider in enumerate(sliders):
                    if state[s] == 0:
                        move = turn if slider.on_turn else 0.0
                        rest -= held[s] + slider.stiffness * (move - before)
                        added += slider.stiffness
                    else:
                        rest -= self.limit(slider, d, commands[i])[0 if state[s] > 0 else 1] * state[s]
                for a in range(len(arms)):
                    rest -= carried[a] * decay[a] - rates[a] * before
                    added += rates[a]
                last, d = d, self.deflection_of_one(rest, commands[i], shares[i], added)
                new = [self.new_torque(s, slider, held, d, before, turn, commands[i]) for s, slider in enumerate(sliders)]
                now = [one[1] for one in new]
                if now == state and abs(d - last) < 1e-10 + 1e-6 * abs(d):
                    break
                state = now
            held = [one[0] for one in new]
            carried = [carried[a] * decay[a] + rates[a] * (d - before) for a in range(len(arms))]
            result.append(d)
        return np.array(result)

    def torques(self, coordinates, commands, time):
        """By reading: the torques at a history of coordinates."""
        d, shares = coordinates - commands, self.shares(time)
        if self.truth.plastic:
            return self.plastic_torques(d)
        total = self.spring(d, coordinates, shares)
        if not self.has_memory:
            return total
        sliders, arms = self.truth.sliders, self.truth.arms
        held, carried = [0.0] * len(sliders), [0.0] * len(arms)
        for i in range(1, len(d)):
            decay, rates = self.arm_rates(time[i] - time[i - 1])
            turn = commands[i] - commands[i - 1]
            held = [self.new_torque(s, slider, held, d[i], d[i - 1], turn, commands[i])[0] for s, slider in enumerate(sliders)]
            carried = [carried[a] * decay[a] + rates[a] * (d[i] - d[i - 1]) for a in range(len(arms))]
            total[i] += sum(held) + sum(carried)
        return total

    def arm_rates(self, interval):
        """Of each Maxwell arm: its decay over an interval, and its torque by deflection at constant speed, N m/rad."""
        decay = [np.exp(-interval / tau) for _, tau in self.truth.arms]
        return decay, [k * tau / interval * (1 - e) for (k, tau), e in zip(self.truth.arms, decay)]

    def limit(self, slider, d, command):
        return slider.limit(command + d, d)

    def new_torque(self, s, slider, held, d, before, turn, command):
        """A slider's torque, and whether it slips up (1), down (-1) or not."""
        trial = held[s] + slider.stiffness * (d - before + (turn if slider.on_turn else 0.0))
        up, down = self.limit(slider, d, command)
        return (up, 1) if trial > up else (-down, -1) if trial < -down else (trial, 0)

    def plastic_set(self, torques):
        """The rest angle's yielding: its slope times the excess over the largest torque so far, over the stiffness."""
        most, slope = self.truth.plastic
        shift, result = 0.0, []
        for torque in torques:
            if abs(torque) > most:
                shift += np.sign(torque) * slope * (abs(torque) - most) / self.stiffness
                most = abs(torque)
            result.append(shift)
        return np.array(result)

    def plastic_torques(self, d):
        """The same of a linear spring at a history of deflections."""
        most, slope = self.truth.plastic
        shift, result = 0.0, []
        for one in d:
            torque = self.stiffness * (one - shift)
            if abs(torque) > most:
                torque = np.sign(torque) * (abs(torque) + slope * most) / (1 + slope)
                shift += np.sign(torque) * slope * (abs(torque) - most) / self.stiffness
                most = abs(torque)
            result.append(torque)
        return np.array(result)
