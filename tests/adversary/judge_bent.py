"""Verdicts on `path` and `equilibria`: points that are equilibria, none that is missing, bifurcations at the critical factors."""
import math
from fractions import Fraction

import numpy

import bent
import census
import energy
import integers
import modes
import points
from judge_straight import UNCERTIFIED, against, of_words
from judge_straight import CERTIFIED
from statement import NotAStructure, read
from straight import straight

STRAIGHT = 1e-9


def opened(text, answer):
    """The statement, or a verdict that needs no more."""
    bad = of_words(answer)
    if bad:
        return None, bad
    try:
        statement = read(text)
    except NotAStructure as error:
        return None, against(str(error), answer)
    kinds = {load.kind for load in statement.loads}
    if kinds & {"follower", "torque"}:
        return None, against("a load has no energy", answer)
    return statement, None


def paths(program, text, tally, factor):
    answer = program("path", text, "--factor", str(factor), "--json", "--step", "0.05")
    statement, verdict = opened(text, answer)
    if verdict:
        return verdict
    line = straight(statement)
    if answer.refused:
        return against(why_no_path(line) or bent.why_singular(statement), answer)
    if why_no_path(line):
        return [("unsettled", "")]
    faults = []
    for branch in answer.json()["branches"]:
        some = few(branch["points"], 5) + few(branch["events"], 3)
        for point in some:
            fault = points.fault(statement, point, at_event="kind" in point)
            tally.checked["points of paths"] += 1
            if fault:
                faults.append(f"at factor {point['factor']:.12g}: {fault}")
                break
        faults += missing_bifurcations(statement, line, branch, tally)
    return [(UNCERTIFIED, f) for f in faults[:2]] or [("answered", "")]


def few(items, most):
    """The first, the last and some between."""
    return items[::max(1, len(items) // most)] + items[-1:]


def why_no_path(line):
    if not line.size:
        return "nothing can move"
    return "" if modes.is_stable_unloaded(line) else "it is not stable unloaded"


def missing_bifurcations(statement, line, branch, tally):
    """Critical factors that a straight stretch of a branch passes without an event."""
    flat = [p for p in branch["points"] if max(map(abs, p["q"])) < STRAIGHT]
    if len(flat) < 2 or not line.balanced:
        return []
    low, high = flat[0]["factor"], flat[-1]["factor"]
    passed = sum(line.negatives(Fraction(high))) - line.negatives(Fraction(low))[0]
    seen = [e for e in branch["events"] if max(map(abs, e["q"])) < 1e-6]
    tally.checked["straight stretches"] += 1
    if bent.why_singular(statement):
        return ["a path along " + bent.why_singular(statement)]
    if passed and not seen:
        return [f"{passed} critical factors passed between {low} and {high}"]
    for event in seen:
        near = (Fraction(event["factor"]) * (1 + Fraction(sign, 10 ** 6)) for sign in (-1, 1))
        below, above = (line.negatives(f)[0] for f in near)
        if event["kind"] == "bifurcation" and below == above:
            return [f"a bifurcation at {event['factor']}, which is not critical"]
    return []


def equilibria(program, text, tally, factor, starts, seed):
    """Of a chain in the plane, certified; in space, or where that stays undecided, point by point."""
    certify = ["--certify"] if "joints" not in text else []
    answer = program("equilibria", text, "--factor", str(factor), "--json", *certify, seconds=3 * program.seconds)
    undecided = answer.status == 1 and answer.out.startswith("{")
    if undecided:
        answer.status = 0
    statement, verdict = opened(text, answer)
    if verdict:
        return verdict
    line = straight(statement)
    if answer.refused:
        reason = why_no_path(line) or (beyond(statement) or not_isolated(statement, factor, seed) if certify else "")
        return against(reason, answer)
    if why_no_path(line) and not certify:
        return [("unsettled", "")]
    said = answer.json()
    printed = [numbers_of(e, said["factor"]) for e in said["equilibria"]]
    faults = [(UNCERTIFIED if not said["complete"] else CERTIFIED, f) for f in point_faults(statement, printed, tally)]
    if said["complete"]:
        faults += [(CERTIFIED, f) for f in missing(statement, said, printed, starts, seed, tally)]
    return faults[:2] or [("unsettled" if undecided else "answered", "")]


def beyond(statement):
    """The limits of certified censuses that docs/ends-and-loads.md states."""
    if energy.shifts(statement) != (False, False) or statement.end_point.along != "free":
        return "a census takes no base that moves, and no end point held along"
    return "a census takes no joint held across" if "held" in statement.supports.values() else ""


def not_isolated(statement, factor, seed):
    for shape in census.equilibria(statement, factor, 40, seed, solved=census.shortest):
        about = bent.found(statement, list(shape), float(Fraction(factor)))
        if about.residual < 1e-9 and numpy.min(abs(about.eigenvalues), initial=numpy.inf) < 1e-9 * about.scale:
            return "equilibria are not isolated"
    return ""


def numbers_of(equilibrium, factor):
    result = {"factor": factor, **equilibrium}
    result["q"], result["end_point"] = ([float(x) for x in equilibrium[key]] for key in ("q", "end_point"))
    result["energy"] = float(equilibrium["energy"])
    return result


def turned_together(statement, a, b):
    """How far two shapes are apart; a joint without a spring does not know whole turns, but what holds the end's turning knows their sum."""
    gaps, whole = [], 0
    for (joint, axis, stiffness), x, y in zip(energy.turns(statement), a, b):
        turns = 0 if stiffness else round((x - y) / (2 * math.pi))
        gaps.append(abs(x - y - 2 * math.pi * turns))
        whole += turns
    if whole and not statement.space and statement.end_point.turn != "free":
        return 2 * math.pi * abs(whole)
    return max(gaps)


def point_faults(statement, printed, tally):
    result = []
    for i, point in enumerate(printed):
        if any(turned_together(statement, point["q"], other["q"]) < 1e-7 for other in printed[:i]):
            result.append(f"equilibrium {i + 1} is listed twice")
    for i, point in list(enumerate(printed, 1))[::max(1, len(printed) // 10)]:
        tally.checked["equilibria"] += 1
        said = point.get("type")
        stable = None if said is None else said == "stable"
        fault = points.fault(statement, point, stable)
        if fault:
            result.append(f"equilibrium {i}: {fault}")
    return result


def missing(statement, said, printed, starts, seed, tally):
    """Regular equilibria of the window that Newton's method finds and the list lacks."""
    turns = len(energy.turns(statement))
    rest = numpy.array([float(r) for r in statement.rest])
    result = []
    for shape in census.equilibria(statement, said["factor"], starts, seed):
        inside = numpy.max(abs(shape[:turns] - rest)) < said["widest_turn"] - 1e-6
        point = {"q": shape[:turns], "factor": said["factor"]}
        if not inside or not points.is_regular(statement, shape, said["factor"], said["largest_force_across"]):
            continue
        tally.checked["equilibria found by Newton"] += 1
        if all(turned_together(statement, point["q"], p["q"]) > 1e-5 for p in printed):
            result.append(f"an equilibrium is missing: q = {[round(float(q), 9) for q in shape[:turns]]}")
    return result
