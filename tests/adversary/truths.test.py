"""The adversary itself, against values that others published and theorems; and its two assemblies against each other."""
import math
import random
import unittest
from fractions import Fraction

import numpy

import bent
import census
import dynamics
import energy
import integers
import judge_bent
import modes
import polynomials as poly
from decimals import agrees
from draw import Draw, toml
from statement import NotAStructure, read
from straight import straight

CANTILEVER = "lengths = {one}\nstiffness = {one}\nend_point = 'free'\n"


def lowest(text, mode=1):
    line, high = straight(read(text)), Fraction(1)
    while sum(line.negatives(high)) < mode:
        high *= 2
    return float(modes.refined(line, mode, Fraction(0), high)[0])


def losses(text):
    return [(float(e.low), e.before, e.at, e.above) for e in dynamics.events(straight(read(text)))[0]]


def drawn(seed, count):
    """(number, structure in the plane under bending loads), of those that do not contradict themselves."""
    for number in range(count):
        try:
            yield number, read(toml(Draw(seed, number).census()))
        except NotAStructure:
            continue


class Published(unittest.TestCase):
    def test_cantilevers_of_hencky(self):  # 4 sin^2(pi / (2 (2 n + 1))): Wang, Zhang, Challamel, Pan, Hencky Bar-Chain/Net, 2020
        for n in (1, 2, 3, 5, 8):
            self.assertAlmostEqual(lowest(CANTILEVER.format(one=[1] * n)), 4 * math.sin(math.pi / (2 * (2 * n + 1))) ** 2, 12)

    def test_pinned_chain_of_hencky(self):  # 4 sin^2(m pi / (2 n)): Hencky 1920
        for mode in (1, 2, 3):
            self.assertAlmostEqual(lowest("lengths = [1, 1, 1, 1]\nstiffness = [0, 1, 1, 1]", mode), 4 * math.sin(mode * math.pi / 8) ** 2, 12)

    def test_column_of_ziegler(self):  # 7/2 - sqrt 2: Ziegler 1952
        text = CANTILEVER.format(one=[1, 1]) + "masses = [2, 1]\nloads = [{ follower = 1 }]"
        self.assertAlmostEqual(losses(text)[0][0], 3.5 - math.sqrt(2), 12)
        self.assertEqual(losses(text)[0][1:], ("stable", "flutter", "flutter"))


class Turns(unittest.TestCase):
    """Half a turn either way of a passive link is one shape, unless something counts the turns of the link."""

    def apart(self, end):
        structure = read(f"lengths = [1, 1]\nstiffness = [0, 1]\nend_point = {end}\n")
        return judge_bent.turned_together(structure, [math.pi, 0.1], [-math.pi, 0.1])

    def test_whole_turns(self):
        self.assertLess(self.apart("{ across = 'held' }"), 1e-12)
        self.assertAlmostEqual(self.apart("{ across = 'held', turn = 0.5 }"), 2 * math.pi)


class Touching(unittest.TestCase):
    def test_frequency_that_touches_zero(self):  # det(K - F A) = (1 - 6 F)^2
        text = CANTILEVER.format(one=[1, 1]) + "masses = [2, 1]\nloads = [{ follower = 5 }, { force = [-4, 0] }]"
        self.assertEqual(losses(text)[0], (1 / 6, "stable", "divergence", "stable"))
        below, above = (text.replace("5 }", p + " }") for p in ("4.999999999", "5.000000001"))
        self.assertEqual([event[3] for event in losses(below)[:2]], ["divergence", "stable"])
        self.assertAlmostEqual(losses(above)[0][0], 0.2287246546, 9)


class Exact(unittest.TestCase):
    def test_signs_and_ranks(self):
        draw = random.Random(1)
        for _ in range(100):
            n = draw.randint(1, 7)
            matrix = [[draw.randint(-2, 2) for _ in range(n)] for _ in range(n)]
            symmetric = integers.combination(1, matrix, 1, integers.transposed(matrix))
            values = numpy.linalg.eigvalsh(numpy.array(symmetric, float))
            self.assertEqual(integers.inertia(symmetric), tuple(int(numpy.sum(v)) for v in (values < -1e-9, abs(values) <= 1e-9, values > 1e-9)))
            self.assertAlmostEqual(integers.determinant(matrix), numpy.linalg.det(numpy.array(matrix, float)), 6)
            self.assertEqual(len(integers.null_space(matrix[:1], n)[0]), n - any(matrix[0]))

    def test_roots(self):
        draw = random.Random(2)
        for _ in range(40):
            roots = sorted({Fraction(draw.randint(1, 9), draw.randint(1, 9)) for _ in range(draw.randint(1, 7))})
            p = [2, 1, 1]
            for root in roots:
                p = poly.multiplied(p, [-root.numerator, root.denominator])
            self.assertEqual(len(poly.square_free(poly.multiplied(p, p))), len(p))
            found = poly.positive_roots(p)
            self.assertTrue(all(low < r < high or low == r == high for (low, high), r in zip(found, roots, strict=True)))
            self.assertEqual(poly.roots_between(p, 0, None), len(roots))

    def test_rounding(self):
        self.assertTrue(agrees("0.667", Fraction(2, 3)) and agrees("2e+1", 24) and not agrees("0.666", Fraction(2, 3)))


class Assemblies(unittest.TestCase):
    def test_plane_and_turned_links(self):
        for number, statement in drawn("assemblies", 25):
            shape = numpy.random.default_rng(number).normal(0, 1, energy.unknowns(statement))
            gradient, hessian, rows, off, _ = (part[0] if len(part) else part for part in census.Plane(statement, 0.7).system(shape[None]))
            about = energy.expansion(statement, list(shape))
            for mine, term, what in ((gradient, about.gradient, 1), (hessian, about.hessian, 2)):
                other = numpy.array(term(about.springs)) - 0.7 * numpy.array(term(about.work)) - numpy.array(term(about.fixed_work))
                numpy.testing.assert_allclose(mine, other.astype(float), rtol=1e-9, atol=1e-9, err_msg=f"{number}: order {what}")

    def test_moved_about_as_a_whole(self):
        """A chain in the plane turned about x is one in space with the same critical factors."""
        plane = "lengths = [1, 2]\nstiffness = [1, 3]\nend_point = 'free'\nfoundation = 0.5"
        space = "lengths = [1, 2]\njoints = [{ axes = [[0, 3, 4]], stiffness = [1] }, { axes = [[0, 6, 8]], stiffness = [3] }]\n"
        space += "end_point = 'free'\nfoundation = 0.5"
        for mode in (1, 2):
            self.assertAlmostEqual(lowest(plane, mode), lowest(space, mode), 12)

    def test_equilibria_are_those_of_turned_links(self):
        for number, statement in drawn("equilibria", 4):
            for shape in census.equilibria(statement, 1, 20, number):
                self.assertLess(bent.found(statement, shape, 1.0).residual, 1e-7)


class Singular(unittest.TestCase):
    CHAIN = "lengths = [2, 1]\njoints = [{{ axes = [{first}], stiffness = [1] }}, {{ axes = [[0, 1, 1], {second}], stiffness = [1, 1] }}]\n"

    def test_rows_that_are_one_in_the_straight_line_alone_are_singular(self):  # all turns lift the end point along (0, -1, 1)
        self.assertTrue(bent.why_singular(read(self.CHAIN.format(first="[1, 1, 1]", second="[1, 1, 1]"))))

    def test_rows_that_are_one_in_every_shape_are_not(self):  # one plane holds the chain
        self.assertFalse(bent.why_singular(read(self.CHAIN.format(first="[0, 1, 1]", second="[0, 2, 2]"))))

    def test_independent_rows_are_not(self):
        self.assertFalse(bent.why_singular(read(self.CHAIN.format(first="[0, 0, 1]", second="[0, 1, 0]"))))


class Statements(unittest.TestCase):
    def test_contradictions_are_refused(self):
        chain = "lengths = [1, 1]\nstiffness = [1, 1]\n"
        for wrong in ("base = 'clamped'", "end_point = { along = 'held' }", "base = { along = 'free' }", "end_point = 'loose'",
                      "supports = [{ at = 2, across = 1 }, { at = 2, across = 'held' }]", "loads = [{ force = [-1, 0], fixed = 'true' }]",
                      "loads = [{ force = [-1, 0], at = 1 }]", "loads = []", "masses = [1]", "foundation = -1", "pins = 2", "base = 'clamped'",
                      "base = 'pinned'", "base = { turn = 1 }"):
            with self.assertRaises(NotAStructure, msg=wrong):
                read(chain + wrong)


if __name__ == "__main__":
    unittest.main()
