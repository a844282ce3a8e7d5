"""The loaded chain: its equilibria, and the paths that they form."""
from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, Literal

import numpy as np
import numpy.typing as npt

from plumbline import _engine
from plumbline._engine import Error
from plumbline.numbers import Floats, Number, Numbers, converted, decimal_text, decimals

if TYPE_CHECKING:
    import matplotlib.axes
    import pandas

Pair = tuple[Number, Number]


@dataclass(frozen=True)
class Points:
    """Equilibria on a path; m of them, of n joints."""

    load: Floats  #: distance of the end point from its unloaded place, or force applied, m
    end_point: Floats  #: m × 2
    force: Floats  #: that the environment exerts on the end point, m × 2; compression has a negative x
    energy: Floats  #: stored energy, m
    stiffness: Floats  #: d(force)/d(deflection) along the load, m
    negative_directions: npt.NDArray[np.int64]  #: in which the energy falls, m: 0 is stable
    q: Floats  #: joint angles, m × n

    def __len__(self) -> int:
        return len(self.load)

    def columns(self) -> dict[str, Any]:
        """As columns of one number each."""
        named: dict[str, Any] = {
            "load": self.load, "x": self.end_point[:, 0], "y": self.end_point[:, 1], "Fx": self.force[:, 0],
            "Fy": self.force[:, 1], "energy": self.energy, "stiffness": self.stiffness,
            "negative_directions": self.negative_directions,
        }
        named.update({f"q{i + 1}": self.q[:, i] for i in range(self.q.shape[1])})
        return named


@dataclass(frozen=True)
class Branch:
    """A stretch of a path: equilibria that hang together."""

    points: Points
    events: Points  #: folds, bifurcations, quasi-buckling points, located to working precision
    event_kinds: list[str]  #: "fold", "bifurcation" or "quasi-buckling"
    event_behind: list[int]  #: the place, from 0, of the point that an event lies behind
    end: str  #: why it ends


@dataclass(frozen=True)
class Proof:
    """What interval arithmetic proves of a branch, the chain's numbers taken as exact decimals."""

    certified: bool  #: one smooth branch without gap or jump, but for `gaps`
    segments: int  #: tubes that it took
    runs: list[tuple[float, float, int]]  #: loads from, to and negative directions: 0 is stable
    folds: list[tuple[float, float]]  #: in each of these loads the load turns exactly once
    gaps: list[tuple[float, float]]  #: loads around bifurcations that stay open
    failure: str | None  #: why it is not proved


@dataclass(frozen=True, repr=False)
class Path:
    """What a chain does under a growing load, or every branch of its equilibria."""

    branches: list[Branch]  #: of a slowly loaded chain, stretch by stretch with jumps between
    direction: tuple[float, float]  #: of the load
    warnings: list[str]
    proofs: list[Proof] = field(default_factory=list)  #: of the branches, where asked for

    def __repr__(self) -> str:
        points = sum(len(branch.points.force) for branch in self.branches)
        return f"<plumbline.Path along {self.direction}: {len(self.branches)} branches, {points} points>"

    def to_pandas(self) -> pandas.DataFrame:
        """A row a point, events among them, as `plumbline path --csv` writes it."""
        import pandas
        tables = []
        for number, branch in enumerate(self.branches, 1):
            points, events = pandas.DataFrame(branch.points.columns()), pandas.DataFrame(branch.events.columns())
            points["event"], events["event"] = "", branch.event_kinds
            points["place"] = np.arange(len(points), dtype=float)
            events["place"] = np.array(branch.event_behind, dtype=float) + 0.5
            both = pandas.concat([points, events]).sort_values("place", kind="stable").drop(columns="place")
            both.insert(0, "branch", number)
            both.insert(1, "point", np.arange(1, len(both) + 1))
            tables.append(both)
        return pandas.concat(tables, ignore_index=True)

    def plot(self, axes: matplotlib.axes.Axes | None = None) -> matplotlib.axes.Axes:
        """Force over deflection, both along the load; unstable parts dashed, events marked."""
        if axes is None:
            import matplotlib.pyplot
            axes = matplotlib.pyplot.figure().add_subplot()
        along = np.array(self.direction)
        start = self.branches[0].points.end_point[0]
        for number, branch in enumerate(self.branches, 1):
            way, push = (branch.points.end_point - start) @ along, branch.points.force @ along
            stable = branch.points.negative_directions == 0
            line, = axes.plot(way, np.where(stable, push, np.nan), label=f"branch {number}")
            axes.plot(way, np.where(stable, np.nan, push), "--", color=line.get_color())
            axes.plot((branch.events.end_point - start) @ along, branch.events.force @ along, "o",
                      color=line.get_color())
            for kind, place, force in zip(branch.event_kinds, branch.events.end_point, branch.events.force):
                axes.annotate(kind, ((place - start) @ along, force @ along), textcoords="offset points", xytext=(4, 4))
        axes.set_xlabel("deflection along the load")
        axes.set_ylabel("force along the load")
        return axes


def path(lengths: Numbers, stiffness: Numbers, rest: Numbers, *, to: float | None = None, dy: float = 0.0,
         force: tuple[float, float] | None = None, branches: Literal["stable", "all"] = "stable", side: int = 1,
         step: float = 0.005, certify: bool = False) -> Path:
    """The force-deflection curve of a chain, with stability, buckling and quasi-buckling points.

    :param rest: joint angles of the unloaded shape
    :param to: how far the end point is moved against x: compression is positive
    :param dy: and along y, in proportion
    :param force: instead of `to`: a force on the end point that grows from zero to this
    :param branches: "stable": what a slowly loaded chain does, jumps included; "all": every branch that hangs together
        with it or (up to five links) passes the last or the middle load
    :param side: where a symmetric chain buckles: 1 or -1
    :param step: longest way between points: root mean square turn of the links, radians
    :param certify: prove what was followed by interval arithmetic
    :raises Error: for a load that is zero, an end point out of reach, a wrong chain
    """
    return _path(lengths, stiffness, rest, to, dy, force, branches, side, step, certify, "")[0]


def path_certificate(lengths: Numbers, stiffness: Numbers, rest: Numbers, *, to: float | None = None, dy: float = 0.0,
                     force: tuple[float, float] | None = None, branches: Literal["stable", "all"] = "stable",
                     side: int = 1, step: float = 0.005) -> str:
    """A file of certificates (JSON) of what `path` follows, which `proofs/certificates/check_paths.py` checks with integers alone.

    :raises Error: as `path`, and where something is not proved
    """
    chain = ", ".join(str(decimals(values, name)) for values, name in
                      ((lengths, "lengths"), (stiffness, "stiffness"), (rest, "rest")))
    load = f"force={force}" if force is not None else f"to={to}, dy={dy}"
    command = f"plumbline.path_certificate({chain}, {load}, branches={branches!r}, side={side}, step={step})"
    return _path(lengths, stiffness, rest, to, dy, force, branches, side, step, True, command)[1]


def _path(lengths: Numbers, stiffness: Numbers, rest: Numbers, to: float | None, dy: float,
          force: tuple[float, float] | None, branches: str, side: int, step: float, certify: bool,
          command: str) -> tuple[Path, str]:
    if (to is None) == (force is None):
        raise Error("load: found " + ("neither to nor force" if to is None else "both to and force") + ", expected one")
    if branches not in ("stable", "all"):
        raise Error(f"branches: found {branches!r}, expected 'stable' or 'all'")
    if side not in (1, -1):
        raise Error(f"side: found {side}, expected 1 or -1")
    if not 1e-4 <= step <= 0.5:
        raise Error(f"step: found {step}, expected a number, 1e-4 to 0.5")
    by = (-float(to), float(dy)) if to is not None else force
    if by is None or len(by) != 2 or not np.all(np.isfinite(by)):
        raise Error(f"load: found {by}, expected two finite numbers")
    found = _engine.path(decimals(lengths, "lengths"), decimals(stiffness, "stiffness"), decimals(rest, "rest"),
                         held=to is not None, by=(float(by[0]), float(by[1])), slowly=branches == "stable", side=side,
                         step=step, certify=certify, command=command)
    followed = [_branch(one) for one in found["branches"]]
    proofs = [Proof(**one) for one in found["proofs"]]
    return Path(followed, found["direction"], found["warnings"], proofs), found["certificate"]


def _branch(found: dict[str, Any]) -> Branch:
    points = {name: found[name] for name in Points.__dataclass_fields__}
    return Branch(Points(**points), Points(**found["events"]), found["event_kinds"], found["event_behind"],
                  found["end"])


@dataclass(frozen=True)
class Equilibria:
    """Equilibria at one place of the end point or under one force, by energy; m of them, of n joints.

    Arrays of doubles; of what `number` made where digits were asked for.
    """

    q: npt.NDArray[Any]  #: joint angles, m × n
    end_point: npt.NDArray[Any]  #: m × 2
    force: npt.NDArray[Any]  #: on the end point, m × 2
    energy: npt.NDArray[Any]  #: m
    negative_directions: npt.NDArray[np.int64]  #: in which the energy falls, m: 0 is stable; -1: open
    complete: bool  #: proved: these are all, with joint angles in the window
    undecided: int  #: boxes of joint angles that may hold further ones
    window: list[tuple[float, float]]  #: joint angles counted, by joint; empty: all

    def __len__(self) -> int:
        return len(self.energy)

    @property
    def stable(self) -> npt.NDArray[np.bool_]:
        """Which are stable, m."""
        stable: npt.NDArray[np.bool_] = self.negative_directions == 0
        return stable

    def to_pandas(self) -> pandas.DataFrame:
        """A row an equilibrium: energy, x, y, Fx, Fy, negative_directions, q1 … qn."""
        from plumbline.tables import frame
        columns: dict[str, Any] = {
            "energy": self.energy, "x": self.end_point[:, 0], "y": self.end_point[:, 1], "Fx": self.force[:, 0],
            "Fy": self.force[:, 1], "negative_directions": self.negative_directions,
        }
        columns.update({f"q{i + 1}": self.q[:, i] for i in range(self.q.shape[1])})
        return frame(columns, index_name="equilibrium")


def equilibria(lengths: Numbers, stiffness: Numbers, rest: Numbers, *, at: Pair | None = None,
               end_point: Pair | None = None, force: Pair | None = None, certify: bool = False, turns: int = 0,
               digits: int | None = None, number: Callable[[str], Any] | None = None) -> Equilibria:
    """All equilibria of a chain: shape, force, energy, type.

    One of three says how it is loaded:

    :param at: the unloaded end point moved by dx against x (compression is positive) and by dy along y
    :param end_point: the end point held at (x, y)
    :param force: a force on the end point
    :param certify: prove by interval arithmetic that the list is complete; without, Newton's method from many random
        shapes, which is fast and never sure
    :param turns: with the end point held: count shapes whose joints are wound up by so many full turns more
    :param digits: with `certify`: so many significant digits, 35 at most, all of them certain
    :param number: what each of these decimals becomes; `decimal.Decimal` if not given
    :raises Error: for a wrong chain, an end point out of reach, a continuum of equilibria
    """
    found = _equilibria(lengths, stiffness, rest, at, end_point, force, certify, turns, digits or 17, "")
    if digits is None:
        def table(rows: list[list[str]], columns: int) -> npt.NDArray[Any]:
            return np.array(rows, dtype=np.float64).reshape(len(rows), columns)
        energy: npt.NDArray[Any] = np.array(found["energy"], dtype=np.float64)
    else:
        if not certify:
            raise Error("digits: found it without certify, expected certify=True: only proved digits are certain")
        import decimal
        make = number or decimal.Decimal

        def table(rows: list[list[str]], columns: int) -> npt.NDArray[Any]:
            return converted([text for row in rows for text in row], make).reshape(len(rows), columns)
        energy = converted(found["energy"], make)
    return Equilibria(table(found["q"], len(lengths)), table(found["end_point"], 2), table(found["force"], 2), energy,
                      np.array(found["negative_directions"], dtype=np.int64), found["complete"], found["undecided"],
                      found["window"])


def equilibria_certificate(lengths: Numbers, stiffness: Numbers, rest: Numbers, *, at: Pair | None = None,
                           end_point: Pair | None = None, force: Pair | None = None, turns: int = 0) -> str:
    """A file of certificates (JSON) that the list of equilibria is complete, which `proofs/certificates/check_equilibria.py` checks
    with integers alone.

    :raises Error: as `equilibria`, and where something stays undecided
    """
    chain = ", ".join(str(decimals(values, name)) for values, name in
                      ((lengths, "lengths"), (stiffness, "stiffness"), (rest, "rest")))
    load = f"at={at}" if at is not None else f"end_point={end_point}" if end_point is not None else f"force={force}"
    command = f"plumbline.equilibria_certificate({chain}, {load}, turns={turns})"
    return str(_equilibria(lengths, stiffness, rest, at, end_point, force, True, turns, 17, command)["certificate"])


def _equilibria(lengths: Numbers, stiffness: Numbers, rest: Numbers, at: Pair | None, end_point: Pair | None,
                force: Pair | None, certify: bool, turns: int, digits: int, command: str) -> dict[str, Any]:
    loads = {"deflection": at, "end_point": end_point, "force": force}
    given = [name for name, load in loads.items() if load is not None]
    if len(given) != 1:
        raise Error(f"load: found {len(given)} of at, end_point and force, expected one")
    if not 0 <= turns <= 100:
        raise Error(f"turns: found {turns}, expected a whole number, 0 to 100")
    if not 1 <= digits <= 35:
        raise Error(f"digits: found {digits}, expected a whole number, 1 to 35")
    load = loads[given[0]]
    if load is None or len(load) != 2:
        raise Error(f"{given[0]}: found {load}, expected two numbers")
    return _engine.equilibria(decimals(lengths, "lengths"), decimals(stiffness, "stiffness"), decimals(rest, "rest"),
                              given=given[0], load=(decimal_text(load[0]), decimal_text(load[1])), turns=int(turns),
                              certify=certify, digits=digits, command=command)
