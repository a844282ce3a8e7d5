"""All equilibria of a chain in the plane that Newton's method finds from many shapes; all starts go on together, in doubles."""
import itertools
from fractions import Fraction

import numpy

import energy


class Plane:
    """E = q' K q / 2 + sum s_i (y_i - y_i0)^2 / 2 + c (phi - phi0)^2 / 2 + k d^2 / 2 - sum f_i . r_i - M phi, q the joint angles,
    phi that of the last link, y = v + Y sin(link angles), x = d + X cos(link angles)."""

    def __init__(self, statement, factor):
        self.links, lengths = statement.links, numpy.array([float(l) for l in statement.lengths])
        self.moves, self.shifts = energy.shifts(statement)
        self.rest = numpy.array([float(r) for r in statement.rest])
        self.springs = numpy.array([float(k) for _, _, k in energy.turns(statement)])
        below = numpy.tri(self.links + 1, self.links, -1)
        self.y = below * lengths
        self.x = self.y if statement.base.along != "free" else (below - 1) * lengths
        self.sum = numpy.tri(self.links)  # link angles of joint angles
        forces = numpy.zeros((self.links + 1, 2))
        self.moment = 0.0
        for load in statement.loads:
            by = 1.0 if load.fixed else factor
            if load.kind == "force":
                forces[load.node] += [by * float(c) for c in load.value[:2]]
            else:
                self.moment += by * float(load.value)
        self.fx, self.fy = forces.T
        self.across = numpy.zeros(self.links + 1)
        for node, stiffness in energy.across_springs(statement):
            self.across[node] += float(stiffness)
        self.turn = float(statement.end_point.turn) if energy.is_spring(statement.end_point.turn) else 0.0
        self.along = sum(float(e.along) for e in (statement.base, statement.end_point) if energy.is_spring(e.along))
        held = [n for n, how in statement.supports.items() if how == "held"] + [self.links] * (statement.end_point.across == "held")
        self.held = sorted(set(held))
        linear = [[1.0] + [0.0] * (self.links - 1)] if statement.base.turn == "held" else []
        if statement.end_point.turn == "held":
            linear.append([1.0] * self.links)
        self.linear = numpy.array(linear).reshape(-1, self.links)
        self.rest_y = self.y @ numpy.sin(self.sum @ self.rest)
        self.size = self.links + self.moves + self.shifts

    def system(self, z):
        """Gradient of the energy and its second derivatives, constraints and theirs, for every row of z."""
        count, n = len(z), self.links
        angles = z[:, :n] @ self.sum.T
        sine, cosine = numpy.sin(angles), numpy.cos(angles)
        v = z[:, n] if self.moves else numpy.zeros(count)
        height = sine @ self.y.T + v[:, None]
        pull = self.across * (height - self.rest_y) - self.fy  # dE / dy of each node
        by_angle = (pull @ self.y) * cosine + (self.fx @ self.x) * sine
        last = angles[:, -1] - self.rest.sum()
        gradient = numpy.zeros((count, self.size))
        gradient[:, :n] = by_angle @ self.sum + self.springs * (z[:, :n] - self.rest) + (self.turn * last - self.moment)[:, None]
        slope = self.y[None] * cosine[:, None, :]  # dy of each node by link angles
        second = numpy.einsum("cia,i,cib->cab", slope, self.across, slope)
        bend = -(pull @ self.y) * sine + (self.fx @ self.x) * cosine
        second[:, range(n), range(n)] += bend
        hessian = numpy.zeros((count, self.size, self.size))
        hessian[:, :n, :n] = self.sum.T @ second @ self.sum + numpy.diag(self.springs) + self.turn
        if self.moves:
            gradient[:, n] = pull.sum(1)
            hessian[:, n, n] = self.across.sum()
            mixed = numpy.einsum("i,cia->ca", self.across, slope) @ self.sum
            hessian[:, n, :n] = hessian[:, :n, n] = mixed
        if self.shifts:
            gradient[:, -1] = self.along * z[:, -1] - self.fx.sum()
            hessian[:, -1, -1] = self.along
        rows = numpy.zeros((count, len(self.held) + len(self.linear), self.size))
        off = numpy.zeros((count, rows.shape[1]))
        curved = numpy.zeros((len(self.held), count, n, n))
        for k, node in enumerate(self.held):
            rows[:, k, :n] = slope[:, node] @ self.sum
            if self.moves:
                rows[:, k, n] = 1.0
            off[:, k] = height[:, node] - self.rest_y[node]
            bends = numpy.zeros((count, n, n))
            bends[:, range(n), range(n)] = -self.y[node] * sine
            curved[k] = self.sum.T @ bends @ self.sum
        for k, row in enumerate(self.linear, len(self.held)):
            rows[:, k, :n] = row
            off[:, k] = (z[:, :n] - self.rest) @ row
        return gradient, hessian, rows, off, curved


def starts(plane, count, random):
    n = plane.links
    z = random.uniform(-numpy.pi, numpy.pi, (count, plane.size))
    folded = numpy.array(list(itertools.product([0.0, numpy.pi], repeat=n)))
    exact = numpy.zeros((len(folded), plane.size))
    exact[:, :n] = folded + random.normal(0, 1e-3, folded.shape)
    z = numpy.vstack([z, exact])
    z[:, n:] = random.normal(0, 1, (len(z), plane.size - n)) * plane.y.sum()
    return z


def equilibria(statement, factor, count, seed, steps=60, solved=None):
    """Shapes (rows of unknowns), distinct but for whole turns of nothing: as Newton's method leaves them."""
    solved = solved or regularly_solved
    plane, random = Plane(statement, float(Fraction(factor))), numpy.random.default_rng(seed)
    z = starts(plane, count, random)
    total = None
    with numpy.errstate(all="ignore"):
        for _ in range(steps):
            gradient, hessian, rows, off, curved = plane.system(z)
            m = rows.shape[1]
            if total is None:
                total = numpy.zeros((len(z), m))
            force = gradient - numpy.einsum("cm,cmi->ci", total, rows)
            hessian[:, :plane.links, :plane.links] -= numpy.einsum("kc,kcab->cab", total[:, :len(plane.held)].T, curved)
            matrix = numpy.zeros((len(z), plane.size + m, plane.size + m))
            matrix[:, :plane.size, :plane.size] = hessian
            matrix[:, :plane.size, plane.size:] = -rows.transpose(0, 2, 1)
            matrix[:, plane.size:, :plane.size] = rows
            right = -numpy.concatenate([force, off], axis=1)
            step = solved(matrix, right)
            longest = numpy.max(abs(step[:, :plane.links]), axis=1, initial=0)
            step *= numpy.minimum(1, 1.0 / numpy.maximum(longest, 1e-300))[:, None]
            good = numpy.isfinite(step).all(1)
            z, total, step = z[good] + step[good][:, :plane.size], total[good] + step[good][:, plane.size:], step[good]
            if not len(z):
                break
        gradient, _, rows, off, _ = plane.system(z)
        force = gradient - numpy.einsum("cm,cmi->ci", total, rows)
        scale = numpy.max(abs(gradient), axis=1, initial=0) + numpy.max(abs(plane.springs)) + 1e-300
        done = (numpy.max(abs(force), axis=1, initial=0) < 1e-10 * scale) & (numpy.max(abs(off), axis=1, initial=0) < 1e-10 * plane.y.max())
    return distinct(z[done])


def regularly_solved(matrix, right):
    try:
        return numpy.linalg.solve(matrix, right[..., None])[..., 0]
    except numpy.linalg.LinAlgError:  # constraints that repeat each other
        return numpy.einsum("cij,cj->ci", numpy.linalg.pinv(matrix, rcond=1e-12), right)


def shortest(matrix, right):
    """The shortest step, that leads to a continuum of equilibria too."""
    return numpy.einsum("cij,cj->ci", numpy.linalg.pinv(matrix, rcond=1e-7), right)


def distinct(shapes, close=1e-6):
    result = []
    for shape in shapes:
        if all(numpy.max(abs(shape - other)) > close for other in result):
            result.append(shape)
    return result
