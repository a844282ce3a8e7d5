"""Verdicts on `critical`: what it says of a straight structure against what is true of it."""
import random

import bent
import dynamics
import integers
import modes
import torque
from decimals import interval
from statement import NotAStructure, read
from straight import straight

CERTIFIED, UNCERTIFIED = "false certified", "wrong uncertified"


def of_words(answer):
    """Hangs, crashes and raw texts, which need no truth; None where the answer is one to be judged."""
    if answer.hangs:
        return [("hangs", "no answer in time")]
    if answer.crashed:
        return [("crashes", f"exit status {answer.status}")]
    return [("raw texts", answer.raw + ": " + answer.complaint.strip()[:120])] if answer.raw else []


def against(reason, answer):
    """Of a structure that has to be refused for this reason, or answered where there is none; None asks for a closer look."""
    if answer.refused:
        return [("refused rightly", reason)] if reason else [("refused wrongly", answer.complaint.strip()[:160])]
    return [(CERTIFIED, f"answered, but {reason}")] if reason else None


def critical(program, text, tally, digits):
    """Of dead loads, followers and torques alike."""
    answer = program("critical", text, "--json", "--all", "--digits", str(digits))
    bad = of_words(answer)
    if bad:
        return bad
    try:
        statement = read(text)
    except NotAStructure as error:
        return against(str(error), answer)
    kinds = {load.kind for load in statement.loads}
    if "torque" in kinds:
        return of_torque(statement, answer, tally)
    line = straight(statement, twists=False)
    if "follower" in kinds:
        return of_loss(program, text, line, answer, tally, digits)
    return of_modes(statement, line, answer, tally)


def why_not_straight(line):
    """Why a straight line has no critical factor at all."""
    if not line.balanced:
        return "a load bends the straight line"
    if line.symmetric and not modes.is_stable_unloaded(line):
        return "it is not stable unloaded"
    return "" if line.size else "nothing can move"


def of_modes(statement, line, answer, tally):
    reason = why_not_straight(line) or ("" if modes.count(line) else "no factor is critical") or bent.why_singular(statement)
    verdict = against(reason, answer)
    if verdict:
        return verdict
    chain, = answer.json()["chains"]
    if "modes" not in chain and "modes_in_space" not in chain:
        return [(CERTIFIED, "no modes")]
    printed = [(mode["mode"], mode["force"], mode["q"], mode.get("fy")) for mode in chain.get("modes", chain.get("modes_in_space"))]
    faults, right = modes.faults(line, statement, printed, random.Random(1))
    faults += word_faults(chain.get("modes", []))
    tally.checked["critical factors"] += right
    tally.checked["shapes"] += right
    return [(CERTIFIED if "is not" in f or "modes" in f else UNCERTIFIED, f) for f in faults[:2]] or [("answered", "")]


def word_faults(printed):
    """Signs are those of the angles, and the energy factor is the force."""
    result = []
    for mode in printed:
        largest = max(map(abs, mode["q"]))
        signs = ["+" if q > 0 else "-" for q in mode["q"]]
        if any(said != sign for said, sign, q in zip(mode["signs"], signs, mode["q"]) if abs(q) > 1e-9 * largest):
            result.append(f"mode {mode['mode']}: signs {mode['signs']} of {mode['q']}")
        low, high = interval(mode["energy_factor"])
        other = interval(mode["force"])
        if low > other[1] or high < other[0]:
            result.append(f"mode {mode['mode']}: energy factor {mode['energy_factor']} of {mode['force']}")
    return result


# loads that follow

def why_no_loss(line, found, begin):
    if begin != "stable":
        return "it is not stable unloaded"
    return "" if any(e.at != "stable" or e.above != "stable" for e in found) else "it is stable at every factor"


def of_loss(program, text, line, answer, tally, digits):
    reason = why_not_straight(line)
    if not reason and not dynamics.has_masses(line):
        reason = "something that moves has no mass"
    found, begin = ([], "") if reason else dynamics.events(line)
    verdict = against(reason or why_no_loss(line, found, begin), answer)
    if verdict:
        return verdict
    chain, = answer.json()["chains"]
    if "loss" not in chain:
        return [(CERTIFIED, "no loss")]
    words = program("critical", text, "--digits", str(digits)).out
    tally.checked["losses of stability"] += 1
    return [(CERTIFIED, f) for f in loss_faults(chain["loss"], words, found)] or [("answered", "")]


def loss_faults(said, words, found):
    """Of the loss that is stated, against the events in their order, but for single factors that it leaves undecided."""
    found = [e for e in found if e.before != "stable" or e.above != "stable" or not any(lies(e, u) for u in said.get("undecided", []))]
    losses = [e for e in found if e.before == "stable" and (e.at != "stable" or e.above != "stable")]
    here = [e for e in losses if lies(e, said["factor"])]
    if not here:
        return [f"no loss at {said['factor']}, the first at {float(losses[0].low)}"]
    result = []
    if said["first"] and here[0] is not losses[0]:
        result.append(f"stable at every smaller factor, but {losses[0].at} at {float(losses[0].low)}")
    if said["kind"] not in (here[0].at, here[0].above):
        result.append(f"{said['kind']} for {here[0].at}")
    return result + window_faults(said, words, [e for e in found if e.low >= here[0].low])


def stretches(found):
    """(from, to) of stable stretches above the first of some events; None where one has no end, (x, x) for no stretch."""
    result, begin = [], None
    for event in found:
        if event.at != "stable" or event.before != "stable":
            if begin is not None:
                result.append((begin, event))
            begin = event if event.above == "stable" else None
    return result + ([(begin, None)] if begin is not None else [])


def window_faults(said, words, found):
    """Of the larger factors at which the line is said to be stable again, and of "not above"."""
    true = stretches(found)
    if true and "and not above" in words:
        return [f"not stable above, but stable again above {float(true[0][0].low)}"]
    if "stable_again" not in said or not said["first"]:
        return []
    printed = [(stretch["from"], stretch["to"]) for stretch in said["stable_again"]]
    if len(printed) != len(true):
        return [f"{len(printed)} stretches of renewed stability for {len(true)}"]
    for pair, ends in zip(printed, true):
        for text, event in zip(pair, ends):
            if (text is None) != (event is None) or text is not None and not lies(event, text):
                return [f"stable again {pair} for {tuple(e and float(e.low) for e in ends)}"]
    return []


def lies(event, text):
    low, high = interval(text)
    return low <= event.high and event.low <= high


# torques

def of_torque(statement, answer, tally):
    stiffness, load, balanced = torque.pencil(statement)
    if len(statement.loads) > 1 or not balanced:
        return against("a torque stands alone, and leaves the chain straight", answer)
    if integers.inertia(stiffness)[:2] != (0, 0):
        return against("it is not stable unloaded", answer)
    symmetric = load == integers.transposed(load)
    first = torque.first_static(stiffness, load)
    verdict = against(("" if first else "no torque bends it") or bent.why_singular(statement), answer)
    if verdict:
        return verdict
    chain, = answer.json()["chains"]
    low, high = interval(chain["torque"])
    tally.checked["torques"] += 1
    result = []
    if first[1] < low or high < first[0]:
        result.append(f"torque {chain['torque']} for {float(first[0])}")
    if chain["conservative"] != symmetric:
        result.append(f"conservative: {chain['conservative']}")
    return [(CERTIFIED, f) for f in result] or [("answered", "")]
