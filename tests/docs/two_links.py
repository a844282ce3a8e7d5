"""Experiments on a chain of two links with joint angles of one's own choice: the forces follow in closed form."""
import json
import math
import random

LENGTH, STIFFNESS, REST = (0.3, 0.2), (2.0, 1.5), (0.4, -0.9)
SIGMA = {"x": 1e-3, "y": 1e-3, "Fx": 0.02, "Fy": 0.02, "q": 1e-3}


def end_point(q):
    angles = (q[0], q[0] + q[1])
    return (sum(L * math.cos(a) for L, a in zip(LENGTH, angles)), sum(L * math.sin(a) for L, a in zip(LENGTH, angles)))


def force(q, torque):
    """The force on the end point with J^T F = torque."""
    x, y = end_point(q)
    tip = (x - LENGTH[0] * math.cos(q[0]), y - LENGTH[0] * math.sin(q[0]))
    (a, b), (c, d) = (-y, x), (-tip[1], tip[0])
    det = a * d - b * c
    return ((d * torque[0] - b * torque[1]) / det, (a * torque[1] - c * torque[0]) / det)


def write(folder, law, *, control=("displacement",), angles=False, stiffness=STIFFNESS, readings=40, seed=1, rough=None, rough_from=0,
          hum=0):
    """`law(joint, deflection, k)` is the torque that the joints really carry; run `rough` scatters three times as much, from a reading on (at four times noise and a cause outside are equal).
    `hum` is the amplitude, in sigmas, of a tone every three and a half readings of what is measured."""
    noise = random.Random(seed)
    folder.mkdir()
    text = (f'format = "chain-experiment/1"\nname = "{folder.name}"\n[nominal]\nlink_length = {list(LENGTH)}\n'
            f'joint_stiffness = {list(stiffness)}\n[bench]\ngravity_plane = "horizontal"\n[noise]\n')
    text += "".join(f"{channel} = {sigma}\n" for channel, sigma in SIGMA.items())
    for number, kind in enumerate(control):
        text += (f'[[run]]\nid = "run-{number}"\ncontrol = "{kind}"\nrest = {json.dumps(REST)}\n'
                 f'samples = "run-{number}.csv"\n')
        lines = ["t,x,y,Fx,Fy" + (",q1,q2" if angles else "")]
        for t in range(readings):
            there = 1 - abs(1 - 2 * t / (readings - 1))
            if kind == "force":
                there /= 10  # the equilibrium under a dead force is stable there
            q = (REST[0] + (0.35 + 0.1 * number) * there, REST[1] - (0.5 - 0.2 * number) * there)
            F = force(q, [law(j, q[j] - REST[j], k) for j, k in enumerate(stiffness)])
            values = {**dict(zip(("x", "y"), end_point(q))), **dict(zip(("Fx", "Fy"), F))}
            for channel in ("Fx", "Fy") if kind == "displacement" else ("x", "y"):
                values[channel] += noise.gauss(0, SIGMA[channel] * (3 if number == rough and t >= rough_from else 1))
                values[channel] += hum * SIGMA[channel] * math.sin(2 * math.pi * t / 3.5)
            fields = [2 * t, *values.values()] + [a + noise.gauss(0, SIGMA["q"]) for a in q if angles]
            lines.append(",".join(f"{value:.9g}" for value in fields))
        (folder / f"run-{number}.csv").write_text("\n".join(lines) + "\n", encoding="utf-8")
    (folder / "experiment.toml").write_text(text, encoding="utf-8")
