"""A structure as a chain file states it: docs/chain-format.md and docs/ends-and-loads.md, read once, every number exact.

A chain in the plane is one in space whose joints all turn about z; nothing below `read` tells them apart but `space`.
"""
import tomllib
from dataclasses import dataclass
from fractions import Fraction

Z = (Fraction(0), Fraction(0), Fraction(1))
ENDS = {
    "base": {"pinned": ("held", "held", "free"), "sprung": ("held", "held", "free"), "jointed": ("held", "held", "free"),
             "bearing": ("held", "held", "free"), "clamped": ("held", "held", "held")},
    "end_point": {"guided": ("free", "held", "free"), "free": ("free", "free", "free"), "clamped": ("free", "held", "held")},
}
WORDS = {False: {"base": ("pinned", "sprung", "clamped"), "end_point": ("guided", "free", "clamped")},
         True: {"base": ("jointed", "clamped", "bearing"), "end_point": ("guided", "free", "clamped")}}
KEYS = {"lengths", "link_length", "stiffness", "joint_stiffness", "rest", "base", "end_point", "supports", "foundation", "loads",
        "masses", "joints"}


class NotAStructure(ValueError):
    """The statement contradicts itself or the documents."""


@dataclass
class End:
    along: object  # "free", "held" or the stiffness of a spring
    across: object
    turn: object


@dataclass
class Load:
    kind: str  # force, follower, moment or torque
    node: int = 0  # nodes are 0 (base) to n (end point); a follower is against the link that ends there
    value: object = None  # a vector, a size, or the torque's name
    fixed: bool = False


@dataclass
class Statement:
    lengths: list
    joints: list  # of each joint its springs: (axis, stiffness)
    rest: list
    space: bool
    base: End
    end_point: End
    supports: dict  # by node: "held", "free" or a stiffness
    foundation: Fraction
    loads: list
    masses: list  # at nodes 0 ... n
    bearing: bool  # whether joint 1 takes a torque off link 1

    @property
    def links(self):
        return len(self.lengths)

    def bed(self, node):
        """The share of the elastic bed that stands on a node."""
        return self.foundation * half_links(self.lengths)[node]


def demand(holds, what):
    if not holds:
        raise NotAStructure(what)


def half_links(lengths):
    """Half of the links that meet at each node."""
    return [(a + b) / 2 for a, b in zip([0] + lengths, lengths + [0])]


def number(value, what):
    demand(not isinstance(value, bool) and isinstance(value, (int, Fraction, str)), f"{what} is not a number")
    try:
        return Fraction(value)
    except ValueError:
        raise NotAStructure(f"{what} is not a number") from None


def numbers(value, what):
    if isinstance(value, str):
        value = value.split(";")
    demand(isinstance(value, list), f"{what} is not a list")
    return [number(v, what) for v in value]


def held(value, what):
    if value in ("free", "held"):
        return value
    stiffness = number(value, what)
    demand(stiffness >= 0, f"{what} is negative")
    return stiffness or "free"


def end(table, key, space):
    value = table.get(key)
    if value is None:
        value = "pinned" if key == "base" else "guided"
        return End(*ENDS[key][value])
    if isinstance(value, str):
        demand(value in WORDS[space][key], f"{key} is {value}")
        return End(*ENDS[key][value])
    demand(isinstance(value, dict) and not set(value) - {"along", "across", "turn"}, f"{key} is no table of along, across, turn")
    usual = ("held", "held", "free") if key == "base" else ("free", "held", "free")
    found = End(*(held(value[name], f"{key}.{name}") if name in value else default
                  for name, default in zip(("along", "across", "turn"), usual)))
    demand(found.turn in ("free", "held") or key == "end_point" and not space, f"{key}.turn is a spring")
    demand(not space or found.along == usual[0] and found.across in (("held",) if key == "base" else ("free", "held")),
           f"{key} is held as none in space is")
    return found


def vector(value, size, what):
    found = numbers(value, what)
    demand(len(found) == size, f"{what} has {len(found)} components")
    return tuple(found + [Fraction(0)] * (3 - size))


def fixed_of(table):
    fixed = table.get("fixed", False)
    demand(isinstance(fixed, bool), "fixed is neither true nor false")
    return fixed


def weights(table, lengths, size):
    """The middle of a rigid link is midway between its ends. In space a weight is a vector, the same for each link."""
    value = table["weight"]
    if size == 3:
        pull = vector(value, 3, "weight")
        return [Load("force", node, tuple(c * share for c in pull), fixed_of(table))
                for node, share in enumerate(half_links([Fraction(1)] * len(lengths)))]
    each = numbers(value, "weight") if isinstance(value, list) else [number(value, "weight")] * len(lengths)
    demand(len(each) == len(lengths), "weight has not one value a link")
    down = vector(table["direction"], size, "direction") if "direction" in table else (Fraction(-1), Fraction(0), Fraction(0))
    demand(abs(sum(c * c for c in down) - 1) < Fraction(1, 10 ** 9), "direction is no unit vector")
    return [Load("force", node, tuple(c * (a + b) / 2 for c in down), fixed_of(table))
            for node, (a, b) in enumerate(zip([0] + each, each + [0]))]


def load(table, lengths, size):
    demand(isinstance(table, dict), "a load is no table")
    kinds = set(table) & {"force", "weight", "moment", "follower", "torque"}
    demand(len(kinds) == 1, "a load is not of one kind")
    kind, = kinds
    allowed = {"force": {"at"}, "follower": {"at"}, "weight": {"direction"} if size == 2 else set()}.get(kind, set())
    demand(not set(table) - {kind, "fixed"} - allowed, f"a {kind} has an unknown key")
    fixed = fixed_of(table)
    if kind == "weight":
        return weights(table, lengths, size)
    demand(not fixed or kind not in ("moment", "torque"), f"a {kind} is fixed")
    node = len(lengths)
    if "at" in table:
        demand(type(table["at"]) is int and 2 <= table["at"] <= len(lengths), "at names no joint")
        node = table["at"] - 1
    if kind == "force":
        return [Load(kind, node, vector(table["force"], size, "force"), fixed)]
    if kind == "torque":
        demand(size == 3 and table["torque"] in ("semitangential", "axial", "tangential"), "torque is unknown")
        return [Load(kind, node, table["torque"], fixed)]
    return [Load(kind, node, number(table[kind], kind), fixed)]


def joints_of(table, count):
    demand(isinstance(table, list) and len(table) == count, "joints are not one a link")
    result = []
    for joint in table:
        demand(isinstance(joint, dict) and set(joint) == {"axes", "stiffness"} and isinstance(joint["axes"], list),
               "a joint has axes and stiffness")
        springs = numbers(joint["stiffness"], "stiffness")
        axes = [vector(axis, 3, "axis") for axis in joint["axes"]]
        demand(1 <= len(axes) <= 3 and len(axes) == len(springs), "a joint has one to three axes, with a spring each")
        demand(all(any(axis) for axis in axes), "an axis is zero")
        demand(min(springs) >= 0, "a stiffness is negative")
        result.append(list(zip(axes, springs)))
    return result


def supports_of(table, links):
    demand(isinstance(table, list), "supports are no list")
    result = {}
    for support in table:
        demand(isinstance(support, dict) and set(support) == {"at", "across"}, "a support has at and across")
        demand(type(support["at"]) is int and 2 <= support["at"] <= links, "a support's at names no joint")
        demand(support["at"] - 1 not in result, "two supports at one joint")
        result[support["at"] - 1] = held(support["across"], "across")
    return result


def read(text):
    """The structure that a chain file states; raises NotAStructure."""
    try:
        table = tomllib.loads(text, parse_float=Fraction)
    except (tomllib.TOMLDecodeError, ValueError) as error:
        raise NotAStructure(f"no TOML: {error}") from None
    demand(not set(table) - KEYS, f"unknown key {set(table) - KEYS}")
    lengths = numbers(table.get("lengths", table.get("link_length")), "lengths")
    demand(lengths and min(lengths) > 0, "a length is not positive")
    space = "joints" in table
    if space:
        demand(not {"stiffness", "joint_stiffness", "rest"} & set(table), "joints and stiffness")
        joints, rest = joints_of(table["joints"], len(lengths)), []
    else:
        springs = numbers(table.get("stiffness", table.get("joint_stiffness")), "stiffness")
        demand(len(springs) == len(lengths) and min(springs) >= 0, "stiffness has not one value a joint, from 0 on")
        joints, rest = [[(Z, k)] for k in springs], numbers(table.get("rest", [0] * len(lengths)), "rest")
    base, end_point = end(table, "base", space), end(table, "end_point", space)
    first = any(k for _, k in joints[0])
    demand(not first or base.turn == "free" and table.get("base") not in ("pinned", "bearing"), "joint 1 has a spring beside its base")
    demand(first or table.get("base") != "sprung", "a sprung base has no spring")
    demand((base.along == "free") != (end_point.along == "free"), "not exactly one end is held along")
    foundation = number(table.get("foundation", 0), "foundation")
    demand(foundation >= 0, "foundation is negative")
    size = 3 if space else 2
    demand(isinstance(table.get("loads", []), list), "loads are no list")
    loads = [l for item in table["loads"] for l in load(item, lengths, size)] if "loads" in table else \
        [Load("force", len(lengths), (Fraction(-1), Fraction(0), Fraction(0)))]
    demand(loads, "no load")
    return Statement(lengths, joints, rest or [Fraction(0)] * len(lengths), space, base, end_point,
                     supports_of(table.get("supports", []), len(lengths)), foundation, loads, masses_of(table, lengths, base),
                     table.get("base") == "bearing")


def masses_of(table, lengths, base):
    """At all nodes: those of the file, with none at a base that stays on the line, or half of each link's length at either end."""
    if "masses" not in table:
        return half_links(lengths)
    found = numbers(table["masses"], "masses")
    if base.across == "held":
        found = [Fraction(0)] + found
    demand(len(found) == len(lengths) + 1 and min(found) >= 0, "masses are not one a link, and one of a base that moves")
    return found
