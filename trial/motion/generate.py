#!/usr/bin/env python3
"""Makes experiments of a joint in motion, and seals their labels. Needs MuJoCo (PyPI mujoco) and numpy.

    generate.py OUT --seed S --count N

writes OUT/motion-S/NAME/ (experiment.toml, an index and logs), OUT/motion-S/seals.json and, apart from them, OUT/motion-S-labels/NAME.json.
"""
import argparse
import csv
import json
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))

from draw import PERIODS, SAME, drawn  # noqa: E402
from rig import follow  # noqa: E402
from sealing import new_folders, sealed, write_seals  # noqa: E402


GAINS = (2.0, 5.0)  # duty per rad, over what holds half the load at 0.1 rad
DURATION = 3.6


def settings(name, nominal, unknown, sigma):
    drive = {"stall_torque": nominal.stall, "armature": nominal.armature, "joint_friction": nominal.dry, "viscous_friction": nominal.damping,
             "encoder_zero": nominal.zero}
    load = f"mass = {nominal.mass:.9g}\nlength = {nominal.length:.9g}" if nominal.hangs else f"inertia = {nominal.inertia:.9g}"
    lines = [f'{key} = "unknown"' if key in unknown else f"{key} = {value:.9g}" for key, value in drive.items()]
    lines.append(f"periods_per_turn = {list(PERIODS)}")
    return (f'format = "motion/1"\nname = "{name}"\n\n[logs]\nindex = "index.csv"\nfit = {{ role = ["fit"] }}\nheld_out = {{ role = ["held out"] }}\n\n'
            f'[servo]\ngain = "gain"\n\n[load]\n{load}\n\n[drive]\n' + "\n".join(lines) + f"\n\n[noise]\nposition = {sigma:.6g}\n")


def make(out, labels, seed, number):
    g, nominal, actual, kind, truth, unknown, logging, motions = drawn(number, seed)
    name = f"motion-{number:03d}"
    folder = out / name
    folder.mkdir()
    index = [("file", "gain", "role")]
    for gain in GAINS:
        for motion, command in motions.items():
            file = f"{motion}-{gain:g}.csv"
            role = "held out" if (motion, gain) in (("sines", 5.0), ("steps", 2.0)) else "fit"
            rows = follow(actual, gain, command, DURATION, logging["rate"], g, logging["quantum"], logging["sigma"])
            with open(folder / file, "w", newline="") as text:
                writer = csv.writer(text, lineterminator="\n")
                writer.writerow(("t", "command", "position"))
                writer.writerows((f"{t:.6f}", f"{c:.6f}", f"{q:.7f}") for t, c, q in rows)
            index.append((file, gain, role))
    with open(folder / "index.csv", "w", newline="") as text:
        csv.writer(text, lineterminator="\n").writerows(index)
    # An encoder's step is uniform noise.
    sigma = (logging["sigma"] ** 2 + logging["quantum"] ** 2 / 12) ** 0.5
    (folder / "experiment.toml").write_text(settings(name, nominal, unknown, sigma))
    same = {cause: sorted(one - {cause}) for cause in truth for one in SAME if cause in one}
    label = {"kind": kind, "causes": truth, "same": same, "unknown": list(unknown), "rate": logging["rate"],
             "values": {k: v for k, v in vars(actual).items() if v != getattr(nominal, k)}}
    return sealed(labels, name, seed, json.dumps(label))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("out", type=pathlib.Path)
    parser.add_argument("--seed", type=int, required=True)
    parser.add_argument("--count", type=int, required=True)
    a = parser.parse_args()
    out, labels = new_folders(a.out, "motion", a.seed)
    seals = dict(make(out, labels, a.seed, number) for number in range(a.count))
    write_seals(out, seals)


if __name__ == "__main__":
    main()
