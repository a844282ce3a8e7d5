"""Numbers as people have them: floats, decimals in text, `decimal.Decimal`, `fractions.Fraction`, mpmath's."""
from __future__ import annotations

import decimal
import fractions
from collections.abc import Callable, Iterable, Sequence
from typing import Any, TypeVar, Union

import numpy as np
import numpy.typing as npt

from plumbline._engine import Error

#: What an entry of a list of lengths, stiffnesses or angles may be.
Number = Union[float, int, str, decimal.Decimal, fractions.Fraction, Any]
Numbers = Union[Sequence[Number], npt.NDArray[Any]]
Floats = npt.NDArray[np.float64]
T = TypeVar("T")


def entries(values: Numbers, name: str) -> list[Any]:
    """A list of numbers, or one line that says what it is instead."""
    if isinstance(values, (str, bytes)) or not isinstance(values, Iterable):
        raise Error(f"{name}: found {values!r}, expected a list of numbers")
    if isinstance(values, np.ndarray) and values.ndim != 1:
        raise Error(f"{name}: found an array of {values.ndim} dimensions, expected a list of numbers")
    return list(values)


def doubles(values: Numbers, name: str, dimensions: int = 1) -> Floats:
    """The values as doubles, those of text and the like the nearest ones."""
    try:
        array = np.ascontiguousarray(values, dtype=np.float64)
    except (TypeError, ValueError, OverflowError):
        for i, value in enumerate(entries(values, name)):
            try:
                float(value)
            except (TypeError, ValueError, OverflowError):
                raise Error(f"{name}, entry {i + 1}: found {value!r}, expected a number") from None
        raise Error(f"{name}: found rows of unequal length, expected an array of numbers") from None
    given = np.asarray(values).ndim
    if given == 0:
        raise Error(f"{name}: found {values!r}, expected a list of numbers")
    if given != dimensions:
        raise Error(f"{name}: found an array of {given} dimensions, expected {dimensions}")
    return array


def decimal_text(value: Number) -> str:
    """The value as a decimal, exactly. A float stands for the decimal that Python prints for it: 0.1 is one tenth."""
    if isinstance(value, (bool, np.bool_)):
        return repr(value)
    if isinstance(value, (float, np.floating)):
        return repr(float(value))
    if isinstance(value, (int, np.integer)):
        return str(int(value))
    if isinstance(value, decimal.Decimal):
        return str(value)
    if isinstance(value, fractions.Fraction):
        return _finite(value.numerator, value.denominator)
    if hasattr(value, "man_exp"):  # mpmath's: a whole number times a power of two
        mantissa, exponent = (int(part) for part in value.man_exp)
        if mantissa == 0 and value != 0:
            return str(value)  # infinite, or not a number
        return str(mantissa << exponent) if exponent >= 0 else _finite(mantissa, 1 << -exponent)
    return str(value)


def _finite(numerator: int, denominator: int) -> str:
    """A fraction as a decimal, where it has a finite one; else as it is, which will be refused."""
    places, rest = 0, denominator
    for prime in (2, 5):
        power = 0
        while rest % prime == 0:
            rest, power = rest // prime, power + 1
        places = max(places, power)
    if rest != 1:
        return f"{numerator}/{denominator}"
    return f"{numerator * 10 ** places // denominator}e-{places}"


def decimals(values: Numbers, name: str) -> list[str]:
    """The values as decimals, exactly."""
    return [decimal_text(value) for value in entries(values, name)]


def converted(texts: Iterable[str], number: Callable[[str], T]) -> npt.NDArray[Any]:
    """Decimals turned into numbers, in an array that holds them whatever they are."""
    values = [number(text) for text in texts]
    array = np.empty(len(values), dtype=object)
    array[:] = values
    return array


def at_most(lowest: int | None) -> int:
    """How many of the lowest are asked for; all of them without a number."""
    if lowest is None:
        return 2 ** 63 - 1
    if lowest < 1:
        raise Error(f"lowest: found {lowest}, expected 1 or more")
    return int(lowest)
