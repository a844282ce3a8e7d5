"""Benches of a second maker: chains solved by a few lines of NumPy that share nothing with the simulator of the trial or with
the diagnosis. Each kind is one that laboratories have and that a diagnosis can get wrong: loads that alternate, readings that are few,
servo arms that sag, stops met at the last reading, friction that gives a little before it slips, noise of every kind without a gap.

    make_foreign(folder, variants, seed)   writes folder/KIND-NN/{experiment.toml, *.csv, label.json}
"""
import json
import pathlib

import numpy as np


class Chain:
    """Joints with torque laws tau_i(d) = k_i d + extra_i(d), dry friction that slips after a small turn, weights of links."""

    def __init__(self, lengths, stiffness, weights=None, extra=None, friction=0.0, bristle=None, payload=0.0, down=(1.0, 0.0)):
        self.lengths, self.stiffness = np.array(lengths, float), np.array(stiffness, float)
        self.weights = np.zeros(len(lengths)) if weights is None else np.array(weights, float)
        self.extra = extra or (lambda joint, d: 0.0)
        self.friction, self.bristle = friction, bristle
        self.payload, self.down = payload, np.array(down, float)

    def points(self, q):
        theta = np.cumsum(q)
        steps = self.lengths[:, None] * np.stack([np.cos(theta), np.sin(theta)], 1)
        ends = np.cumsum(steps, 0)
        return ends, ends - steps / 2

    def torques(self, q, rest, force, memory):
        """Of the joints, out of balance; and the friction they carry."""
        d = q - rest
        spring = self.stiffness * d + np.array([self.extra(i, x) for i, x in enumerate(d)])
        rub = np.zeros_like(q)
        if self.friction > 0:
            last_q, last_rub = memory
            rub = np.clip(last_rub + self.bristle * (q - last_q), -self.friction, self.friction)
        ends, middles = self.points(q)
        joints = np.vstack([[0.0, 0.0], ends[:-1]])
        load = np.zeros_like(q)
        for i in range(len(q)):
            arm = ends[-1] - joints[i]
            whole = force + self.payload * self.down
            load[i] += arm[0] * whole[1] - arm[1] * whole[0]
            for j in range(i, len(q)):
                arm = middles[j] - joints[i]
                w = self.weights[j] * self.down
                load[i] += arm[0] * w[1] - arm[1] * w[0]
        return spring + rub - load, rub

    def solve(self, rest, run, control):
        """Joint angles, end points and forces along a run of imposed forces or end points."""
        rest = np.array(rest, float)
        n = len(rest)
        unknowns = rest.copy() if control == "force" else np.concatenate([rest, [0.0, 0.0]])
        memory = (rest.copy(), np.zeros(n))
        result = []
        imposed = np.array(run, float)
        before = imposed[0] * 0 if control == "force" else self.points(rest)[0][-1]
        for target in imposed:
            steps = max(1, int(np.ceil(np.abs(target - before).max() / (0.02 * self.lengths.sum() if control != "force" else np.inf))))
            for share in np.linspace(0, 1, steps + 1)[1:]:
                now = before + share * (target - before)

                def balance(u, now=now):
                    if control == "force":
                        return self.torques(u, rest, now, memory)[0]
                    out, _ = self.torques(u[:n], rest, u[n:], memory)
                    return np.concatenate([out, (self.points(u[:n])[0][-1] - now) * self.stiffness.max() / self.lengths.sum()])

                unknowns = newton(balance, unknowns)
                q = unknowns[:n]
                _, rub = self.torques(q, rest, now if control == "force" else unknowns[n:], memory)
                memory = (q.copy(), rub)
            before = target
            end = self.points(q)[0][-1]
            force = target if control == "force" else unknowns[n:]
            result.append((q.copy(), end, np.array(force)))
        return result


def newton(f, u):
    for _ in range(200):
        r = f(u)
        if np.abs(r).max() < 1e-10:
            return u
        h = 1e-7
        jacobian = np.stack([(f(u + h * e) - f(u - h * e)) / (2 * h) for e in np.eye(len(u))], 1)
        step = np.linalg.solve(jacobian, -r)
        size = min(1.0, 0.3 / max(1e-300, np.abs(step).max()))
        while size > 1e-4 and np.abs(f(u + size * step)).max() > np.abs(r).max() * (1 - 0.1 * size):
            size /= 2
        u = u + size * step
    raise RuntimeError("no equilibrium")


def ar(random, n, rho):
    e = random.normal(size=n)
    for i in range(1, n):
        e[i] = rho * e[i - 1] + np.sqrt(1 - rho**2) * e[i]
    return e


def there_and_back(values):
    return list(values) + list(values[-2::-1])


class Writer:
    def __init__(self, root):
        self.root = pathlib.Path(root)

    def write(self, name, nominal, noise, runs, effects, equivalent=(), plane="horizontal", down=None, extra=""):
        """runs: [(id, control, rest, rows)], a row (t, x, y, Fx, Fy, q...) with None where nothing was read."""
        folder = self.root / name
        folder.mkdir(parents=True, exist_ok=True)
        text = [f'format = "chain-experiment/1"', f'name = "{name}"', "", "[nominal]",
                f"link_length = {[float(x) for x in nominal.lengths]}", f"joint_stiffness = {[float(x) for x in nominal.stiffness]}", "",
                "[bench]", f'gravity_plane = "{plane}"']
        if down is not None:
            text.append(f"gravity_direction = {[float(x) for x in down]}")
        text += [extra] if extra else []
        text += ["", "[noise]"] + [f"{channel} = {sigma:.6g}" for channel, sigma in noise.items()]
        for run, control, rest, rows in runs:
            text += ["", "[[run]]", f'id = "{run}"', f'control = "{control}"', f"rest = {[float(x) for x in rest]}",
                     f'samples = "{run}.csv"']
            joints = max(len(row) for row in rows) - 5
            lines = ["t,x,y,Fx,Fy" + "".join(f",q{j + 1}" for j in range(joints))]
            lines += [",".join("" if x is None else f"{x:.8g}" for x in row) for row in rows]
            (folder / f"{run}.csv").write_text("\n".join(lines) + "\n")
        (folder / "experiment.toml").write_text("\n".join(text) + "\n")
        label = {"name": name, "set": "foreign", "effects": effects, "equivalent": list(equivalent), "strength_sigma": 20 if effects else 0}
        (folder / "label.json").write_text(json.dumps(label, indent=1) + "\n")


def effect(id, joint=None, **parameters):
    return {"id": id, **({"joint": joint} if joint else {}), "parameters": parameters}


def angles_under(chain, rest, forces, sigma, random, noise=None, pause=2.0):
    rows = []
    e = noise if noise is not None else random.normal(size=(len(forces), len(rest)))
    for i, (q, _, f) in enumerate(chain.solve(rest, forces, "force")):
        rows.append((pause * i, None, None, f[0], f[1], *(q + sigma * e[i])))
    return rows


def lever(random):
    return random.uniform(0.2, 0.4), random.uniform(1.5, 4.0)


def alternating(w, name, random, v):
    length, k = lever(random)
    a = random.choice([-1, 1]) * random.uniform(0.12, 0.3)
    n = int(random.integers(14, 30))
    top = random.uniform(0.2, 0.35) * k / length
    ladder = np.linspace(top, top / (n // 2), n // 2)
    forces = [(0.0, s * f) for f in ladder for s in ((-1, 1) if v % 2 else (1, -1))]
    if v % 3 == 2:
        forces = [(0.0, f) for f in random.permutation(np.concatenate([ladder, -ladder]))]
    true = Chain([length], [k * (1 + a)])
    w.write(name, Chain([length], [k]), {"q": 0.002}, [("s", "force", [0.2], angles_under(true, [0.2], forces, 0.002, random))],
            [effect("joint_stiffness", 1, a=a)], [["stiffness_scale"], ["force_gain"]])


def zero_return(w, name, random, v):
    length, k = lever(random)
    a = random.choice([-1, 1]) * random.uniform(0.12, 0.3)
    top = random.uniform(0.2, 0.4) * k / length
    forces = [(0.0, f * (i % 2 == 0)) for i, f in enumerate(np.repeat(np.linspace(top / 10, top, 10), 2))]
    true = Chain([length], [k * (1 + a)])
    w.write(name, Chain([length], [k]), {"q": 0.002}, [("s", "force", [0.2], angles_under(true, [0.2], forces, 0.002, random))],
            [effect("joint_stiffness", 1, a=a)], [["stiffness_scale"], ["force_gain"]])


def no_gap(w, name, random, v):
    """Right models, noise of every kind."""
    lengths, k = random.uniform(0.15, 0.3, 2), random.uniform(1.0, 3.0, 2)
    chain = Chain(lengths, k)
    rest = [0.3, -0.5]
    n = 40
    sigma = 0.003
    forces = [(0.0, f) for f in there_and_back(np.linspace(0, 0.25 * k.min() / lengths.sum(), n // 2))]
    count = len(forces)
    kind = ("white", "declared too small", "declared too large", "correlated", "outliers", "rough in a part", "hum", "coarse", "alternating", "few")[v % 10]
    e = random.normal(size=(count, 2))
    declared = sigma
    if kind == "declared too small":
        declared = sigma / 3
    if kind == "declared too large":
        declared = 3 * sigma
    if kind == "correlated":
        e = np.stack([ar(random, count, 0.7) for _ in range(2)], 1)
    if kind == "outliers":
        e += 12 * random.normal(size=e.shape) * (random.uniform(size=e.shape) < 0.04)
    if kind == "rough in a part":
        e[count // 3: count // 2] *= 4
    if kind == "hum":
        e += 2 * np.sin(2 * np.pi * np.arange(count) / 5.3)[:, None]
    if kind == "alternating":
        forces = [(fx, (-1) ** i * fy) for i, (fx, fy) in enumerate(forces)]
    if kind == "few":
        forces, e = forces[::8], e[::8]
    rows = angles_under(chain, rest, forces, sigma, random, e)
    if kind == "coarse":
        rows = [(*row[:5], *(np.round(np.array(row[5:]) / (3 * sigma)) * 3 * sigma)) for row in rows]
    w.write(name, chain, {"q": declared}, [("s", "force", rest, rows)], [])


def sag_payload(w, name, random, v):
    lengths, k = random.uniform(0.25, 0.4, 2), random.uniform(12, 25, 2)
    payload = random.uniform(4, 12)
    true = Chain(lengths, k, payload=payload)
    runs = []
    sigma = np.deg2rad(0.1)
    for p in range(6):
        rest = np.deg2rad(random.uniform([0, -60], [90, 90]))
        runs.append((f"p{p}", "force", rest, angles_under(true, rest, [(0.0, 0.0)], sigma, random)))
    w.write(name, Chain(lengths, k), {"q": sigma}, runs, [effect("tip_payload", weight=payload)], plane="vertical", down=(1, 0))


def servo_sag(w, name, random, v):
    k = random.uniform(15, 30)
    length = random.uniform(0.4, 0.6)
    weight = random.uniform(0.3, 0.5) * k / length
    true = Chain([length], [k], weights=[weight])
    scatter = np.deg2rad(0.2)
    declared = scatter * (0.25, 0.5, 1, 2, 5)[v % 5]
    runs = []
    for p, angle in enumerate(np.deg2rad(np.linspace(20, 90, 5 + v % 3))):
        runs.append((f"p{p}", "force", [angle], angles_under(true, [angle], [(0.0, 0.0)], scatter, random)))
    w.write(name, Chain([length], [k]), {"q": declared}, runs, [effect("gravity", rho=weight / 9.81 / length)],
            [["tip_payload"]], plane="vertical", down=(1, 0))


def stop_law(k_s, s):
    return lambda joint, d: k_s * np.sign(d) * max(0.0, abs(d) - s) if joint == 0 else 0.0


def stiff_stop(w, name, random, v):
    length, k = 0.1, random.uniform(2, 4)
    s, times = random.uniform(0.05, 0.09), (10, 30, 60, 100, 98)[v % 5]
    true = Chain([length], [k], extra=stop_law(times * k, s))
    top = k * s / length * random.uniform(1.1, 1.6)
    forces = [(0.0, f) for f in np.linspace(0, top, 30)]
    if v >= 5:
        forces = [(0.0, f) for f in there_and_back(np.linspace(0, top, 20))]
    rows = [(1.0 * i, None, end[1] + 5e-5 * random.normal(), f[0], f[1])
            for i, (q, end, f) in enumerate(true.solve([0.0], forces, "force"))]
    w.write(name, Chain([length], [k]), {"y": 5e-5}, [("w", "force", [0.0], rows)], [effect("joint_stop", 1, s=s, k_s=times * k)])


def stop_at_the_end(w, name, random, v):
    """The stop shows in the last reading or two, or at the turn."""
    k = random.uniform(2, 4)
    s = 0.06
    true = Chain([0.1, 0.1], [k, 1e-9], extra=stop_law(98 * k, s))
    rest = [np.pi / 2, -np.pi / 2]
    # the end point is pushed along x: joint 1 turns by about x / 0.1
    way = np.linspace(0, 0.1 * np.sin(s) + random.uniform(0.5, 1.2) * 0.00022, 30)
    if v % 2:
        way = np.array(there_and_back(way))
    reached = Chain([0.1, 0.1], [k, 1e-9])
    ends = [(0.1 + x, 0.1) for x in way]
    solved = true.solve(rest, ends, "displacement")
    rows = [(1.0 * i, ends[i][0], ends[i][1], f[0] * 1 + 0.02 * random.normal(), None) for i, (q, end, f) in enumerate(solved)]
    nominal = Chain([0.1, 0.1], [k, 0.0])
    w.write(name, nominal, {"Fx": 0.02}, [("w", "displacement", rest, rows)], [effect("joint_stop", 1, s=s, k_s=98 * k)])


def presliding(w, name, random, v):
    lengths, k = [0.30, 0.25, 0.18], [4.0, 2.5, 1.5]
    friction = random.uniform(0.04, 0.14)
    bristle = friction / random.uniform(0.0002, 0.0012)
    rest = np.deg2rad([20, -35, 30])
    start = Chain(lengths, k).points(rest)[0][-1]
    runs = []
    for run, toward in (("press_x", (-0.06, 0)), ("pull_y", (0, 0.05)), ("diag", (-0.05, -0.035))):
        ends = [start + share * np.array(toward) for share in there_and_back(np.linspace(0, 1, 18))]
        true = Chain(lengths, k, friction=friction, bristle=bristle)
        rows = [(1.0 * i, e[0], e[1], f[0] + 0.05 * random.normal(), f[1] + 0.05 * random.normal())
                for i, (e, (q, end, f)) in enumerate(zip(ends, true.solve(rest, ends, "displacement")))]
        runs.append((run, "displacement", rest, rows))
    w.write(name, Chain(lengths, k), {"Fx": 0.05, "Fy": 0.05}, runs, [effect("joint_friction", tau_c=friction)])


def plain_cause(w, name, random, v):
    """One listed cause on two joints, sampled finely or coarsely, declared rightly or not."""
    lengths, k = random.uniform(0.15, 0.3, 2), random.uniform(1.0, 3.0, 2)
    rest = [0.35, -0.6]
    a = random.choice([-1, 1]) * random.uniform(0.15, 0.35)
    joint = int(random.integers(1, 3))
    true_k = np.array(k)
    true_k[joint - 1] *= 1 + a
    runs = []
    step = (1, 1, 4, 8, 1)[v % 5]
    declared = 0.003 * (1, 1 / 20, 1, 1, 10)[v % 5]
    for run, direction in (("a", (0.3, 1.0)), ("b", (-1.0, 0.4))):
        top = 0.35 * k.min() / lengths.sum()
        forces = [tuple(f * np.array(direction)) for f in there_and_back(np.linspace(0, top, 33))][::step]
        runs.append((run, "force", rest, angles_under(Chain(lengths, true_k), rest, forces, 0.003, random)))
    w.write(name, Chain(lengths, k), {"q": declared}, runs, [effect("joint_stiffness", joint, a=a)])


def outside(w, name, random, v):
    """Laws that nobody listed."""
    lengths, k = random.uniform(0.15, 0.3, 2), random.uniform(1.0, 3.0, 2)
    rest = [0.35, -0.6]
    top = 0.4 * k.min() / lengths.sum()
    own = k[0] if v % 5 < 3 else k[1]  # slopes stay below the spring's: nothing snaps
    law = (lambda joint, d: 0.6 * own / 25 * np.sin(25 * d) if joint == 0 else 0.0,
           lambda joint, d: 0.4 * own * 0.04 * np.exp(-((d - 0.12) / 0.04) ** 2) if joint == 0 else 0.0,
           lambda joint, d: 0.06 * own * (np.tanh(40 * (d - 0.1)) + np.tanh(4)) if joint == 0 else 0.0,
           lambda joint, d: 0.6 * own / 15 * (np.sin(15 * d + 1) - np.sin(1)) if joint == 1 else 0.0,
           lambda joint, d: 0.12 * own * np.tanh(12 * d) if joint == 1 else 0.0)[v % 5]
    runs = []
    for run, direction in (("a", (0.3, 1.0)), ("b", (-1.0, 0.4))):
        forces = [tuple(f * np.array(direction)) for f in there_and_back(np.linspace(0, top, 30))]
        runs.append((run, "force", rest, angles_under(Chain(lengths, k, extra=law), rest, forces, 0.002, random)))
    w.write(name, Chain(lengths, k), {"q": 0.002}, runs, [{"id": "unknown", "joint": 1 if v % 5 < 3 else 2, "parameters": {}}])


KINDS = {"alternating": alternating, "zero-return": zero_return, "no-gap": no_gap, "sag-payload": sag_payload, "servo-sag": servo_sag,
         "stiff-stop": stiff_stop, "stop-at-the-end": stop_at_the_end, "presliding": presliding, "plain-cause": plain_cause,
         "outside": outside}


def make_foreign(folder, variants, seed):
    writer = Writer(folder)
    for number, (kind, make) in enumerate(KINDS.items()):
        for v in range(variants):
            make(writer, f"{kind}-{v:02d}", np.random.default_rng([seed, number, v]), v)


if __name__ == "__main__":
    import sys
    make_foreign(sys.argv[1], int(sys.argv[2]), int(sys.argv[3]))
