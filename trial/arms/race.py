#!/usr/bin/env python3
"""What others would fit to the same tables, how well it predicts poses that were not fitted, and what it blames.

    race.py OUT/arms-S OUT/arms-S-labels --json FILE [--plumbline PROGRAM]

Three ways: least squares over zeros and stiffnesses of the joints and the place of the tool (what a user writes); MuJoCo's own system
identification (mujoco.sysid) over servo gains, masses and centres of the bodies; Plumbline's corrected model. Errors are root mean squares
of the tip's coordinates at held-out poses, over the standard deviation of the tracker. A parameter is blamed where it is five standard
errors off its nominal value.
"""
import argparse
import json
import pathlib

import mujoco
import numpy as np
from mujoco import sysid
from scipy.optimize import least_squares

from batch_statics import PlainArm
from model_files import mjcf
from plumbline_corrected import plumbline_blames_and_errors
from read_experiment import read_experiment

BLAMED = 5.0  # standard errors
ALL = "all"


def predicted(arm, experiment, turned):
    """Places of the points, and reached coordinates of the joints as their encoders count, by reading."""
    q = arm.rest(turned, experiment.forces)
    *_, place, axes = arm.posture(q)
    places = np.stack([place + axes @ offset for offset in experiment.offsets], 1)
    return places, experiment.commands + q - turned


def residual(experiment, places, reached):
    parts = [(places - experiment.places) / experiment.sigma["place"]]
    if experiment.reached is not None:
        parts.append((reached - experiment.reached) / experiment.sigma["q"])
    return np.concatenate([part.ravel() for part in parts])


class OffsetsAndStiffnesses:
    """Zeros and stiffnesses of all joints, and the place of the tool."""
    name = "zeros and stiffnesses"

    def __init__(self, shape):
        self.shape = shape
        joints = range(1, shape.size + 1)
        self.names = [f"zero({j})" for j in joints] + [f"stiffness({j})" for j in joints] + ["tool x", "tool y", "tool z"]

    def predict(self, x, experiment):
        n = self.shape.size
        arm = PlainArm.of_shape(self.shape)
        arm.stiffness, arm.tip = arm.stiffness * np.exp(x[n:2 * n]), arm.tip + x[2 * n:]
        return predicted(arm, experiment, experiment.commands + x[:n])

    def fit(self, experiment):
        n = self.shape.size
        scale = np.concatenate([np.full(n, 1e-3), np.full(n, 0.1), np.full(3, 1e-3 * self.shape.length)])

        def r(u):
            return residual(experiment, *self.predict(scale * u, experiment))

        # a weak tie to the nominal values holds what the poses do not show
        found = least_squares(lambda u: np.concatenate([r(u), 1e-2 * u]), np.zeros(2 * n + 3), diff_step=1e-3, max_nfev=10)
        noise = np.sqrt(np.mean(r(found.x) ** 2))
        error = noise * np.sqrt(np.diag(np.linalg.inv(found.jac.T @ found.jac)))
        return scale * found.x, found.x / error


class Sysid:
    """MuJoCo's system identification: servo gains, masses and centres of the bodies."""
    name = "mujoco.sysid"

    def __init__(self, shape):
        self.shape = shape
        self.text = mjcf(shape)
        self.arm = PlainArm.of_shape(shape)
        joints = range(1, shape.size + 1)
        self.names = [f"gain({j})" for j in joints] + [f"{what}({j})" for j in joints for what in ("mass", "centre x", "centre y", "centre z")]

    def parameters(self):
        """Factors of the gains, and of the masses; displacements of the centres."""
        shape, found = self.shape, sysid.ParameterDict()
        far = 0.3 * shape.length

        for i, link in enumerate(shape.links):
            def gain(spec, p, i=i, link=link):
                sysid.apply_pgain(spec, spec.actuators[i].name, link.stiffness * np.exp(p.value[0]))

            found.add(sysid.Parameter(f"gain_{i}", 0.0, min_value=-3.0, max_value=3.0, modifier=gain))
        for i, link in enumerate(shape.links):
            def inertial(spec, p, i=i, link=link):
                body = spec.body(f"link_{i + 1}")
                body.mass = link.mass * np.exp(p.value[0])
                body.ipos = np.array(link.centre) + far * p.value[1:]

            found.add(sysid.Parameter(f"body_{i}", np.zeros(4), min_value=-np.ones(4) * 3, max_value=np.ones(4) * 3, modifier=inertial))
        return found

    def predict(self, parameters, experiment):
        spec = mujoco.MjSpec.from_string(self.text)
        for i, actuator in enumerate(spec.actuators):
            actuator.name = f"servo_{i}"
        return predicted(self.arm.with_numbers_of(sysid.apply_param_modifiers(parameters, spec)), experiment, experiment.commands)

    def fit(self, experiment):
        def residuals(x, parameters, **_):
            x = np.asarray(x)
            columns = []
            for column in (x[:, None] if x.ndim == 1 else x).T:
                parameters.update_from_vector(column)
                columns.append(np.append(residual(experiment, *self.predict(parameters, experiment)), 1e-2 * column))
            result = np.stack(columns, 1)
            return [result[:, 0] if x.ndim == 1 else result], [], []

        found, result = sysid.optimize(self.parameters(), residuals, optimizer="mujoco", verbose=False, max_iters=10)
        x, jacobian = found.as_vector(), np.asarray(result.jac)
        rows = jacobian.shape[0] - len(x)
        noise = np.sqrt(np.sum(np.asarray(residuals(x, found)[0][0])[:rows] ** 2) / rows)
        error = noise * np.sqrt(np.diag(np.linalg.inv(jacobian.T @ jacobian)))
        found.update_from_vector(x)
        return found, x / error


def error_of(experiment, places):
    return float(np.sqrt(np.mean(((places - experiment.places) / experiment.tracker) ** 2)))


def blames(names, z):
    order = np.argsort(-np.abs(z))
    return [f"{names[i]} {z[i]:+.0f}" for i in order if abs(z[i]) > BLAMED]


def start(folder, label, experiment, later):
    nominal = predicted(PlainArm.of_shape(experiment.shape), later, later.commands)[0]
    truth = [e["id"] + (f"({e['joint']})" if e["joint"] else "") for e in label["effects"]]
    return {"name": folder.name, "truth": truth, "family": label["family"],
            "alike": [one[0] for one in label["equivalent"]], "nominal": error_of(later, nominal)}


def race(folder, later_folder, label, plumbline, row):
    """Adds to the row what is not in it."""
    experiment, later = read_experiment(folder), read_experiment(later_folder)
    later.tracker = experiment.shape.tracker
    row = row or start(folder, label, experiment, later)
    for racer in (OffsetsAndStiffnesses(experiment.shape), Sysid(experiment.shape)):
        if racer.name in row:
            continue
        try:
            x, z = racer.fit(experiment)
            row[racer.name] = error_of(later, racer.predict(x, later)[0])
            row[racer.name + " blames"] = blames(racer.names, z)
        except np.linalg.LinAlgError as error:
            row[racer.name], row[racer.name + " blames"] = None, [str(error)]
    if plumbline and "plumbline" not in row:
        row["plumbline"], row["plumbline blames"] = plumbline_blames_and_errors(plumbline, folder, later_folder, later)
    return row


# What a racer's parameter is called where it is the truth.
MEANS = {"joint_zero": ["zero"], "joint_stiffness": ["stiffness", "gain"], "link_mass": ["mass"],
         "link_centre": ["centre x", "centre y", "centre z"]}


def right_names(truth):
    if truth == "tool_offset":
        return {"tool x", "tool y", "tool z"}
    kind, _, place = truth.partition("(")
    return {f"{name}({place}" for name in MEANS.get(kind, [])}


def blames_wrongly(row, racer):
    """Whether it blames, or for Plumbline identifies, what is not the truth."""
    said = row[racer + " blames"]
    if racer == "plumbline":
        return said[0] == "identified" and sorted(said[1:]) not in [sorted(row["truth"]), *([one] for one in row["alike"])]
    right = set().union(*map(right_names, row["truth"]))
    return any(words.rsplit(" ", 1)[0] not in right for words in said)


def table(rows, racers):
    """Median error at held-out poses by family, and how often each blames what is not the truth."""
    lines = ["| family | n | error: nominal | " + " | ".join(racers) + " | blames wrongly: " + " | ".join(racers) + " |",
             "| --- |" + " ---: |" * (2 + 2 * len(racers))]
    for family in [*sorted({row["family"] for row in rows}), ALL]:
        own = [row for row in rows if family in (row["family"], ALL)]
        medians = [np.median([row[key] for row in own if row[key] is not None] or [np.nan]) for key in ("nominal", *racers)]
        blamed = [sum(blames_wrongly(row, racer) for row in own) for racer in racers]
        lines.append(f"| {family} | {len(own)} | " + " | ".join(f"{m:.2f}" for m in medians) + " | " + " | ".join(map(str, blamed)) + " |")
    return "\n".join(lines)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("experiments", type=pathlib.Path)
    parser.add_argument("labels", type=pathlib.Path)
    parser.add_argument("--plumbline", help="a program that reads arms")
    parser.add_argument("--json", type=pathlib.Path, required=True, help="what was found; an interrupted race continues")
    a = parser.parse_args()
    rows = {row["name"]: row for row in json.loads(a.json.read_text())} if a.json.exists() else {}
    for folder in sorted(f.parent for f in a.experiments.glob("*/experiment.toml")):
        envelope = json.loads((a.labels / f"{folder.name}.json").read_text())
        rows[folder.name] = race(folder, a.labels / "held-out" / folder.name, json.loads(envelope["label"]), a.plumbline, rows.get(folder.name))
        a.json.write_text(json.dumps(list(rows.values()), indent=1) + "\n")
    rows = list(rows.values())
    print(table(rows, ["zeros and stiffnesses", "mujoco.sysid"] + (["plumbline"] if a.plumbline else [])))


if __name__ == "__main__":
    main()
