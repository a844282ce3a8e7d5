"""An experiment as files: experiment.toml, the nominal model, a table by run, and the label."""
import json

from model_files import nominal_model


def numbers(values):
    return "[" + ", ".join(f"{v:.10g}" for v in values) + "]"


def columns(bench):
    n = bench.shape.size
    names = ["t"] + [f"q_command{j + 1}" for j in range(n)]
    names += [f"q{j + 1}" for j in range(n)] if bench.angles else []
    names += [f"{point}_{axis}" for point in point_names(bench) for axis in "xyz"]
    return names + ["Fx", "Fy", "Fz"]


def point_names(bench):
    return ["tip"] + [f"ball_{i + 2}" for i in range(len(bench.points))]


def table(bench, run, places, reached, start):
    rows = [",".join(columns(bench))]
    for i, command in enumerate(run.commands):
        values = [*(f"{v:.4f}" for v in command)]
        values += [f"{v:.6f}" for v in reached[i]] if bench.angles else []
        values += [f"{v:.6f}" for v in places[i].ravel()]
        values += [f"{v:.2f}" for v in run.forces[i]]
        rows.append(",".join([str(30 * (start + i)), *values]))
    return "\n".join(rows) + "\n"


def document(name, bench, model):
    shape = bench.shape
    lines = ['format = "chain-experiment/1"', f'name = "{name}"', "", "[arm]", f'model = "{model}"', 'base = "base"', 'tip = "tip"']
    lines.append(f'frames = "{"unknown" if bench.anywhere else "known"}"')
    if shape.model == "urdf":
        lines.append(f"joint_stiffness = {numbers(shape.stiffness)}")
    lines += ["", "[arm.load]", 'body = "tip"']
    for point, offset in zip(point_names(bench), ((0.0, 0.0, 0.0), *bench.points)):
        lines += ["", "[[arm.point]]", f'name = "{point}"', 'body = "tip"', f"offset = {numbers(offset)}"]
    lines += ["", "[noise]", f'place = {bench.sigma["place"]:.6g}']
    if bench.angles:
        lines.append(f'q = {bench.sigma["q"]:.6g}')
    for run in bench.runs:
        loaded_by = "servo" if bench.by_cell else "weights"
        lines += ["", "[[run]]", f'id = "{run.id}"', f'loaded_by = "{loaded_by}"', f'samples = "{run.id}.csv"']
    return "\n".join(lines) + "\n"


def write_experiment(folder, name, bench, readings):
    folder.mkdir(parents=True, exist_ok=True)
    file, text = nominal_model(bench.shape)
    (folder / file).write_text(text)
    start = 0
    for run, (places, reached) in zip(bench.runs, readings):
        (folder / f"{run.id}.csv").write_text(table(bench, run, places, reached, start))
        start += len(run.commands)
    (folder / "experiment.toml").write_text(document(name, bench, file))


def label(name, drawn):
    effects = [{"id": one.cause.id, "joint": one.place + 1 if one.place >= 0 else None,
                "parameters": {k: float(v) for k, v in one.parameters.items()}, "strength_sigma": round(one.strength, 3)}
               for one in drawn.planted]
    words = "; ".join(one.cause.words for one in drawn.planted if one.cause.words)
    family = f"outside: {words}" if words else drawn.family
    return json.dumps({"name": name, "effects": effects, "equivalent": [[one] for one in drawn.equivalent],
                       "strength_sigma": round(drawn.strength, 3), "family": family, "noise": drawn.noise, "noise_scale": drawn.noise_scale, "description": words, "channel": ""}, indent=1)
