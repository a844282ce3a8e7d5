#!/usr/bin/env python3
"""Checks Plumbline certificates of all equilibria of a loaded chain with integers and fractions alone. What is checked,
and what that proves, stands in equilibria-certificate-format.md.
Usage: check_equilibria.py FILE... (exit status 0 when everything in them holds)."""
from fractions import Fraction
from itertools import accumulate, combinations

from check_certificates import each, fields, main, number, require
from exact_intervals import Nothing, common, inside, inverse, middle, minus, opposite, plus, width, zero_in
from loaded_chain import Chain

class Domain(Chain):
    """A chain under one load, and all shapes that are counted."""

    def __init__(self, entry, bits):
        super().__init__(entry, bits)
        require(self.n <= 16, "more links than letters")
        require(entry["control"] in ("end_point", "deflection", "force") and len(entry["load"]) == 2, "control or load")
        self.load = self.loaded([number(x) for x in entry["load"]], entry["control"])
        self.range = [self.around(i, entry) for i in range(self.n)]

    def loaded(self, load, control):
        if control == "force": return [self.numbers.of(x * self.length / self.stiffness) for x in load]
        place = [self.numbers.of(x / self.length) for x in load]
        if control == "end_point": return place
        x, y = self.unloaded()
        return [minus(x, place[0]), plus(y, place[1])]

    def around(self, i, entry):
        """The joint angles counted; of a passive joint one turn, of which there are no others."""
        N, pi = self.numbers, self.numbers.pi
        if not self.held:
            require("window" not in entry and "turns" not in entry, "a window under a force")
        else:
            turns, nearest = entry["turns"], entry["window"][i]
            require(isinstance(turns, int) and 0 <= turns <= 100 and isinstance(nearest, int), "turns or window")
            require(len(entry["window"]) == self.n and abs(nearest) < 10**6, "window")
            if i == 0 or self.passive[i]: require(nearest == 0, "window")
            centre = N.multiple(pi, nearest)
            off, tie = minus(self.rest[i], centre), pi[1] // 2 + (N.one >> 30)
            if i and not self.passive[i]: require(-tie <= off[0] and off[1] <= tie, "window")
        if self.passive[i]: return plus(N.of(Fraction("0.1234567")), (-pi[1], pi[1]))
        if self.held:
            half = pi[1] * (2 * turns + 1)
            return plus(self.rest[i] if i == 0 else centre, (-half, half))
        force, beyond = sum(max(map(abs, f)) for f in self.load), (0, sum(L[1] for L in self.L[i:]))
        turn = N.over(N.times((0, force), beyond), self.k[i])[1]
        return plus(self.rest[i], (-turn, turn))

    def everywhere(self):
        return list(accumulate(self.range, plus))

    def torques(self, theta):
        N, before, T = self.numbers, (0, 0), []
        for i, t in enumerate(theta):
            q, before = common(minus(t, before), self.range[i]), t
            T.append((0, 0) if self.passive[i] else N.times(self.k[i], minus(q, self.rest[i])))
        return T + [(0, 0)]

    def narrow(self, theta):
        """What is left of a box of link directions, with the forces there. Raises Nothing where nothing is."""
        theta, force = list(theta), None if self.held else self.load
        for _ in range(8):
            size = sum(map(width, theta))
            self.keep_in_range(theta)
            force = self.balance(theta, force)
            if force and max(map(width, theta)) < 2 * self.numbers.one: theta, force = self.newton(theta, force)
            if 10 * sum(map(width, theta)) > 8 * size: break
        return theta, force

    def keep_in_range(self, theta):
        theta[0] = common(theta[0], self.range[0])
        for i in range(1, self.n): theta[i] = common(theta[i], plus(theta[i - 1], self.range[i]))
        for i in range(self.n - 1, 0, -1): theta[i - 1] = common(theta[i - 1], minus(theta[i], self.range[i]))

    def balance(self, theta, force):
        """Narrows theta and the force by the moments of link after link."""
        N, n, T = self.numbers, self.n, self.torques(theta)
        circles = [N.circle(t) for t in theta]
        if self.held:
            for given, found in zip(self.load, self.end_point(circles)): common(given, found)
            x, y = self.load
            rows = [(opposite(y), x, T[0])]  # a Fx + b Fy = m: about the base, and of each link
            for i, (c, s) in enumerate(circles):
                rows.append((N.times(self.L[i], s), opposite(N.times(self.L[i], c)), minus(T[i + 1], T[i])))
            force = self.bounded(rows, force)
            if not force: return None
        gain = []
        for L, (c, s) in zip(self.L, circles): gain.append(N.times(L, minus(N.times(force[1], c), N.times(force[0], s))))
        if self.held: T[0] = common(T[0], minus(N.times(self.load[0], force[1]), N.times(self.load[1], force[0])))
        for i in range(n):
            self.turn(theta, T, i)
            T[i + 1] = common(T[i + 1], minus(T[i], gain[i]))
        for i in range(n - 1, -1, -1):
            T[i] = common(T[i], plus(T[i + 1], gain[i]))
            self.turn(theta, T, i)
        return force

    def bounded(self, rows, force):
        """Bounds of a force that all rows allow; nothing where no two of them bound it."""
        N = self.numbers
        if not force:
            for (a, b, m), (c, d, p) in combinations(rows, 2):
                det = minus(N.times(a, d), N.times(b, c))
                if zero_in(det): continue
                x = N.over(minus(N.times(m, d), N.times(b, p)), det)
                y = N.over(minus(N.times(a, p), N.times(m, c)), det)
                force = [common(force[0], x), common(force[1], y)] if force else [x, y]
            if not force: return None
        x, y = force
        for a, b, m in rows:
            if not zero_in(a): x = common(x, N.over(minus(m, N.times(b, y)), a))
            if not zero_in(b): y = common(y, N.over(minus(m, N.times(a, x)), b))
        return [x, y]

    def turn(self, theta, T, i):
        """What the moment says of the directions on both sides of joint i."""
        if self.passive[i]: return
        q = plus(self.rest[i], self.numbers.over(T[i], self.k[i]))
        if i == 0: theta[0] = common(theta[0], q)
        else:
            theta[i] = common(theta[i], plus(theta[i - 1], q))
            theta[i - 1] = common(theta[i - 1], minus(theta[i], q))

    def newton(self, theta, force):
        """One step of Newton's method in intervals: f(x) = f(m) + A (x - m) with A somewhere in A(box)."""
        N, n = self.numbers, self.n
        x = theta + force if self.held else theta
        m = [(middle(a),) * 2 for a in x]
        A = self.derivative(theta, force)
        Y = inverse([[middle(a) for a in row] for row in A], N)
        if not Y: return theta, force
        f, columns = self.residual(m[:n], m[n:] or force, self.load), [*zip(*A)]
        for i in range(self.size):
            total, G = N.weighted(Y[i], f), [N.weighted(Y[i], column) for column in columns]
            for j in range(self.size):
                if j != i: total = plus(total, N.times(G[j], minus(x[j], m[j])))
            if not zero_in(G[i]): x[i] = common(x[i], minus(m[i], N.over(total, G[i])))
        return x[:n], x[n:] or force

    def krawczyk(self, m, x):
        """Krawczyk's operator over the box x around m: maps x into its inside where x holds exactly one equilibrium."""
        N, n, force = self.numbers, self.n, self.load
        Y = inverse([[middle(a) for a in row] for row in self.derivative(m[:n], m[n:] or force)], N)
        require(Y, "a ball around a singular point")
        f, columns = self.residual(m[:n], m[n:] or force, self.load), [*zip(*self.derivative(x[:n], x[n:] or force))]
        image = []
        for i in range(self.size):
            total = minus(m[i], N.weighted(Y[i], f))
            for j in range(self.size):
                defect = minus((N.one * (i == j),) * 2, N.weighted(Y[i], columns[j]))
                total = plus(total, N.times(defect, minus(x[j], m[j])))
            image.append(total)
        return image

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
            counts = chain.passive[i] or (angle[0] <= counted[1] and counted[0] <= angle[1])
            require(counts, f"joint {i + 1} outside of the window")
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

    def leaf(self, box, patience=6):
        """Other roundings than those of whoever made the tree may leave a box open by a hair: then it is halved."""
        self.leaves += 1
        try: theta, force = self.chain.narrow(box)
        except Nothing: return
        if (force or not self.chain.held) and any(self.within(theta, force, ball) for ball in self.balls): return
        require(patience, f"box {self.leaves} is neither excluded nor within a ball")
        for half in self.halves(theta, max(range(self.chain.n), key=lambda j: width(theta[j]))): self.leaf(half, patience - 1)

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
    fine, quick = Domain(entry, 4 * digits + 64), Domain(entry, 80)
    balls = [Ball(fine, stated, digits) for stated in entry["equilibria"]]
    require(all(a.differs(b, fine) for a, b in combinations(balls, 2)), "an equilibrium counted twice")
    covering = Covering(quick, balls)
    covering.check(entry["covering"])
    return len(balls), covering.leaves

def check(document):
    return each(document, "plumbline-equilibria-certificates", "case", check_census)

if __name__ == "__main__":
    main(check, lambda found: f"{len(found)} cases, {sum(n for n, _ in found)} equilibria, {sum(boxes for _, boxes in found)} boxes")
