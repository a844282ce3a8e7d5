"""The straight chain: critical forces and buckling modes."""
from __future__ import annotations

import decimal
from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy.typing as npt

from plumbline import _engine
from plumbline._engine import Error
from plumbline.numbers import Floats, Numbers, at_most, converted, decimals, doubles

if TYPE_CHECKING:
    import pandas


def critical_forces(lengths: Numbers, stiffness: Numbers, *, lowest: int | None = None, digits: int | None = None,
                    number: Callable[[str], Any] = decimal.Decimal) -> npt.NDArray[Any]:
    """The critical forces of a straight chain, ascending; compression is positive.

    :param lengths: of the links, from the base
    :param stiffness: of the joints; 0 is a passive joint
    :param lowest: how many of them; all n - 1 if not given
    :param digits: significant digits, all of them right, of the exact numbers given (a float stands for the decimal
        that Python prints for it). Without: doubles, each within a few units in the last place
    :param number: what each of these decimals becomes: `decimal.Decimal`, `str`, `mpmath.mpf`, …
    :raises Error: for fewer than two links, a length that is not positive, a negative stiffness, a mechanism

    >>> critical_forces([1, 1, 1, 1], [1, 1, 1, 1]).round(6)
    array([0.924028, 2.305658, 3.520315])
    """
    if digits is None:
        return _engine.critical_forces(doubles(lengths, "lengths"), doubles(stiffness, "stiffness"), at_most(lowest))
    return converted(_engine.exact_forces(decimals(lengths, "lengths"), decimals(stiffness, "stiffness"),
                                          at_most(lowest), _digits(digits, 10000)), number)


@dataclass(frozen=True)
class Modes:
    """Buckling modes, ascending by force; m of them, of n joints."""

    force: Floats  #: critical forces, m
    q: Floats  #: joint angles up to a factor, m × n
    fy: Floats  #: lateral force at these angles, m
    signs: list[str]  #: of the angles, such as "+--+"
    shape: list[str]  #: its name, such as "ZU"

    def __len__(self) -> int:
        return len(self.force)

    def to_pandas(self) -> pandas.DataFrame:
        """A row a mode: mode, force, fy, shape, signs, q1 … qn."""
        from plumbline.tables import frame
        columns: dict[str, Any] = {"force": self.force, "fy": self.fy, "shape": self.shape, "signs": self.signs}
        columns.update({f"q{i + 1}": self.q[:, i] for i in range(self.q.shape[1])})
        return frame(columns, index_name="mode")


def critical_modes(lengths: Numbers, stiffness: Numbers, *, lowest: int | None = None) -> Modes:
    """The buckling modes of a straight chain in doubles, each angle to high relative accuracy.

    :param lowest: how many of them; all n - 1 if not given
    :raises Error: as critical_forces

    >>> critical_modes([1, 1, 1], [0, 1, 1]).shape
    ['U', 'Z']
    """
    return Modes(**_engine.critical_modes(doubles(lengths, "lengths"), doubles(stiffness, "stiffness"),
                                          at_most(lowest)))


def lowest_critical_forces(lengths: npt.ArrayLike, stiffness: npt.ArrayLike, *, threads: int | None = None) -> Floats:
    """The lowest critical force of each of many chains of equally many links: eight side by side, on all cores.

    :param lengths: a row a chain, N × n
    :param stiffness: likewise
    :param threads: at most so many; all cores if not given
    :raises Error: for the first chain that cannot be computed, with its number

    >>> lowest_critical_forces([[1, 1], [1, 2]], [[0, 1], [0, 1]])
    array([2. , 1.5])
    """
    all_lengths, all_stiffness = doubles(lengths, "lengths", 2), doubles(stiffness, "stiffness", 2)  # type: ignore[arg-type]
    if all_lengths.shape != all_stiffness.shape:
        raise Error(f"stiffness: found an array {all_stiffness.shape}, expected {all_lengths.shape} as of the lengths")
    return _engine.lowest_forces(all_lengths, all_stiffness, threads or 0)


def critical_certificate(lengths: Numbers, stiffness: Numbers, *, digits: int = 15, lowest: int | None = None,
                         name: str = "chain") -> str:
    """A file of certificates (JSON) of critical forces and mode shapes to so many digits, which
    `proofs/certificates/check_certificates.py` checks with integers alone.

    :raises Error: as critical_forces
    """
    given = [decimals(lengths, "lengths"), decimals(stiffness, "stiffness")]
    command = f"plumbline.critical_certificate({given[0]}, {given[1]}, digits={digits}, lowest={lowest}, name={name!r})"
    return _engine.critical_certificate(name, given[0], given[1], at_most(lowest), _digits(digits, 10000), command)


def _digits(digits: int, most: int) -> int:
    if not 1 <= digits <= most:
        raise Error(f"digits: found {digits}, expected a whole number, 1 to {most}")
    return int(digits)
