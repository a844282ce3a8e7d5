"""Chains with any ends, supports and loads, in the plane or in space."""
from __future__ import annotations

import decimal
import io
import json
import pathlib
import tempfile
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Literal, Union

import numpy as np
import numpy.typing as npt

from plumbline import _engine
from plumbline.numbers import at_most, converted, decimal_text
from plumbline.program import run
from plumbline.straight import _digits

if TYPE_CHECKING:
    import pandas

#: The keys of a chain file (docs/chain-format.md) with their values, or the text of such a file.
Chain = Union[Mapping[str, Any], str]


def critical_factors(chain: Chain, *, lowest: int | None = None, digits: int | None = None,
                     number: Callable[[str], Any] = decimal.Decimal) -> npt.NDArray[Any]:
    """The factors of its loads at which a straight chain may buckle, ascending. The loads have an energy; for one that
    follows the chain see stability_loss.

    :param chain: lengths and stiffness (or joints in space), ends, supports and loads, as a chain file has them
    :param lowest: how many of them; all if not given
    :param digits: significant digits, all of them right. Without: doubles
    :param number: what each of these decimals becomes: `decimal.Decimal`, `str`, `mpmath.mpf`, …
    :raises Error: for a wrong chain, a mechanism, loads that bend the chain or only pull

    >>> critical_factors({"lengths": [1, 1], "stiffness": [1, 1], "end_point": "free"}).round(6)
    array([0.381966, 2.618034])
    """
    if digits is None:
        return np.array(_engine.critical_factors(_text(chain), at_most(lowest), 17), dtype=np.float64)
    return converted(_engine.critical_factors(_text(chain), at_most(lowest), _digits(digits, 10000)), number)


@dataclass(frozen=True)
class StabilityLoss:
    """Where a chain ceases to be stable under loads that follow it."""

    kind: str  #: "divergence" or "flutter"
    factor: Any  #: of the loads
    first: bool  #: whether it is proved that the chain is stable at every smaller factor


def stability_loss(chain: Chain, *, digits: int | None = None,
                   number: Callable[[str], Any] = decimal.Decimal) -> StabilityLoss:
    """The factor of its loads at which the small motion of a straight chain ceases to be stable. Masses are at the far ends
    of the links; without the key `masses` each link has its length's, half of it at either end.

    :param digits: significant digits, all of them right. Without: a double
    :param number: what this decimal becomes
    :raises Error: for a wrong chain, and where stability is never lost

    >>> ziegler = {"lengths": [1, 1], "stiffness": [1, 1], "end_point": "free", "masses": [2, 1], "loads": [{"follower": 1}]}
    >>> stability_loss(ziegler, digits=5)
    StabilityLoss(kind='flutter', factor=Decimal('2.0858'), first=True)
    """
    found = _engine.stability_loss(_text(chain), 17 if digits is None else _digits(digits, 10000))
    factor = float(found["factor"]) if digits is None else number(found["factor"])
    return StabilityLoss(found["kind"], factor, found["first"])


def structure_certificate(chain: Chain, *, digits: int = 15, lowest: int | None = None, name: str = "chain") -> str:
    """A file of certificates (JSON) of critical factors, or of the loss of stability, to so many digits, which
    `proofs/certificates/check_structures.py` checks with fractions alone.

    :raises Error: as critical_factors and stability_loss
    """
    text = _text(chain)
    command = f"plumbline.structure_certificate({text!r}, digits={digits}, lowest={lowest}, name={name!r})"
    return _engine.structure_certificate(name, text, at_most(lowest), _digits(digits, 10000), command)


def structure_path(chain: Chain, *, factor: float = 1.0, branches: Literal["stable", "all"] = "stable",
                   side: Literal[1, -1] = 1, step: float = 0.005) -> pandas.DataFrame:
    """The way of a chain as its loads grow from zero to `factor` times what the chain says: a row a point.

    :param branches: "stable", what a slowly loaded chain does, jumps included; "all" that hang together with it
    :param side: where a symmetric chain buckles, the side it leaves to
    :param step: longest way between points: root mean square turn of the links, in radians
    :returns: by branch and point: factor, x, y, z of the end point, energy, negative_directions (0 is stable), event,
        joint angles q1, q2, …
    :raises Error: for a wrong chain, and for loads that do not act on it
    """
    import pandas
    table = _with_file(chain, "path", "--csv", "--factor", repr(float(factor)), "--branches", branches, "--side", str(side),
                       "--step", repr(float(step)))
    return pandas.read_csv(io.StringIO(table)).set_index(["branch", "point"])


def structure_equilibria(chain: Chain, *, factor: float = 1.0, certify: bool = False) -> pandas.DataFrame:
    """The equilibria of a chain under `factor` times its loads: a row each, with the joint angles in `q`.

    :param certify: whether the list is proved to be complete; numbers are then decimals in text, every digit of them right
    :returns: with `attrs`: chain, case, factor, complete, and of a proof the window
    :raises Error: for a wrong chain
    """
    import pandas
    found = json.loads(_with_file(chain, "equilibria", "--json", "--factor", repr(float(factor)),
                                  *(["--certify"] if certify else [])))
    table = pandas.DataFrame(found.pop("equilibria"))
    table.attrs.update(found)
    return table


def _with_file(chain: Chain, verb: str, *words: str) -> str:
    """What the program says of the chain, written to a file for it."""
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder, "chain.toml")
        file.write_text(_text(chain), encoding="utf-8")
        return run(verb, file, *words)


def _text(chain: Chain) -> str:
    """The chain as a file."""
    if isinstance(chain, str):
        return chain
    return "".join(f"{json.dumps(str(key))} = {_value(value)}\n" for key, value in chain.items())


def _value(value: Any) -> str:
    """As TOML; a text that is a decimal is a number."""
    if isinstance(value, (bool, np.bool_)):
        return "true" if value else "false"
    if isinstance(value, Mapping):
        return "{ " + ", ".join(f"{json.dumps(str(key))} = {_value(one)}" for key, one in value.items()) + " }"
    if isinstance(value, Iterable) and not isinstance(value, (str, bytes)):
        return "[" + ", ".join(_value(one) for one in value) + "]"
    text = decimal_text(value)
    try:
        number = decimal.Decimal(text)
    except decimal.InvalidOperation:
        return json.dumps(text)
    return str(number) if number.is_finite() else json.dumps(text)
