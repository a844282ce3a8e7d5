"""The questions: every verb on the repository's examples, generated chains and experiments, and on bad input."""

import dataclasses
import pathlib
import re

import inputs
from inputs import ROOT

# What differs between two runs of one program on one input, by the verb where it occurs. Nothing else may.
CHANCE = {
    "trial": {
        "salt of a seal": rb'(?<="salt": ")[0-9a-f]{32}(?=")',
        "seal": rb"\b[0-9a-f]{64}\b",
        "seconds, in JSON": rb'(?<="seconds": )(\{[^}]*\}|[-+.\de]+)',
        "seconds, in words": rb"(?<=Time of a diagnosis: )median .* s(?=\.)",
    },
}


@dataclasses.dataclass(frozen=True)
class Case:
    """One command and the files that it finds in its folder."""

    name: str
    arguments: list
    inputs: dict = dataclasses.field(default_factory=dict)


def without_chance(case, content):
    """What a program wrote, with the names of what depends on chance or time in its place."""
    verb = case.arguments[0] if case.arguments else ""
    for name, pattern in CHANCE.get(verb, {}).items():
        content = re.sub(pattern, f"<{name}>".encode(), content)
    return content


def case(name, command, files=None):
    return Case(name, command.split(), files or {})


def critical():
    for name, text in inputs.chain_files().items():
        file = f"{name}.toml"
        for how, options in {
            "lowest": "",
            "all": " --all --digits 30",
            "files": " --all --digits 15 --csv forces.csv --json forces.json --certify certificates.json",
        }.items():
            yield case(f"critical/{name}/{how}", f"critical {file}{options}", {file: text})
    lowest = {
        "lowest": "",
        "lowest-csv": " --csv",
        "json": " --json --digits 20",
        "certify": " --digits 40 --csv forces.csv --json forces.json --certify certificates.json",
    }
    every = {
        "all": " --all",
        "all-15": " --all --digits 15 --csv",
        "all-40": " --all --digits 40 --csv",
        "all-json": " --all --json",
        "certify-all": " --all --digits 15 --csv forces.csv --certify certificates.json",
    }
    for tables, ways in ((inputs.short_chain_tables(), lowest | every), (inputs.long_chain_tables(), lowest)):
        for name, text in tables.items():
            for how, options in ways.items():
                yield case(f"critical/{name}/{how}", f"critical {name}.csv{options}", {f"{name}.csv": text})
    yield case("critical/built-in/text", "critical")
    yield case("critical/built-in/json", "critical --json --digits 50")


def paths():
    for name, (text, load) in inputs.bent_chains().items():
        file = {f"{name}.toml": text}
        command = f"path {name}.toml {load}"
        yield case(f"path/{name}/text", command, file)
        yield case(f"path/{name}/files", f"{command} --csv path.csv --json path.json --svg path.svg", file)
        yield case(f"path/{name}/all", f"{command} --branches all --json path.json", file)
        yield case(f"path/{name}/digits", f"{command} --digits 50 --json path.json", file)
        yield case(f"path/{name}/certify", f"{command} --certify", file)
    yield case("path/built-in/default", "path")
    yield case("path/built-in/csv", "path --to 1.5 --csv")
    yield case("path/built-in/svg", "path --to 1.5 --svg")
    yield case("path/built-in/json", "path --to 1.5 --json")
    yield case("path/built-in/digits", "path --to 1.5 --digits 50")
    yield case("path/built-in/certify-all", "path --to 1.5 --branches all --certify --json certified.json")
    yield case("path/built-in/other-side", "path --to 0.5 --dy 0.1 --side -1")
    yield case("path/built-in/step", "path --to 1 --step 0.05 --csv")


def equilibria():
    for name, (text, load) in inputs.held_chains().items():
        file = {f"{name}.toml": text}
        command = f"equilibria {name}.toml {load}"
        yield case(f"equilibria/{name}/sampled", command, file)
        yield case(f"equilibria/{name}/certified", f"{command} --certify --digits 30 --json all.json", file)
    yield case("equilibria/built-in/default", "equilibria")
    yield case("equilibria/built-in/json", "equilibria --at 0.3,0.1 --json")
    yield case("equilibria/built-in/certified", "equilibria --end-point 3.4,0 --certify")
    yield case("equilibria/built-in/force", "equilibria --force -1,0.2 --certify")


def verify():
    yield case("verify/text", "verify")
    yield case("verify/json", "verify --json")
    yield case("verify/precise", "verify --json --precision 40")
    yield case("verify/page", "verify --html claims.html")
    yield case("verify/random", "verify --chains 200 --seed 1")
    yield case("verify/section", "verify --section 4.1 --json claims.json")
    yield case("verify/claim", "verify --claim z-no-exact-solution")


def figures():
    for number in (2, 10):
        yield case(f"figure/{number}", f"figure {number} --out figures")


def reference():
    yield case("reference/compact", "reference --compact --out set")
    yield case("reference/other-seed", "reference --compact --seed 7 --out set")


def check():
    for name, text in inputs.submitted_values().items():
        values = {f"{name}.csv": text}
        yield case(f"check/{name}/text", f"check {name}.csv", values)
        yield case(f"check/{name}/json", f"check {name}.csv --json", values)
    mine = {"chains.csv": b"chain,lengths,stiffness\nmine,1;1,0;1\n", "values.csv": b"chain,mode,force\nmine,1,2.000000000001\n"}
    yield case("check/own-chains", "check values.csv --chains chains.csv", mine)


def diagnose(folders):
    yield case("diagnose/built-in", "diagnose --next --json report.json --html page.html")
    yield case("diagnose/built-in-json", "diagnose --json")
    experiments = {"example": inputs.folder_files(ROOT / "docs/examples/experiment", "")}
    for folder in [inputs.SIMULATED, *folders]:
        experiments |= inputs.experiments_in(folder)
    for name, files in experiments.items():
        files = {f"bench/{file}": content for file, content in files.items()}
        yield case(f"diagnose/{name}/text", "diagnose bench", files)
        yield case(f"diagnose/{name}/files", "diagnose bench --next --json report.json --html page.html", files)


def trials():
    yield case("trial/made", "trial --trials 4 --seed 5 --patience 600 --out kept --json result.json --markdown result.md")
    labelled = inputs.experiments_in(inputs.SIMULATED, labels=True)
    files = {f"{name}/{file}": content for name, found in labelled.items() for file, content in found.items()}
    if files:
        options = "--patience 600 --json result.json --markdown result.md"
        yield case("trial/kept", f"trial --experiments simulated {options}", {f"simulated/{n}": c for n, c in files.items()})


def bad_input():
    for name, (command, files) in inputs.mistakes().items():
        yield case(f"errors/{name}", command, files)
    yield case("help/top", "")
    for verb in ("verify", "critical", "path", "equilibria", "figure", "reference", "check", "diagnose", "trial"):
        yield case(f"help/{verb}", f"{verb} --help")


def all_cases(folders):
    """Every case; the folders hold more experiments to diagnose. The long ones first, so that no core waits at the end."""
    groups = (reference(), verify(), trials(), paths(), equilibria(), diagnose(folders), critical(), figures(), check(), bad_input())
    return [one for group in groups for one in group]
