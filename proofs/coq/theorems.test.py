"""theorems.md and README.md name what Coq has checked: every theorem of the first has a row that names its proofs in Coq or
says that it is on paper only, every name is one that Coq has checked, none is left out, and the counts are right. The parts of a
theorem stand between semicolons: it is checked in full where each of them has a name that Coq has exported.

usage: theorems.test.py ASSUMPTIONS THEOREMS README     (ASSUMPTIONS: what check.py wrote)
"""
import re
import sys

ON_PAPER = "on paper only"


def rows(text, heading):
    """The cells of the table under a heading."""
    part = text.split(f"\n## {heading}\n", 1)[1].split("\n## ", 1)[0]
    table = [line.strip("|").split("|") for line in part.splitlines() if line.startswith("|")]
    return [[cell.strip() for cell in cells] for cells in table[2:]]


def names(cell):
    return set(re.findall(r"`(\w+\.\w+)`", cell))


def main():
    with open(sys.argv[1], encoding="utf-8") as file:
        checked = {line.split(":")[0] for line in file}
    with open(sys.argv[2], encoding="utf-8") as file:
        theorems = file.read()
    with open(sys.argv[3], encoding="utf-8") as file:
        readme = file.read()
    wrong = []
    headings = re.findall(r"^## (.+)$", theorems, re.MULTILINE)
    proved = headings[headings.index("Notation") + 1:]
    status = {row[0]: row[1] for row in rows(theorems, "What a proof assistant has checked")}
    wrong += [f"{heading}: occurs twice" for heading in set(proved) if proved.count(heading) > 1]
    wrong += [f"{name}: no row in theorems.md" for name in proved if name not in status]
    wrong += [f"{name}: a row in theorems.md, no theorem" for name in status if name not in proved + ["Notation"]]
    for name, cell in status.items():
        if not names(cell) and cell != ON_PAPER:
            wrong.append(f"{name}: neither a name in Coq nor '{ON_PAPER}'")
        wrong += [f"{name}: {other} is not checked" for other in names(cell) - checked]
    full = [name for name in proved if all(names(part) for part in status.get(name, "").split(";"))]
    part = [name for name in proved if names(status.get(name, "")) and name not in full]
    wrong += [f"{name}: '{part.strip()}' has no name in Coq and does not say '{ON_PAPER}'" for name in part
              for part in status[name].split(";") if not names(part) and ON_PAPER not in part]
    count = (f"Of {len(proved)} theorems {len(full)} are machine-checked in full, {len(part)} in part, "
             f"{len(proved) - len(full) - len(part)} are on paper only.")
    if count not in " ".join(theorems.split()):
        wrong.append(f"theorems.md does not say: {count}")
    listed = set().union(*(names(row[0]) for row in rows(readme, "What is proved")))
    wrong += [f"{name}: checked, not in README.md" for name in sorted(checked - listed)]
    wrong += [f"{name}: in README.md, not checked" for name in sorted(listed - checked)]
    for item in wrong:
        print(item)
    print(f"{len(checked)} names in Coq; {count}")
    sys.exit(bool(wrong))


main()
