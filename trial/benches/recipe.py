"""What a trial draws: shares of families, strengths, the noise."""
from dataclasses import dataclass

NONE, ONE, TWO, OUT = "no effect", "one effect", "two effects", "outside"


@dataclass(frozen=True)
class Recipe:
    shares: dict  # of families
    weakest: float  # strengths, in standard deviations
    weakest_outside: float
    strongest: float
    noise: dict  # shares of its kinds, by name (noise.py)
    misdeclared: tuple  # the least and the largest factor by which the declared noise is wrong
    outliers: float  # their share
    selected: bool  # whether only causes are drawn that the readings can tell from others


# Causes that a laboratory would ask about, with labels of which nobody can doubt the right answer.
PLAIN = Recipe({NONE: 0.15, ONE: 0.5, TWO: 0.12, OUT: 0.23}, 2.2, 5.0, 50.0,
               {"declared": 0.70, "misdeclared": 0.18, "outliers": 0.12}, (1.5, 1.5), 0.02, True)
# For calibration: strengths from far below the noise, noise of every kind, and nothing left out that would be hard to answer.
FAINT = Recipe({NONE: 0.23, ONE: 0.5, TWO: 0.145, OUT: 0.125}, 0.2, 0.2, 30.0,
               {"declared": 0.46, "misdeclared": 0.16, "outliers": 0.14, "autocorrelated": 0.13, "proportional": 0.11},
               (1.0, 3.0), 0.03, False)
