"""The keys of the input formats: those that the program reads are those of the schemas, of which docs/reference.py makes a page.

usage: input_formats.test.py PLUMBLINE

What the program reads is asked of the program: an unknown key makes it list the known ones, and a key that is left out
is refused where it is required.
"""
import json
import re
import shutil
import tempfile
import tomllib
from pathlib import Path

from jsonschema import Draft202012Validator

from documents import ROOT, SCHEMAS, blocks, tables
from program import complaint

EXPERIMENTS, CHAINS = ROOT / "docs" / "experiment-format.md", ROOT / "docs" / "chain-format.md"
USER_EFFECTS, REFERENCE = ROOT / "docs" / "user-effects.md", ROOT / "docs" / "reference.md"
TABLES = ["Top level", "[nominal]", "[[nominal.effect]]", "[[nominal.torque_law]]", "[bench]", "[[load]]", "[noise]", "[units]", "[csv]", "[columns]", "[[run]]"]


def documented(path, heading):
    """The keys in the first table under a heading, and those whose meaning begins with "required"."""
    rows = [(set(re.findall(r"`([^`]+)`", row[0])), row[1]) for row in tables(path)[heading][0][1:]]
    return set().union(*(names for names, _ in rows)), set().union(*(names for names, said in rows if said.startswith("required")))


def schema_of(name):
    schema = json.loads((SCHEMAS / f"{name}.schema.json").read_text(encoding="utf-8"))
    Draft202012Validator.check_schema(schema)
    return schema


# Every key of the format, and a commanded end point out of reach: what is wrong with it is found after every key is read.
EXPERIMENT = {
    "format": "chain-experiment/1", "name": "all keys", "date": "2026-03-01",
    "nominal": {"link_length": [0.3, 0.2], "joint_stiffness": [2.0, 1.5], "link_mass": [0.1, 0.1],
                "gravity": [0.0, -9.81], "rest": [0.4, -0.9],
                "effect": [{"id": "backlash", "joint": 2, "parameters": {"b": 0.02}}],
                "torque_law": [{"joint": 1, "deflection": [-0.1, 0.1], "torque": [0.0, 0.02],
                                "sliders": [{"slips_at": 0.01, "torque": 0.02}, {"slips_at": 0.02, "growth": 0.1},
                                            {"slips_at": 0.03, "deflection": [-0.1, 0.1], "torque": [0.01, -0.02]}],
                                "arms": [{"time_constant": 3.0, "stiffness": 0.2}]}]},
    "bench": {"gravity_plane": "vertical", "gravity_direction": [0.0, -1.0]},
    "load": [{"force": ["Gx", "Gy"], "link": 1, "at": 0.5}, {"tendon": "tension", "radius": [0.01, 0.008]},
             {"pressure": "p", "volume": [1e-6, 0.0]}],
    "noise": {"x": 0.001, "y": 0.001, "Fx": 0.02, "Fy": 0.02, "Fx_2": 0.02, "Fy_2": 0.02, "q": 0.001, "tilt": 0.001},
    "units": {"link_length": "m", "joint_stiffness": "N m/rad", "link_mass": "kg", "gravity": "m/s^2", "rest": "rad",
              "radius": "mm", "volume": "mm^3"},
    "csv": {"delimiter": ",", "decimal": ".", "header": True, "transposed": False, "skip_lines": 0, "skip_after_header": 0, "comment": "#",
            "missing": ["NaN"]},
    "columns": {"t": "t", "x": "x", "y": 3, "Fx": {"column": "Fx", "unit": "N", "sign": 1, "zero": 0},
                "Fy": {"constant": 0}, "Fx_2": {"constant": 0}, "Fy_2": {"constant": 0, "unit": "N"}, "tilt": ["L1", "L2"], "q": {"column": ["q1", 7], "unit": "rad", "sign": [1, 1], "zero": [0, 0],
                                             "absolute": False},
                "q_command": {"column": ["c1", "c2"], "unit": "rad", "sign": -1, "zero": [0, 0], "absolute": False},
                "covariate": {"temperature": {"column": "T", "sign": 1, "zero": 20}, "p": {"column": "P", "unit": "kPa"}}},
    "run": [{"id": "press", "control": "displacement", "begins": "relaxed", "loaded_by": "servo", "rest": [0.4, -0.9], "samples": "press.csv",
             "csv": {"decimal": "."}, "columns": {"Fx": {"zero": "first"}, "q": ["q1", "q2"]}}],
}
SAMPLES = "t,x,y,Fx,Fy,q1,q2,T,Gx,Gy,tension,P,L1,L2\n0,9,0,0,0,0,0,20,0,0,0,0,0,0\n1,9,0,0,0,0,0,20,0,0,1,1,0,0\n"
# Where a unit of the kind can stand, and what makes it one.
UNITS = {"length": ("link_length", ""), "torque": ("joint_stiffness", "/rad"), "mass": ("link_mass", ""),
         "angle": ("rest", ""), "force": ("joint_stiffness", " m/rad"), "pressure": ("joint_stiffness", " m^3/rad"), "duration": ("gravity", "^2"),
         "picture": ("link_length", " m/px")}


def toml(value):
    """A list and a text are written in TOML as in JSON; a table stands in its line."""
    if isinstance(value, dict):
        return "{ " + ", ".join(f"{key} = {toml(entry)}" for key, entry in value.items()) + " }"
    if isinstance(value, list):
        return "[" + ", ".join(toml(entry) for entry in value) + "]"
    return json.dumps(value)


def toml_file(table):
    return "".join(f"{key} = {toml(value)}\n" for key, value in table.items())


def experiment_fault(folder, experiment, samples=SAMPLES):
    (folder / "experiment.toml").write_text(toml_file(experiment), encoding="utf-8")
    (folder / "press.csv").write_text(samples, encoding="utf-8")
    return complaint("diagnose", ".", folder=folder)


def changed(heading, change):
    """The experiment with one of its tables changed."""
    copy = json.loads(json.dumps(EXPERIMENT))
    name = heading.strip("[]")
    places = {"run": copy["run"][0], "nominal.effect": copy["nominal"]["effect"][0],
              "nominal.torque_law": copy["nominal"]["torque_law"][0], "load": copy["load"][0]}
    change(places[name] if name in places else copy.get(name, copy))
    return copy


def experiments(folder):
    schema = schema_of("experiment")
    Draft202012Validator(schema).validate(EXPERIMENT)
    assert "from the base" in experiment_fault(folder, EXPERIMENT)
    for heading in TABLES:
        node = {"Top level": schema, **{f"[{name}]": schema["$defs"][name] for name in ("csv", "columns")},
                "[[run]]": schema["$defs"]["run"],
                "[[load]]": schema["$defs"]["load"], "[[nominal.effect]]": schema["$defs"]["effect"],
                "[[nominal.torque_law]]": schema["$defs"]["torque_law"]}.get(heading)
        node = node or schema["properties"][heading.strip("[]")]
        named, required = set(node["properties"]), set(node.get("required", []))
        fault = experiment_fault(folder, changed(heading, lambda table: table.update(zz=1)))
        known = re.search(r"an unknown key, expected one of (.*)", fault)
        assert known and set(known[1].split()) == named, f"{heading}: the schema names {named}; {fault}"
        for key in named:
            without = changed(heading, lambda table, key=key: table.pop(key, None))
            assert ("no such key" in experiment_fault(folder, without)) == (key in required), f"{heading} {key}"
            assert Draft202012Validator(schema).is_valid(without) == (key not in required), f"schema, {heading} {key}"
    column_keys(folder, schema)
    units(folder)
    columns, required = documented(EXPERIMENTS, "Sample files")
    plain = changed("[[run]]", lambda run: run.pop("columns"))
    plain.pop("columns"), plain.pop("load")
    header = re.findall(r"'(t,[^']*)'", experiment_fault(folder, plain, "zz\n0\n"))
    assert set(header[0].split(",")) == required, header
    assert {name for name in header[1].split(",") if name != "q2"} == columns, header


def column_keys(folder, schema):
    """The keys of a column, of q and of the others."""
    read, shown = set(), set()
    for channel in ("x", "q"):
        fault = experiment_fault(folder, changed("[columns]", lambda table, at=channel: table.update({at: {"zz": 1}})))
        read |= set(re.search(r"an unknown key, expected one of (.*)", fault)[1].split())
    for node in (schema["$defs"]["column"], schema["$defs"]["angles"]):
        shown |= set(node["anyOf"][1]["properties"])
    assert read == shown, (read, shown)


def units(folder):
    """Every symbol of the reference is one that the program reads."""
    for kind, symbols in tables(REFERENCE)["Symbols of units"][0][1:]:
        key, suffix = UNITS[kind]
        for symbol in re.findall(r"`([^`]+)`", symbols):
            unit = f"m/{symbol}^2" if kind == "duration" else symbol + suffix
            fault = experiment_fault(folder, changed("[units]", lambda table, u=unit, k=key: table.update({k: u})))
            assert "a unit of" not in fault, fault


def repository_experiments():
    chains, arms = (Draft202012Validator(schema_of(name)) for name in ("experiment", "arm-experiment"))
    found = [path for path in ROOT.glob("**/experiment.toml") if not path.relative_to(ROOT).parts[0].startswith("build")]
    assert found
    labels = Draft202012Validator(schema_of("label"))
    for path in found:
        settings = tomllib.loads(path.read_text(encoding="utf-8"))
        if settings["format"] in ("motion/1", "torque/1"):
            Draft202012Validator(schema_of(settings["format"].replace("/1", "-experiment"))).validate(settings)
            continue
        (arms if "arm" in settings else chains).validate(settings)
        if (path.parent / "label.json").exists():
            labels.validate(json.loads((path.parent / "label.json").read_text(encoding="utf-8")))


def motions(folder):
    """Each table of a log of motion, and of one of torques, refuses a key of its own, and names those of the schema."""
    shutil.copytree(ROOT / "docs/examples/servo-log", folder / "servo-log")
    servo = tomllib.loads((ROOT / "docs/examples/servo-log/experiment.toml").read_text(encoding="utf-8"))
    torques = {"format": "torque/1", "name": "torques", "model": {"file": "servo.xml"}, "logs": {"files": ["a.csv"]},
               "columns": {"position": ["q"], "torque": ["tau"]}}
    for name, settings in (("motion-experiment", servo), ("torque-experiment", torques)):
        schema = schema_of(name)
        Draft202012Validator(schema).validate(settings)
        for table in (None, *(key for key, node in schema["properties"].items() if "properties" in node)):
            copy = json.loads(json.dumps(settings))
            (copy if table is None else copy.setdefault(table, {})).update(zz=1)
            (folder / "servo-log" / "experiment.toml").write_text(toml_file(copy), encoding="utf-8")
            node = schema if table is None else schema["properties"][table]
            fault = complaint("diagnose", "servo-log", folder=folder)
            known = re.search(r"an unknown key, expected one of (.*)", fault)
            assert known and set(known[1].split()) == set(node["properties"]), f"{name} {table}: {fault}"


def chains(folder):
    named, required = documented(CHAINS, "A chain: TOML")
    chain = {"lengths": [1, 1], "stiffness": [1, 1], "rest": [0.1, 0.1]}
    assert set(chain) < named

    def fault(table):
        (folder / "chain.toml").write_text(toml_file(table), encoding="utf-8")
        return complaint("critical", "chain.toml", folder=folder)

    known = re.search(r"expected one of (.*)", fault({**chain, "zz": 1}))
    # `joints` stand in the place of stiffness and rest
    assert known and set(known[1].split()) == named - {"joints"}, known
    for key in chain:
        left = {name: value for name, value in chain.items() if name != key} | ({"rest": [1, 1]} if key != "rest" else {})
        if key in required:
            assert f"no key {key}" in fault(left), key
    (folder / "three.toml").write_text(toml_file({"lengths": [1, 1, 1], "stiffness": [1]}), encoding="utf-8")
    complaint("critical", "three.toml", folder=folder)


def tables_of_chains(folder):
    (folder / "wrong.csv").write_text("zz\n1\n", encoding="utf-8")
    of_chains, of_forces = [block.text.split("\n", 1)[0] for block in blocks(CHAINS) if block.language == "csv"]
    assert f"expected {of_chains}" in complaint("critical", "wrong.csv", folder=folder)
    assert f"the columns {of_forces}" in complaint("check", "wrong.csv", folder=folder)


def user_effects(folder):
    """The three tables of a file of effects, each changed in every key."""
    schema = schema_of("user-effects")
    validator = Draft202012Validator(schema)
    parameter = {"unit": "N m", "scale": 1, "low": -1, "high": 1}
    effect = {"id": "mine", "words": "mine", "where": "every joint", "torque": "a * d", "parameters": {"a": parameter}}
    tables_of = {"Top level": (schema, lambda file: file), "[[effect]]": (schema["$defs"]["effect"], lambda file: file["effect"][0]),
                 "[effect.parameters.NAME]": (schema["$defs"]["parameter"], lambda file: file["effect"][0]["parameters"]["a"])}

    def changed_file(heading, change):
        file = json.loads(json.dumps({"format": "user-effects/1", "effect": [effect]}))
        change(tables_of[heading][1](file))
        return file

    def fault(file):
        lines = [f"format = {json.dumps(file['format'])}\n"] if "format" in file else []
        lines += [f"{key} = 1\n" for key in file if key not in ("format", "effect")]
        for one in file.get("effect", []):
            lines.append("[[effect]]\n" + toml_file({key: value for key, value in one.items() if key != "parameters"}))
            for name, values in one.get("parameters", {}).items():
                lines.append(f"[effect.parameters.{name}]\n" + toml_file(values))
        (folder / "effects.toml").write_text("".join(lines), encoding="utf-8")
        return complaint("diagnose", str(ROOT / "docs/examples" / "cogging"), "--effects", "effects.toml", folder=folder)

    for heading, (node, _) in tables_of.items():
        named, required = set(node["properties"]), set(node["required"])
        known = re.search(r"expected one of (.*)", fault(changed_file(heading, lambda table: table.update(zz=1))))
        assert known and set(known[1].split()) == named, f"{heading}: the schema names {named}; {known}"
        for key in required:
            without = changed_file(heading, lambda table, key=key: table.pop(key, None))
            assert f"{key}: found no" in fault(without), f"{heading} {key}: {fault(without)}"
            assert not validator.is_valid(without), f"schema, {heading} {key}"
    for block in blocks(USER_EFFECTS):
        if "file" in block.attributes:
            validator.validate(tomllib.loads(block.text))


with tempfile.TemporaryDirectory() as place:
    experiments(Path(place))
    user_effects(Path(place))
    chains(Path(place))
    tables_of_chains(Path(place))
    motions(Path(place))
repository_experiments()
