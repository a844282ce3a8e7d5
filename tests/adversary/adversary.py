"""Attacks `critical`, `path` and `equilibria` with random structures, and judges every answer by mechanics of its own.

    adversary.py PLUMBLINE [--structures 2000] [--seed 1] [--kinds dead,follower,...] [--keep FOLDER] [--seconds 8]
                 [--table RESULTS.md]
    adversary.py PLUMBLINE --files CHAIN.toml ...

Prints a line for each bad answer, then the table; exit status 1 if there was one. RESULTS.md takes the table between its marks of that
seed. Nothing here is shared with the program: structures are read from their chain files anew, assembled from the energy of turned links,
and decided with integers.
"""
import argparse
import sys

import judge_bent
import judge_straight
from draw import Draw, toml
from program import Program
from tally import Tally

# of a hundred structures so many are of a kind
SHARES = {"dead": 20, "follower": 12, "touching": 8, "space_dead": 12, "torque": 6, "census": 14, "path": 10, "path_in_space": 8, "ill": 10}


def judged(program, kind, draw, text, tally):
    digits = draw.random.choice([1, 3, 5, 8, 12, 15, 15, 20, 30, 50])
    factor = draw.random.choice(["0.3", "1", "1", "2.5"])
    if kind == "census":
        return judge_bent.equilibria(program, text, tally, factor, 80, draw.random.randint(0, 10 ** 9))
    if kind == "path":
        return judge_bent.paths(program, text, tally, factor)
    if kind == "path_in_space":
        return judge_bent.paths(program, text, tally, factor) + judge_bent.equilibria(program, text, tally, factor, 0, 0)
    if kind == "ill" and draw.chance(0.5):
        return judge_bent.paths(program, text, tally, factor)
    return judge_straight.critical(program, text, tally, digits)


def attack(program, structures, seed, kinds, keep):
    tally = Tally(keep)
    for kind in kinds:
        share = sum(SHARES[k] for k in kinds)
        for number in range(max(1, structures * SHARES[kind] // share)):
            draw = Draw(seed, f"{kind}/{number}")
            text = toml(getattr(draw, kind)())
            tally.add(kind, number, text, judged(program, kind, draw, text, tally))
    return tally


def attack_with(program, files):
    """Every verb on given structures, such as those that were kept."""
    tally = Tally()
    for name in files:
        with open(name, encoding="utf-8") as file:
            text = file.read()
        for digits in (5, 15):
            tally.add("critical", name, text, judge_straight.critical(program, text, tally, digits))
        tally.add("path", name, text, judge_bent.paths(program, text, tally, "1"))
        tally.add("equilibria", name, text, judge_bent.equilibria(program, text, tally, "1", 80, 1))
    return tally


def write_between_marks(path, seed, text):
    begin, end = f"<!-- seed {seed} -->", f"<!-- end of seed {seed} -->"
    with open(path, encoding="utf-8") as file:
        before, rest = file.read().split(begin)
    with open(path, "w", encoding="utf-8") as file:
        file.write(f"{before}{begin}\n{text}\n{end}{rest.split(end)[1]}")


def main():
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("plumbline")
    arguments.add_argument("--structures", type=int, default=2000)
    arguments.add_argument("--seed", default="1")
    arguments.add_argument("--kinds", default=",".join(SHARES))
    arguments.add_argument("--keep")
    arguments.add_argument("--seconds", type=int, default=8)
    arguments.add_argument("--table")
    arguments.add_argument("--files", nargs="+")
    asked = arguments.parse_args()
    program = Program(asked.plumbline, asked.seconds)
    if asked.files:
        tally = attack_with(program, asked.files)
    else:
        tally = attack(program, asked.structures, asked.seed, asked.kinds.split(","), asked.keep)
    print(tally.table())
    if asked.table:
        write_between_marks(asked.table, asked.seed, tally.table())
    return 1 if tally.bad else 0


if __name__ == "__main__":
    sys.exit(main())
