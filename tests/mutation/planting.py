"""Many faults in one build: every place holds the right text and the wrong ones, and a process chooses by a number."""
import os
import re


def head(path):
    """The line that every planted file begins with; not every target knows the project's root."""
    return f'#include "{os.path.relpath("tests/mutation/planted.hpp", os.path.dirname(path))}"\n'


def nested(faults):
    """The faults as a tree by what holds what: [(fault, children)], those on the same text under one another. A fault that
    overlaps an earlier one without holding it is left out and given back second."""
    roots, left_out, stack = [], [], []
    for fault in sorted(faults, key=lambda f: (f.begin, -f.end, f.key)):
        while stack and stack[-1][0].end <= fault.begin:
            stack.pop()
        if stack and fault.end > stack[-1][0].end:
            left_out.append(fault)
            continue
        node = (fault, [])
        (stack[-1][1] if stack else roots).append(node)
        stack.append(node)
    return roots, left_out


def rendered(path, text, faults, number):
    """The text of a file with all faults as choices, which lines of it are whose, and what could not be held; number gives a
    fault's number."""
    roots, left_out = nested(faults)
    out, owners = [head(path)], {}

    def put(piece):
        out.append(piece)

    def line():
        return sum(piece.count("\n") for piece in out) + 1

    def span(begin, end, nodes):
        for fault, children in nodes:
            put(text[begin:fault.begin])
            choice(fault, children)
            begin = fault.end
        put(text[begin:end])

    def choice(fault, children):
        planted = f"::mutation::planted({number(fault)})"
        opening, between, closing = (f"\n{{ if ({planted}) {{\n", "\n} else {\n", "\n} }\n") if fault.statement else \
            (f"\n({planted} ? (\n", ") : (\n", "))\n")
        first = line() + 1
        put(opening)
        put(fault.after)
        put(between)
        for owned in range(first, line() + 1):
            owners.setdefault(owned, fault)
        span(fault.begin, fault.end, children)
        put(closing)

    span(0, len(text), roots)
    return "".join(out), owners, left_out


def culprits(errors, owners):
    """The faults that these messages of the compiler are about; owners gives, for each planted file, whose its lines are. Where
    an error stands on no fault's line, as in a template that is right, that one is taken from whose line it was reached last; where
    there is none, those beside it, but only where no error is laid to a fault of its own."""
    found, beside, way = set(), set(), []

    def at(places, reach=0):
        return {owners[path][n].key for path, line in places for n in range(line - reach, line + reach + 1) if n in owners[path]}

    for row in errors.splitlines():
        match = re.match(r"(\S+?):(\d+):(?:\d+:)?\s+(required from|in .constexpr. expansion|(?:fatal )?error)", row)
        if match is None:
            if re.search(r": In |^In file included", row):
                way = []
            continue
        here = [(path, int(match[2])) for path in owners if match[1].endswith(f"/{path}")]
        if match[3].endswith("error"):
            own = next(filter(None, (at([place]) for place in here + way)), set())
            found |= own
            if not own:
                beside |= at(here + way, reach=12)
        else:
            way += here
    return found or beside  # what stands beside is asked again once the others are gone
