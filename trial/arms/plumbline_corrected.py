"""What Plumbline says of an experiment, and how well its corrected model predicts other poses."""
import json
import pathlib
import subprocess
import tempfile

import numpy as np


def key(effect):
    return effect["id"] + (f"({effect['joint']})" if effect.get("joint") else "")


def run(program, *words):
    done = subprocess.run([program, "diagnose", *map(str, words)], capture_output=True, text=True, timeout=900)
    if done.returncode != 0:
        raise RuntimeError(done.stderr.strip() or f"exit status {done.returncode}")


def plumbline_blames_and_errors(program, folder, later_folder, later):
    """Error at the later poses in standard deviations of the tracker, and the causes named. Of several corrected models the
    first counts; without one the nominal model stays."""
    with tempfile.TemporaryDirectory() as scratch:
        scratch = pathlib.Path(scratch)
        try:
            run(program, folder, "--json", scratch / "report.json", "--corrected", scratch / "model.toml")
            report = json.loads((scratch / "report.json").read_text())
            cause, corrected = report["cause"], report.get("corrected") or []
            named = [cause["verdict"]] + [key(effect) for effect in cause["effects"]]
            model = ["--model", scratch / pathlib.Path(corrected[0]["file"]).name] if corrected else []
            run(program, later_folder, *model, "--json", scratch / "later.json")
            gap = json.loads((scratch / "later.json").read_text())["gap"]
        except (RuntimeError, OSError, subprocess.TimeoutExpired) as error:
            return None, [str(error)]
    rms = [value / later.tracker for channel, value in gap["rms"].items() if channel[0] in "xyz"]
    return float(np.sqrt(np.mean(np.square(rms)))), named
