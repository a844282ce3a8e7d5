"""Printed numbers: the fractions that round to them."""
from decimal import Decimal
from fractions import Fraction


def interval(text):
    """Where a number lies of which `text` is a correct rounding."""
    half = Fraction(10) ** Decimal(text).as_tuple().exponent / 2
    return Fraction(text) - half, Fraction(text) + half


def agrees(text, value, slack=0):
    """Whether the text is `value`, rounded, give or take a share of it."""
    low, high = interval(text)
    return low - slack * abs(value) <= value <= high + slack * abs(value)
