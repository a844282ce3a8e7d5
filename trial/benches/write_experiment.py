"""An experiment as files: experiment.toml, a table by run, and the label."""
import json

import numpy as np


def numbers(values):
    return "[" + ", ".join(f"{v:.10g}" for v in values) + "]"


def measured(bench, run):
    """The channel that is read, and the names of its columns."""
    if not bench.alone:
        return "q", [f"q{j + 1}" for j in range(bench.size)]
    turns = bench.alone == "revolute"
    name = ("torque" if turns else "Fx") if run.is_held else ("angle" if turns else "x")
    return name, [name]


def imposed(bench, run):
    """Names of the columns that are imposed, and their values: (reading, column)."""
    if bench.alone:
        turns = bench.alone == "revolute"
        return [("angle" if turns else "x") if run.is_held else ("torque" if turns else "Fx")], run.imposed[:, None]
    names, parts = [], []
    if run.control == "command":
        names += [f"q_command{j + 1}" for j in range(bench.size)]
        parts.append(run.command)
    if run.force is not None:
        names += ["Fx", "Fy"]
        parts.append(run.force)
    if run.value is not None:
        names.append(bench.load)
        parts.append(run.value[:, None])
    if run.link_force is not None:
        names += ["link_x", "link_y"]
        parts.append(run.link_force)
    return names, np.concatenate(parts, axis=1)


def digits_below(noise):
    """Decimals that show a hundredth of the noise."""
    return max(0, int(np.ceil(2 - np.log10(noise))))


def table(bench, run, read):
    names, values = imposed(bench, run)
    columns = (["t"] if bench.clock else []) + names + measured(bench, run)[1]
    decimals = digits_below(bench.noise)
    rows = [",".join(columns)]
    for i in range(len(read)):
        row = [f"{run.time[i]:.10g}"] if bench.clock else []
        row += [f"{v:.8g}" for v in values[i]] + [f"{v:.{decimals}f}" for v in read[i]]
        rows.append(",".join(row))
    return "\n".join(rows) + "\n"


def nominal(bench):
    lines = ["[nominal]"]
    if bench.alone:
        lines.append(f'joint = "{bench.alone}"')
    else:
        lines.append(f"link_length = {numbers(bench.length)}")
    lines.append(f"joint_stiffness = {numbers(bench.stiffness)}")
    if bench.mass is not None:
        lines += [f"link_mass = {numbers(bench.mass)}", "gravity = [0, -9.81]"]
    if bench.load:
        lines.append(f"rest = {numbers(bench.runs[0].command[0])}")
    return lines


def load(bench):
    if not bench.load:
        return []
    lines = ["", "[[load]]"]
    if bench.load == "force":
        return lines + ['force = ["link_x", "link_y"]', f"link = {bench.link}", f"at = {bench.at:.10g}"]
    return lines + [f'{bench.load} = "{bench.load}"', f'{"radius" if bench.load == "tendon" else "volume"} = {numbers(bench.lever)}']


def document(name, bench):
    lines = ['format = "chain-experiment/1"', f'name = "{name}"', "", *nominal(bench)]
    if not bench.alone:
        lines += ["", "[bench]", f'gravity_plane = "{bench.plane}"']
    lines += load(bench)
    if not bench.alone:
        lines += ["", "[columns]", f"q = {json.dumps(measured(bench, bench.runs[0])[1])}"]
        if bench.runs[0].control == "command":
            lines.append(f'q_command = {json.dumps([f"q_command{j + 1}" for j in range(bench.size)])}')
    lines += ["", "[noise]", f"{measured(bench, bench.runs[0])[0]} = {bench.declared:.6g}"]
    for run in bench.runs:
        lines += ["", "[[run]]", f'id = "{run.id}"', f'control = "{run.control}"']
        lines += [f'loaded_by = "{run.loaded_by}"'] if run.loaded_by and run.control in ("torque", "force") else []
        lines += ['begins = "moving"'] if run.begins == "moving" else []
        lines.append(f'samples = "{run.id}.csv"')
    return "\n".join(lines) + "\n"


def write_experiment(folder, name, drawn):
    folder.mkdir(parents=True)
    for run, read in zip(drawn.bench.runs, drawn.readings):
        (folder / f"{run.id}.csv").write_text(table(drawn.bench, run, read))
    (folder / "experiment.toml").write_text(document(name, drawn.bench))


def label(name, drawn):
    return json.dumps({"name": name, "effects": drawn.effects, "equivalent": drawn.equivalent, "strength_sigma": round(drawn.strength, 3),
                       "family": drawn.family, "noise": drawn.noise, "noise_scale": drawn.noise_scale, "description": drawn.words,
                       "channel": ""}, indent=1)
