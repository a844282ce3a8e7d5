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


def culprits(errors, path, owners, faults):
    """Of the faults in the file at `path` those that these messages of the compiler are about."""
    lines = [int(n) for n in re.findall(re.escape(path) + r":(\d+):\d+: (?:fatal )?error", errors)]
    lines += [int(n) for n in re.findall(re.escape(path) + r":(\d+):\d+:\s+(?:required from|in .constexpr. expansion)", errors)]
    found = [owners[line] for line in lines if line in owners]
    if not found:  # near it: the faults of the next lines before
        for line in lines:
            near = [n for n in owners if line - 12 <= n <= line + 12]
            found += [owners[n] for n in near]
    return {fault.key for fault in found}
