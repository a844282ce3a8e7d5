"""Numbers of every kind reach the engine as the exact decimals that they are."""
import decimal
import fractions

import mpmath
import numpy as np
import plumbline
import pytest
from plumbline.numbers import decimal_text, doubles


def test_a_float_stands_for_the_decimal_that_is_printed_for_it():
    assert decimal_text(0.1) == decimal_text(np.float64(0.1)) == "0.1"
    assert decimal_text(1e-300) == "1e-300"


@pytest.mark.parametrize("value", [3, np.int32(-7), decimal.Decimal("1.25e-7"), fractions.Fraction(-7, 40),
                                   fractions.Fraction(1, 2 ** 80), mpmath.mpf("0.1"), mpmath.mpf(2) ** 300, mpmath.mpf(0)])
def test_exact_numbers_stay_exact(value):
    if hasattr(value, "man_exp"):
        mantissa, exponent = (int(part) for part in value.man_exp)
        exact = mantissa * fractions.Fraction(2) ** exponent
    else:
        exact = fractions.Fraction(int(value) if isinstance(value, np.integer) else value)
    assert fractions.Fraction(decimal_text(value)) == exact


def test_a_fraction_without_a_finite_decimal_is_refused():
    with pytest.raises(plumbline.Error, match=r"^lengths, entry 2: found 1/3, expected a decimal number$"):
        plumbline.critical_forces([1, fractions.Fraction(1, 3)], [0, 1], digits=20)


@pytest.mark.parametrize("values, message", [
    (3, "lengths: found 3, expected a list of numbers"),
    ([1, "x"], "lengths, entry 2: found 'x', expected a number"),
    ([[1, 2], [3]], "lengths, entry 1: found [1, 2], expected a number"),
    ([[1, 2], [3, 4]], "lengths: found an array of 2 dimensions, expected 1"),
])
def test_what_is_no_list_of_numbers_is_named(values, message):
    with pytest.raises(plumbline.Error) as raised:
        doubles(values, "lengths")
    assert str(raised.value) == message
