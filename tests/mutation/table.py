"""What was caught and what was not, in Markdown."""
import math


def folder(fault):
    return "the checkers in Python" if fault.path.endswith(".py") else fault.path.split("/")[0]


def sorted_out(faults, results):
    """Of these faults those that could be planted, that were caught, and that were not but are argued."""
    planted = [f for f in faults if not results[f.key].get("unplanted")]
    caught = [f for f in planted if results[f.key]["caught"]]
    return planted, caught, [f for f in planted if f.argued and not results[f.key]["caught"]]


def score(faults, results):
    """Per cent caught of the faults that could be planted and are not argued."""
    planted, caught, argued = sorted_out(faults, results)
    real = len(planted) - len(argued)
    return 100 * len(caught) / real if real else 100.0


def survivors(faults, results):
    """How many could be planted, were not caught, and are not argued."""
    planted, caught, argued = sorted_out(faults, results)
    return len(planted) - len(caught) - len(argued)


def survivors_allowed(faults, results, least):
    """How many may survive where this share, in per cent, is to be caught; one of few may, for a guess that leads to the same place
    later is no less right."""
    planted, _, argued = sorted_out(faults, results)
    return math.ceil((100 - least) / 100 * (len(planted) - len(argued)))


def one_line(text, limit=90):
    text = " ".join(text.split()).replace("|", "\\|")
    return text if len(text) <= limit else text[:limit - 3] + "..."


def table(faults, results):
    rows = ["| folder | faults | planted | caught | equivalent, argued | survived | score |", "|---|---|---|---|---|---|---|"]
    for kind, chosen in (("listed", [f for f in faults if f.listed]), ("generated", [f for f in faults if not f.listed])):
        for name in dict.fromkeys(sorted(map(folder, chosen))):
            here = [f for f in chosen if folder(f) == name]
            planted, caught, argued = sorted_out(here, results)
            rows.append(f"| {name} | {kind} {len(here)} | {len(planted)} | {len(caught)} | {len(argued)} | "
                        f"{survivors(here, results)} | {score(here, results):.0f} % |")
    rows += ["", "| what survived | change | why |", "|---|---|---|"]
    for fault in faults:
        result = results[fault.key]
        if result.get("unplanted") or result["caught"]:
            continue
        change = fault.what if fault.listed else f"{fault.what} in `{one_line(fault.before)}`"
        why = fault.argued or ("" if result["reached"] else "no test case comes by it")
        rows.append(f"| {fault.listed + ', ' if fault.listed else ''}{fault.path}:{fault.line} | {change} | {why} |")
    mute = [fault.listed for fault in faults if fault.listed and results[fault.key].get("unplanted")]
    if mute:
        rows += ["", f"Listed, and not planted, for they do not compile here: {', '.join(mute)}."]
    return "\n".join(rows) + "\n"
