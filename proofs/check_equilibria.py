#!/usr/bin/env python3
"""Checks Plumbline certificates of all equilibria of a loaded chain with integers and fractions alone. What is checked,
and what that proves, stands in equilibria-certificate-format.md.
Usage: check_equilibria.py FILE... (exit status 0 when everything in them holds)."""
import sys
from fractions import Fraction
from itertools import accumulate, combinations

from check_certificates import fields, number, opened, read, require
from exact_intervals import Nothing, common, inside, middle, minus, plus, width, zero_in
from loaded_chain import Chain

class Ball:
    """An equilibrium, and the box around it in which there is no other."""

    def __init__(self, chain, stated, digits):
        fields(stated, "q response energy negative_directions radius", "force_radius")
        N, n = chain.numbers, chain.n
        q, response = ([number(x) for x in stated[name]] for name in ("q", "response"))
        require(len(q) == n and len(response) == 2 and chain.held == ("force_radius" in stated), "q, response or radius")
        force_unit = chain.stiffness / chain.length
        unit = force_unit if chain.held else chain.length
        response = [x / unit for x in response]
        centre = list(accumulate(q)) + (response if chain.held else [])
        radii = [number(stated["radius"])] * n
        if chain.held: radii += [number(stated["force_radius"]) / force_unit] * 2
        require(min(radii) > 0, "radius")
        self.bounds = [(x - r, x + r) for x, r in zip(centre, radii)]
        m = [N.of(x) for x in centre]
        box = [(N.of(low)[1], N.of(high)[0]) for low, high in self.bounds]
        image = chain.krawczyk(m, box)
        require(all(b[0] < a[0] and a[1] < b[1] for a, b in zip(image, box)), "not one equilibrium in a ball")
        for _ in range(200):
            x = [common(a, b) for a, b in zip(image, box)]
            if 100 * sum(map(width, x)) > 99 * sum(map(width, box)): break
            image, box = chain.krawczyk(m, x), x
        theta, force = x[:n], x[n:] or chain.load
        self.q = [minus(t, before) for t, before in zip(theta, [(0, 0)] + theta)]
        self.other = force if chain.held else chain.end_point([N.circle(t) for t in theta])
        length, stiffness = chain.scale
        near = [(1, *pair) for pair in zip(q, self.q)]
        near += [((stiffness / length if chain.held else length) / unit, *pair) for pair in zip(response, self.other)]
        near.append((stiffness / chain.stiffness, number(stated["energy"]) / chain.stiffness, chain.energy(self.q)))
        for scale, value, found in near:
            low, high = N.of(value - Fraction(scale) / 10**digits), N.of(value + Fraction(scale) / 10**digits)
            require(low[1] <= found[0] and found[1] <= high[0], "a number that is not right to so many digits")
        for i, (angle, counted) in enumerate(zip(self.q, chain.range)):
            require(angle[0] <= counted[1] and counted[0] <= angle[1], f"joint {i + 1} outside of the window")
        require(chain.negative_directions(theta, force) == stated["negative_directions"], "negative directions")

    def differs(self, other, chain):
        """Whether they are certainly two equilibria, passive joints taken modulo full turns."""
        turn = 2 * chain.numbers.pi[0], 2 * chain.numbers.pi[1]
        for i, (a, b) in enumerate(zip(self.q + [*self.other], other.q + [*other.other])):
            off = minus(a, b)
            if i < chain.n and chain.passive[i]:
                turns = round(Fraction(middle(off), turn[0]))
                off = minus(off, chain.numbers.multiple(turn, turns))
            if not zero_in(off): return True
        return False

class Covering:
    """The tree of halvings, down to boxes ('.') in which is nothing, or what lies in a ball."""

    def __init__(self, chain, balls):
        N = chain.numbers
        self.chain, self.leaves = chain, 0
        self.balls = [[(N.of(low)[1], N.of(high)[0]) for low, high in ball.bounds] for ball in balls]

    def check(self, text):
        chain, todo = self.chain, [self.chain.everywhere()]
        for letter in text:
            require(todo, "boxes that are none")
            box = todo.pop()
            if letter == ".":
                self.leaf(box)
                continue
            j = ord(letter) - ord("a")
            require(0 <= j < chain.n, f"the letter {letter!r}")
            todo += self.halves(box, j)
        require(not todo, "boxes left out")

    @staticmethod
    def halves(box, j):
        """The upper one, then the lower one."""
        m = middle(box[j])
        return box[:j] + [(m, box[j][1])] + box[j + 1:], box[:j] + [(box[j][0], m)] + box[j + 1:]

    def leaf(self, box, patience=4):
        """Other roundings than those of whoever made the tree may leave a box open by a hair: then it is halved."""
        self.leaves += 1
        try: theta, force = self.chain.narrow(box)
        except Nothing: return
        if (force or not self.chain.held) and any(self.within(theta, force, ball) for ball in self.balls): return
        require(patience, f"box {self.leaves} is neither excluded nor within a ball")
        for half in self.halves(box, max(range(self.chain.n), key=lambda j: width(theta[j]))): self.leaf(half, patience - 1)

    def within(self, theta, force, ball):
        chain, shift, turned = self.chain, (0, 0), []
        turn, before, centre = (2 * chain.numbers.pi[0], 2 * chain.numbers.pi[1]), 0, 0
        for i, t in enumerate(theta):
            if chain.passive[i]:
                off = middle(t) - before - (middle(ball[i]) - centre)
                turns = (2 * off + turn[0]) // (2 * turn[0])
                shift = minus(shift, chain.numbers.multiple(turn, turns))
            before, centre = middle(t), middle(ball[i])
            turned.append(plus(t, shift))
        return all(map(inside, turned + (force if chain.held else []), ball))

def check_census(entry):
    """The number of equilibria and of boxes."""
    fields(entry, "case lengths stiffness rest rest_unit control load digits equilibria covering", "window turns")
    digits = entry["digits"]
    require(isinstance(digits, int) and 0 < digits <= 1000, "digits")
    fine, quick = Chain(entry, 4 * digits + 64), Chain(entry, 80)
    balls = [Ball(fine, stated, digits) for stated in entry["equilibria"]]
    require(all(a.differs(b, fine) for a, b in combinations(balls, 2)), "an equilibrium counted twice")
    covering = Covering(quick, balls)
    covering.check(entry["covering"])
    return len(balls), covering.leaves

def check(document):
    entries = opened(document, "plumbline-equilibria-certificates")
    counts = []
    for entry in entries:
        try: counts.append(check_census(entry))
        except (ValueError, TypeError, KeyError, IndexError, ZeroDivisionError, Nothing) as error:
            raise ValueError(f"case {entry['case']}: {error or 'an equilibrium where none can be'}") from None
    return counts

if __name__ == "__main__":
    for name in sys.argv[1:]:
        try:
            with open(name, encoding="utf-8") as file: counts = check(read(file.read()))
            print(f"{name}: {len(counts)} cases, {sum(n for n, _ in counts)} equilibria, "
                  f"{sum(boxes for _, boxes in counts)} boxes: every statement holds")
        except (OSError, ValueError, TypeError, KeyError) as error:
            sys.exit(f"{name}: {error}")
