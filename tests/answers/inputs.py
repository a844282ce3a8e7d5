"""What the cases are asked about: examples of the repository, chains drawn from a seeded generator, experiments, mistakes.

Everything is the same at every call and on every machine: of Python's random numbers only `Random.random` is used, which is
promised to stay.
"""

import math
import pathlib
import random

ROOT = pathlib.Path(__file__).resolve().parents[2]
SIMULATED = ROOT / "tests/experiments"


class Draw:
    """Random decimals, as text: what is written is meant to the last digit."""

    def __init__(self, seed):
        self.next = random.Random(seed).random

    def whole(self, low, high):
        return low + int(self.next() * (high - low + 1))

    def between(self, low, high, digits=4):
        return f"{low + (high - low) * self.next():.{digits}g}"

    def graded(self, decades):
        return f"{10 ** (decades * (2 * self.next() - 1)):.3g}"


def folder_files(folder, prefix, hidden=()):
    """The files below a folder, by name."""
    return {
        prefix + path.relative_to(folder).as_posix(): path.read_bytes()
        for path in sorted(folder.rglob("*"))
        if path.is_file() and path.name not in hidden
    }


def experiments_in(folder, labels=False):
    """Every experiment below a folder: name -> files. A label is not shown unless asked for."""
    hidden = () if labels else ("label.json",)
    found = {}
    for toml in sorted(folder.rglob("experiment.toml")):
        found[toml.parent.name] = folder_files(toml.parent, "", hidden)
    return found


def toml(lengths, stiffness, rest=None):
    lines = [f"{key} = [{', '.join(values)}]" for key, values in (("lengths", lengths), ("stiffness", stiffness), ("rest", rest)) if values]
    return ("\n".join(lines) + "\n").encode()


def chain_files():
    """Straight chains of the examples, a file each, and some of ours."""
    files = {path.stem: path.read_bytes() for path in sorted((ROOT / "docs/examples").glob("*.toml"))}
    draw = Draw(11)
    for links in (2, 5, 9):
        files[f"random-{links}"] = toml([draw.between(0.1, 3) for _ in range(links)], [draw.between(0.1, 9) for _ in range(links)])
    files["passive-base"] = toml(["0.4", "0.3", "0.3"], ["0", "2.5", "1.25"])
    return files


def drawn_chains():
    """Name, lengths, stiffness of straight chains of many kinds."""
    draw = Draw(20)
    for i in range(120):
        n = draw.whole(2, 10)
        yield f"decimals-{i}", [draw.between(0.1, 5) for _ in range(n)], [draw.between(0.1, 50) for _ in range(n)]
    for i in range(60):
        n = draw.whole(2, 30)
        decades = draw.whole(1, 8)
        yield f"graded-{i}", [draw.graded(decades) for _ in range(n)], [draw.graded(decades) for _ in range(n)]
    for i in range(60):
        n = draw.whole(3, 9)
        stiffness = [draw.between(0.1, 9, 3) for _ in range(n)]
        stiffness[draw.whole(0, n - 1)] = "0"
        if i % 3 == 0:
            stiffness[0] = "0"
        yield f"passive-{i}", [draw.between(0.1, 5, 3) for _ in range(n)], stiffness
    for n in range(2, 32):
        yield f"equal-{n}", ["1"] * n, ["1"] * n
        yield f"equal-pinned-{n}", ["0.25"] * n, ["0"] + ["2"] * (n - 1)
    for i in range(20):
        n = draw.whole(2, 12)
        yield f"equal-links-{i}", ["0.3"] * n, [draw.between(0.5, 2, 2) for _ in range(n)]
    for n in (40, 60):
        yield f"long-{n}", [draw.between(0.5, 2, 3) for _ in range(n)], [draw.between(0.5, 2, 3) for _ in range(n)]


def short_chain_tables():
    """Tables of straight chains of which all modes are wanted: the example's, and several hundred drawn ones."""
    rows = [f"{name},{';'.join(lengths)},{';'.join(stiffness)}\n" for name, lengths, stiffness in drawn_chains()]
    return {
        "examples": (ROOT / "docs/examples/chains.csv").read_bytes(),
        "drawn": ("chain,lengths,stiffness\n" + "".join(rows)).encode(),
    }


def long_chain_tables():
    """Tables of chains of up to a thousand links: the lowest mode takes no time, all take minutes."""
    return {"reference": (ROOT / "verify/reference/values/chains.csv").read_bytes()}


PAPER_TWO = toml(["1", "1"], ["0", "1"])
PAPER_ZIGZAG = toml(["1", "1", "1"], ["0", "1", "1"], ["0", "0.31415926535", "-0.31415926535"])
PAPER_Z = toml(["1"] * 4, ["1"] * 4, ["-0.2417", "0.6821", "-0.7958", "0.5170"])
PAPER_U = toml(["1"] * 4, ["1"] * 4, ["-0.3", "0.2", "0.2", "0.2"])
STRAIGHT = toml(["1"] * 4, ["1"] * 4)


def drawn_bent_chain(draw, links):
    return toml([draw.between(0.5, 1.5, 3) for _ in range(links)], [draw.between(0.5, 2, 3) for _ in range(links)],
                [draw.between(-0.6, 0.6, 3) for _ in range(links)])


def bent_chains():
    """Chains to be loaded along a path: name -> (file, load)."""
    chains = {
        "two-link": (PAPER_TWO, "--to 0.5"),
        "zigzag": (PAPER_ZIGZAG, "--to 0.3"),
        "z": (PAPER_Z, "--to 1.5"),
        "z-force": (PAPER_Z, "--force -1.2,0.1"),
        "u": (PAPER_U, "--to 1 --dy 0.1"),
        "straight": (STRAIGHT, "--to 0.5"),
        "straight-force": (STRAIGHT, "--force -1.5,0"),
    }
    draw = Draw(31)
    for links in (2, 3, 3, 4, 4, 5):
        number = len(chains)
        chains[f"bent-{number}-of-{links}"] = (drawn_bent_chain(draw, links), f"--to {draw.between(0.2, 0.8, 2)}")
        chains[f"pressed-{number}-of-{links}"] = (
            drawn_bent_chain(draw, links), f"--force -{draw.between(0.2, 0.8, 2)},{draw.between(-0.3, 0.3, 2)}")
    return chains


def held_chains():
    """Chains of which all equilibria are wanted: name -> (file, load)."""
    chains = {
        "two-link": (PAPER_TWO, "--end-point 1.6,0"),
        "zigzag": (PAPER_ZIGZAG, "--at 0.2,0"),
        "z": (PAPER_Z, "--at 0.5,0"),
        "z-force": (PAPER_Z, "--force -0.8,0.1"),
        "u": (PAPER_U, "--at 0.6,0.1"),
    }
    draw = Draw(41)
    for links in (2, 2, 3, 3, 4):
        number = len(chains)
        chains[f"held-{number}-of-{links}"] = (
            drawn_bent_chain(draw, links), f"--at {draw.between(0.2, 0.6, 2)},{draw.between(-0.2, 0.2, 2)}")
        chains[f"forced-{number}-of-{links}"] = (
            drawn_bent_chain(draw, links), f"--force -{draw.between(0.2, 1, 2)},{draw.between(-0.3, 0.3, 2)}")
    return chains


def submitted_values():
    """Critical forces as another implementation would hand them in, right and wrong in several ways."""
    rows = [line.split(",")[:3] for line in (ROOT / "verify/reference/values/forces.csv").read_text().splitlines()[1:]]
    draw = Draw(51)

    def table(change):
        return ("chain,mode,force\n" + "".join(f"{chain},{mode},{change(float(force))!r}\n" for chain, mode, force in rows)).encode()

    return {
        "doubles": table(lambda force: force),
        "last-bits": table(lambda force: math.nextafter(force, math.inf)),
        "single": table(lambda force: float(f"{force:.7g}")),
        "some-wrong": table(lambda force: force * (1 + 1e-9) if draw.next() < 0.1 else force),
        "doubled": table(lambda force: 2 * force),
    }


def broken_experiments():
    """The bundled example, broken in one place each: name -> files."""
    good = folder_files(ROOT / "docs/examples/experiment", "bench/")

    def altered(file, old, new):
        text = good[f"bench/{file}"].decode()
        if old not in text:
            raise ValueError(f"the example has no '{old}' any more")
        return good | {f"bench/{file}": text.replace(old, new, 1).encode()}

    header = good["bench/u-press.csv"].decode().splitlines()[0]
    return {
        "format": altered("experiment.toml", "chain-experiment/1", "chain-experiment/9"),
        "key": altered("experiment.toml", "[bench]", "[bench]\ncolour = 1"),
        "no-noise": altered("experiment.toml", "[noise]", "[noises]"),
        "plane": altered("experiment.toml", '"horizontal"', '"tilted"'),
        "control": altered("experiment.toml", '"displacement"', '"torque"'),
        "twice": altered("experiment.toml", 'id = "u-again"', 'id = "u-press"'),
        "no-samples": altered("experiment.toml", '"u-press.csv"', '"nowhere.csv"'),
        "outside": altered("experiment.toml", '"u-press.csv"', '"../u-press.csv"'),
        "syntax": altered("experiment.toml", "[bench]", "[bench"),
        "header": altered("u-press.csv", header, header + ",colour"),
        "header-alone": good | {"bench/u-press.csv": (header + "\n").encode()},
        "empty": good | {"bench/u-press.csv": b""},
        "word": good | {"bench/u-press.csv": (header + "\n" + ",".join(["word"] * (header.count(",") + 1)) + "\n").encode()},
    }


def mistakes():
    """Bad input of every verb: name -> (command, files)."""
    table = b"chain,lengths,stiffness\na,1;1,1;1\n"
    chain = {"c.toml": toml(["1", "1"], ["1", "1"])}
    chains = {
        "no-lengths": b"stiffness = [1, 1]\n",
        "unequal": toml(["1", "1"], ["1"]),
        "negative": toml(["1", "-1"], ["1", "1"]),
        "one-link": toml(["1"], ["1"]),
        "all-passive": toml(["1", "1"], ["0", "0"]),
        "infinite": toml(["1", "inf"], ["1", "1"]),
        "words": b'lengths = ["one", "two"]\nstiffness = [1, 1]\n',
        "syntax": b"lengths = [1, 1\n",
        "empty": b"",
        "bent": toml(["1", "1"], ["1", "1"], ["0", "0.1"]),
        "rest-length": toml(["1", "1"], ["1", "1"], ["0.1"]),
        "not-text": bytes(range(200, 256)),
    }
    found = {}
    for name, text in chains.items():
        for verb in ("critical", "path", "equilibria"):
            found[f"{verb}-{name}"] = (f"{verb} c.toml", {"c.toml": text})
    for name, text in {
        "header": b"name,lengths,stiffness\na,1;1,1;1\n",
        "header-alone": b"chain,lengths,stiffness\n",
        "empty": b"",
        "some-wrong": table + b"b,1;x,1;1\na,1;1,1;2\nc,1;1,0;0\nd,1;1\ne,2;1,1;3\n",
    }.items():
        found[f"critical-table-{name}"] = ("critical c.csv --csv", {"c.csv": text})
    values = b"chain,mode,force\npaper-two-link,1,2\n"
    for name, text in {
        "header": b"chain,mode\npaper-two-link,1\n",
        "header-alone": b"chain,mode,force\n",
        "chain": values.replace(b"two", b"no"),
        "mode": values.replace(b",1,", b",7,"),
        "mode-0": values.replace(b",1,", b",0,"),
        "word": values.replace(b",2\n", b",two\n"),
        "nan": values.replace(b",2\n", b",nan\n"),
        "again": values + b"paper-two-link,1,2\n",
        "fields": values + b"paper-two-link,1\n",
    }.items():
        found[f"check-{name}"] = ("check v.csv", {"v.csv": text})
    for name, files in broken_experiments().items():
        found[f"diagnose-{name}"] = ("diagnose bench", files)
    for name, command in {
        "no-verb": "nonsense",
        "critical-nowhere": "critical nowhere.toml",
        "critical-ending": "critical c.txt",
        "critical-folder": "critical .",
        "critical-digits": "critical --digits 0",
        "critical-word": "critical --digits ten",
        "critical-option": "critical --colour",
        "critical-itself": "critical c.toml --csv c.toml",
        "critical-no-folder": "critical --csv no/where.csv",
        "path-nothing": "path --to 0",
        "path-both": "path --to 1 --force -1,0",
        "path-one": "path --force -1",
        "path-word": "path --force a,b",
        "path-far": "path c.toml --to 9",
        "path-branches": "path --branches some",
        "path-step": "path --step 3",
        "path-axis": "path c.toml --force -1,0.1 --branches all",
        "equilibria-both": "equilibria --at 0.1,0 --end-point 1,0",
        "equilibria-out-of-reach": "equilibria --end-point 9,0 --certify",
        "equilibria-word": "equilibria --at x,y",
        "figure-1": "figure 1",
        "figure-word": "figure one",
        "reference-nowhere": "reference --compact",
        "verify-claim": "verify --claim nonsense",
        "verify-section": "verify --section 9.9",
        "verify-both": "verify --claim eq-16 --section 4.1",
        "verify-precision": "verify --precision 51",
        "check-nothing": "check",
        "check-nowhere": "check nowhere.csv",
        "diagnose-nowhere": "diagnose nowhere",
        "diagnose-file": "diagnose c.toml",
        "trial-nowhere": "trial --experiments nowhere",
        "trial-empty": "trial --experiments .",
        "trial-none": "trial --trials 0",
    }.items():
        found[name] = (command, chain)
    return found
