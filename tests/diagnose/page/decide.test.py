"""The verdict again, by docs/how-it-decides.md alone: the likelihood with its discrepancy and noise, the evidence, the
posterior and the decision, in NumPy, from what the rig predicts beside each hypothesis (hypotheses.cpp).

    decide.test.py HYPOTHESES FOLDER...   compares with the program; at least 95 % have to agree
"""
import json
import subprocess
import sys

import numpy as np

AMPLITUDE = np.array([0, 0.01, 0.02, 0.04, 0.08, 0.16, 0.32, 0.64, 1.28])
LENGTH = [0.15, 0.4, 1.0]
CORRELATION = np.array([0, 0.35, 0.65, 0.85])
NO_GAP, OUTSIDE = 0.3, 0.1
LOCAL, NUGGET, STEP, ONE_CHANNEL = 0.3, 0.1, 0.1, 0.1  # of the causes outside
AT_REST = 0.2  # of the variance of the discrepancy
TEMPER, WRONG, LARGEST = 0.25, 20, 8
SHARE, WIDTH = 0.02, 10  # of outliers


def log_sum(values):
    values = np.asarray(values, float)
    most = values.max()
    return most if not np.isfinite(most) else most + np.log(np.exp(values - most).sum())


def log_normalised(values):
    return np.asarray(values) - log_sum(values)


with np.errstate(divide="ignore"):
    small = np.where(AMPLITUDE > 0, np.exp(-AMPLITUDE / 0.1), 0)
    LOG_LISTED = np.where(AMPLITUDE > 0, np.log(0.5 * small / small.sum()), np.log(0.5))
    LOG_OUTSIDE = np.log(AMPLITUDE / AMPLITUDE.sum())
LOG_CORRELATION = log_normalised(-((CORRELATION / 0.3) ** 2) / 2)


def log_outlier(z):
    return np.log(SHARE / (WIDTH * np.pi)) - np.log1p((z / WIDTH) ** 2)


def log_inlier(z):
    return np.log((1 - SHARE) / np.sqrt(2 * np.pi)) - z**2 / 2


def matern(distance, length):
    z = np.sqrt(5) * distance / length
    return (1 + z + z**2 / 3) * np.exp(-z)


class States:
    """Every reading in the coordinates of the discrepancy: command, direction and way covered; how alike the runs are."""

    def __init__(self, runs):
        self.command, self.direction, self.way = [], [], []
        reach = {True: 1e-300, False: 1e-300}
        for run in runs:
            last, command = np.zeros(2), []
            for c in run["command"]:
                last = last if c is None else np.array(c)
                command.append(last)
            self.command.append(np.array(command))
            reach[run["displacement"]] = max(reach[run["displacement"]], np.linalg.norm(command, axis=1).max())
        self.knows_rest = [reach[run["displacement"]] > 1e-12 for run in runs]
        for r, run in enumerate(runs):
            if self.knows_rest[r]:
                self.command[r] = self.command[r] / reach[run["displacement"]]
            self.direction.append(self.directions(self.command[r]))
            self.way.append(np.concatenate([[0], np.cumsum(np.linalg.norm(np.diff(self.command[r], axis=0), axis=1))]))
        longest = max(way[-1] for way in self.way) or 1
        self.way = [way / longest for way in self.way]
        rest = np.array([run["rest"] for run in runs])
        square = ((rest[:, None] - rest[None]) ** 2).mean(2)
        same = np.equal.outer([r["displacement"] for r in runs], [r["displacement"] for r in runs])
        self.alike = same * np.exp(-square / (2 * 0.3**2))

    @staticmethod
    def directions(command):
        moved = command - command[0]
        axis = np.linalg.eigh(moved.T @ moved)[1][:, 1]
        first = np.nonzero(np.linalg.norm(moved, axis=1) > 0.02)[0]
        if len(first) and axis @ moved[first[0]] < 0:
            axis = -axis
        result, last = [1.0], 1.0
        for step in np.diff(command, axis=0) @ axis:
            last = np.sign(step) if abs(step) > 1e-9 else last
            result.append(last)
        return np.array(result)

    def covariance(self, places, length):
        run = np.array([p[0] for p in places])
        command = np.array([self.command[r][i] for r, i in places])
        direction = np.array([self.direction[r][i] for r, i in places])
        way = np.array([self.way[r][i] for r, i in places])
        known = np.array([self.knows_rest[r] for r in run], float)
        distance = np.linalg.norm(command[:, None] - command[None], axis=2)
        common = matern(distance, length) * (0.6 + 0.4 * np.outer(direction, direction))
        at_rest = matern(np.linalg.norm(command, axis=1), length) * (0.6 + 0.4 * direction)
        common -= (1 - AT_REST) * known[:, None] * np.outer(at_rest, at_rest)
        at_start = matern(way, length)
        own = matern(np.abs(way[:, None] - way[None]), length) - (1 - AT_REST) * np.outer(at_start, at_start)
        own *= np.equal.outer(run, run) * known[:, None]
        return 0.7 * self.alike[np.ix_(run, run)] * common + 0.3 * own


class Block:
    """The likelihood of one channel on the grids of correlation, length, amplitude and scale."""

    def __init__(self, data, states, first, count):
        self.rows = np.arange(first, first + count)
        outlier = np.array(data["outlier"])[self.rows]
        self.kept = self.rows[~outlier]
        nominal = np.array(data["nominal"])
        self.unit = max(1e-3, np.sqrt(np.mean(nominal[self.kept] ** 2))) if len(self.kept) else 1e-3
        low, high = 0.25, max(4.0, 1.3 * self.unit)
        steps = int(np.clip(np.ceil(np.log(high / low) / np.log(1.25)), 10, 24))
        self.scale = low * (high / low) ** (np.arange(steps + 1) / steps)
        self.log_scale = log_normalised(-2.5 * np.log1p((np.log(self.scale) / 0.25) ** 2 / 4))
        larger = self.scale >= 1
        self.nugget = np.where(larger, -np.log(larger.sum()) - self.log_scale, -np.inf)
        places = [data["places"][i] for i in self.rows]
        whole = [states.covariance(places, length) for length in LENGTH]
        at = self.kept - first
        periodic = np.array(data["periodic"]).reshape(-1, len(nominal)).T[self.kept]
        relative, sigma = np.array(data["relative"]), np.array(data["sigma"])
        self.cells = []
        for rho, log_rho in zip(CORRELATION, LOG_CORRELATION):
            white, log_det = self.whitening(data["places"], relative, sigma, rho)
            if periodic.size:
                columns = white @ periodic[:, np.abs(periodic).sum(0) > 0]
                q = np.linalg.qr(columns)[0] if columns.size else np.zeros((len(at), 0))
                white, lost = white - q @ (q.T @ white), q.shape[1]
            else:
                lost = 0
            for k in whole:
                values, axes = np.linalg.eigh(white @ k[np.ix_(at, at)] @ white.T)
                self.cells.append((white, np.maximum(values, 0), axes, log_rho - np.log(3) - log_det / 2, lost, k[:, at]))

    def whitening(self, places, relative, sigma, rho):
        n = len(self.kept)
        white, log_det = np.zeros((n, n)), 0.0
        for j, i in enumerate(self.kept):
            r = 0.0
            if j > 0 and places[i][0] == places[self.kept[j - 1]][0]:
                r = rho ** (places[i][1] - places[self.kept[j - 1]][1])
            s = np.sqrt(1 - r**2)
            white[j, j] = 1 / (relative[i] * s)
            if r:
                white[j, j - 1] = -r / (relative[self.kept[j - 1]] * s)
            log_det += 2 * np.log(relative[i] * s * sigma[i])
        return white, log_det

    def grid(self, residual):
        """Log likelihood by [cell][amplitude][scale]."""
        result = []
        for white, values, axes, constant, lost, _ in self.cells:
            along = (axes.T @ (white @ residual[self.kept])) ** 2
            variance = (AMPLITUDE * self.unit)[:, None, None] ** 2 * values + self.scale[None, :, None] ** 2
            n = len(self.kept) - lost
            log_det = np.log(variance).sum(2) - lost * np.log(self.scale**2)
            result.append(constant + self.log_scale - (log_det + (along / variance).sum(2) + n * np.log(2 * np.pi)) / 2)
        return np.array(result)

    def step(self, places, run, reading, residual):
        """Log Bayes factor of a step that begins with that reading, and lasts to the end of its run, over noise alone."""
        column = np.array([places[i][0] == run and places[i][1] >= reading for i in self.kept], float)
        noise = self.grid(residual)[:, 0]
        prior, gain = (2 * self.unit) ** -2, []
        for white, *_ in self.cells:
            step = white @ column
            information, along = step @ step / self.scale**2, step @ (white @ residual[self.kept]) / self.scale**2
            gain.append(along**2 / (information + prior) / 2 - np.log1p(information / prior) / 2)
        return log_sum(noise + np.array(gain)) - log_sum(noise)

    def size_of_nugget(self, grid):
        """Its posterior mean, in declared sigmas."""
        weight = np.exp(grid[:, 0] + self.nugget - log_sum(grid[:, 0] + self.nugget)).sum(0)
        return weight @ np.sqrt(np.maximum(self.scale**2 - 1, 0))


class Likelihood:
    def __init__(self, data):
        self.data = data
        states = States(data["runs"])
        self.blocks = [Block(data, states, *b) for b in data["blocks"]]
        self.outlier = np.array(data["outlier"])
        self.gap = max(1e-3, np.sqrt(np.mean(np.array(data["nominal"])[~self.outlier] ** 2)))
        periodic = np.array(data["periodic"]).reshape(-1, len(self.outlier)).T
        self.periodic, self.weight = periodic, np.where(self.outlier, 0, 1 / np.array(data["relative"]))

    def look(self, residual, jacobian):
        """Log likelihood by amplitude and with a nugget; Gauss and Newton's gradient and information by the parameters;
        what is left in standard deviations."""
        grids = [b.grid(residual) for b in self.blocks]
        by_amplitude = sum(np.array([log_sum(g[:, a]) for a in range(len(AMPLITUDE))]) for g in grids)
        nugget = np.array([log_sum(g[:, 0] + b.nugget) - log_sum(g[:, 0]) for b, g in zip(self.blocks, grids)])
        share = np.exp(log_normalised(nugget))
        size = sum(w * b.size_of_nugget(g) for w, b, g in zip(share, self.blocks, grids)) / self.gap
        nugget = (by_amplitude[0] + log_sum(nugget) - np.log(len(nugget)), size)
        alone = [log_sum([log_sum(g[:, a]) + LOG_OUTSIDE[a] for a in range(len(AMPLITUDE))]) - log_sum(g[:, 0]) for g in grids]
        self.one_channel = by_amplitude[0] + log_sum(alone) - np.log(len(alone))
        posterior = log_normalised(by_amplitude + LOG_LISTED)
        information, gradient = np.zeros((jacobian.shape[1],) * 2), np.zeros(jacobian.shape[1])
        left, sigma = residual.copy(), np.array(self.data["relative"])
        for b, g in zip(self.blocks, grids):
            of_amplitude = np.array([log_sum(g[:, a]) for a in range(len(AMPLITUDE))])
            weight = np.exp(g - of_amplitude[None, :, None] + posterior[None, :, None])
            for w, (white, values, axes, *_) in zip(weight, b.cells):
                variance = (AMPLITUDE * b.unit)[:, None, None] ** 2 * values + b.scale[None, :, None] ** 2
                precision = (w[:, :, None] / variance).sum((0, 1))
                slopes, along = axes.T @ (white @ jacobian[b.kept]), axes.T @ (white @ residual[b.kept])
                information += slopes.T @ (precision[:, None] * slopes)
                gradient -= slopes.T @ (precision * along)
            c, a, s = np.unravel_index(np.argmax(weight), weight.shape)
            white, values, axes, _, _, cross = b.cells[c]
            size = (AMPLITUDE[a] * b.unit) ** 2
            mean = axes.T @ (white @ residual[b.kept]) / (size * values + b.scale[s] ** 2)
            left[b.rows] -= size * cross @ (white.T @ (axes @ mean))
            sigma[b.rows] *= b.scale[s]
        if self.periodic.size:
            fit = np.linalg.lstsq(self.weight[:, None] * self.periodic, self.weight * left, rcond=None)[0]
            left -= self.periodic @ fit
        z = left / sigma
        own = np.array([log_sum([log_outlier(x), log_inlier(x)]) for x in z]) - np.log(sigma * np.array(self.data["sigma"]))
        marked = np.where(self.outlier, own, np.log(1 - SHARE)).sum()
        inlier = np.exp(log_inlier(z) - np.array([log_sum([log_outlier(x), log_inlier(x)]) for x in z]))
        curve = np.where(self.outlier, inlier + (1 - inlier) * 2 / (WIDTH**2 + z**2), 0)
        slopes = jacobian / sigma[:, None]
        gradient, information = gradient - slopes.T @ (curve * z), information + slopes.T @ (curve[:, None] * slopes)
        self.one_channel += marked
        return by_amplitude + marked, (nugget[0] + marked, nugget[1]), gradient, information, z


    def log_step(self, residual):
        """Log Bayes factor of a step at any reading but the first of a run, in each channel or not, over noise alone."""
        places = sorted({tuple(p) for p in self.data["places"]})
        later = [p for before, p in zip(places, places[1:]) if before[0] == p[0]]
        sums = [sum(log_sum([b.step(self.data["places"], *p, residual), 0]) - np.log(2) for b in self.blocks) for p in later]
        return log_sum(sums) - np.log(len(sums)) if sums else -np.inf


def log_volume(parameters, gradient, information, temper):
    """The share of the prior that the readings leave, by Laplace's method."""
    inside, widths, total = [], [], 0.0
    for p, one in enumerate(parameters):
        sides = 1 if one["low"] < 0 else 2
        x = one["value"] / one["scale"]
        if one["prior"] == "gaussian":
            peak, density = sides / (one["scale"] * np.sqrt(2 * np.pi)), -(x**2) / 2
        elif one["prior"] == "cauchy":
            peak, density = sides / (np.pi * one["scale"]), -np.log1p(x**2)
        else:
            peak, density = 1 / (one["high"] - one["low"]), 0
        density += np.log(peak)
        if one["at_bound"]:
            total -= np.log1p(temper * abs(gradient[p]) / np.exp(density))
        elif information[p, p] > 0:
            inside.append(p)
            widths.append(1 / (peak * np.sqrt(2 * np.pi)))
            total += density + np.log(2 * np.pi) / 2 + np.log(widths[-1])
    if inside:
        unit = np.array(widths)
        precisions = np.linalg.eigvalsh(unit[:, None] * information[np.ix_(inside, inside)] * unit)
        total -= 0.5 * np.log1p(temper * np.maximum(precisions, 0)).sum()
    return total


def local_departure(data, z):
    """Log Bayes factor of one event in a few neighbouring readings of a run over independent outliers."""
    channel = np.concatenate([np.full(count, b) for b, (_, count) in enumerate(data["blocks"])])
    sums = []
    for run in {p[0] for p in data["places"]}:
        here = [i for i, p in enumerate(data["places"]) if p[0] == run]
        readings = 1 + max(data["places"][i][1] for i in here)
        gain = {c: np.zeros(readings) for c in channel[here]}
        for i in here:
            gain[channel[i]][data["places"][i][1]] = log_outlier(z[i]) - np.log(SHARE) - log_sum([log_outlier(z[i]), log_inlier(z[i])])
        for i in range(readings):
            for j in range(i, min(readings, i + int(np.clip(readings // 4, 1, 8)))):
                sums.append(sum(log_sum([g[i : j + 1].sum(), 0]) - np.log(2) for g in gain.values()))
    return log_sum(sums) - np.log(len(sums))


def noise_alone(factors):
    """The probability that readings that scatter by these factors more than others do so by noise."""
    factors = np.array(factors, float)
    cause = (1 - NO_GAP) * OUTSIDE * NUGGET / NO_GAP / np.log(100)
    noise = 0.375 / 0.25 * (1 + (np.log(factors) / 0.25) ** 2 / 4) ** -2.5
    return np.prod(noise / (noise + cause))


def split(weight, size, own, exact):
    """Between the cause and one outside, where a share of that size is left to what the catalogue does not have."""
    size = max(1e-3, size)
    odds = (LOG_LISTED[1] + AMPLITUDE[1] / 0.1 - size / 0.1) - (LOG_OUTSIDE[1] - np.log(AMPLITUDE[1]) + np.log(size))
    odds += np.log((1 - OUTSIDE) / OUTSIDE)
    return [(weight - np.log1p(np.exp(odds)), "outside", exact), (weight - np.log1p(np.exp(-odds)), own, exact)]


def rows(data, looks, nominal, nugget, local, step, one_channel, temper):
    """Every way in which the readings may have come about: log weight, cause (None: no gap), whether nothing is left."""
    def of(log_by_amplitude, prior):
        joint = temper * log_by_amplitude + prior
        return joint[0], log_sum(joint[1:])

    gap = np.log(1 - NO_GAP)
    nothing, by_noise = np.log(NO_GAP) + temper * nominal[0], noise_alone(data["noisier"])
    result = [(nothing + np.log(by_noise), None, True)]
    if by_noise < 1:
        result.append((nothing + np.log(1 - by_noise), "outside", True))
    result.append((gap + np.log(OUTSIDE * (1 - LOCAL - NUGGET - STEP - ONE_CHANNEL)) + of(nominal, LOG_OUTSIDE)[1], "outside", False))
    result.append((gap + np.log(OUTSIDE * LOCAL) + temper * (nominal[0] + local), "outside", True))
    result.append((gap + np.log(OUTSIDE * NUGGET) + temper * nugget[0], "outside", True))
    result.append((gap + np.log(OUTSIDE * ONE_CHANNEL) + temper * one_channel, "outside", False))
    result.append((gap + np.log(OUTSIDE * STEP) + temper * (nominal[0] + step), "outside", True))
    for one, (by_amplitude, (log_nugget, nugget_size), gradient, information) in zip(data["hypotheses"], looks):
        base = gap + one["log_prior"] + log_volume(one["parameters"], gradient, information, temper)
        own = sorted(e["label"] for e in one["effects"] if not e["outside"] and not e["tolerance"])
        own = tuple(own or sorted(e["label"] for e in one["effects"] if not e["outside"]))
        if any(e["outside"] for e in one["effects"]):
            whole = base + log_sum(temper * by_amplitude + LOG_LISTED)
            if own:
                result += split(whole, one["discrepancy"], own, False)
            else:
                result.append((whole, "outside", False))
            continue
        exact, some = of(by_amplitude, LOG_LISTED)
        result += [(base + np.log(1 - OUTSIDE) + exact, own, True), (base + np.log(1 - OUTSIDE) + some, own, False)]
        result.append((base + np.log(OUTSIDE) + of(by_amplitude, LOG_OUTSIDE)[1], "outside", False))
        result += split(base + np.log(NUGGET) + temper * log_nugget, nugget_size, own, True)
    return result


def decide(data):
    likelihood = Likelihood(data)
    nominal, nugget, _, _, z = likelihood.look(np.array(data["nominal"]), np.zeros((len(data["nominal"]), 0)))
    looks, one_channel = [], likelihood.one_channel
    for one in data["hypotheses"]:
        residual = np.array(one["residual"])
        looks.append(likelihood.look(residual, np.array(one["jacobian"]).reshape(-1, len(residual)).T)[:4])
    local, step = local_departure(data, z), likelihood.log_step(np.array(data["nominal"]))

    def probabilities(temper):
        all_rows = rows(data, looks, nominal, nugget, local, step, one_channel, temper)
        weight = np.exp(log_normalised([r[0] for r in all_rows]))
        return [(w, cause, exact) for w, (_, cause, exact) in zip(weight, all_rows)]

    exact = sum(w for w, _, nothing_left in probabilities(1) if nothing_left)
    sums = {}
    for w, cause, _ in probabilities(exact + (1 - exact) * TEMPER):
        sums[cause] = sums.get(cause, 0) + w
    no_gap, outside = sums.pop(None), sums.pop("outside")
    causes = sorted(sums.items(), key=lambda kv: -kv[1])
    if no_gap > 0.5:
        return "none", set(), no_gap, outside
    if outside > sum(p for _, p in causes):
        return "unknown", set(), no_gap, outside
    others = 1 if outside >= 1 / WRONG else 0
    named = [causes[0][0]] + [c for c, p in causes[1:] if p >= 1 / WRONG]
    named = named[: LARGEST - others]
    return ("identified" if len(named) + others == 1 else "ambiguous"), set(named), no_gap, outside


def main(program, *folders):
    agree, total = 0, 0
    for folder in folders:
        data = json.loads(subprocess.run([program, folder], check=True, capture_output=True, text=True).stdout)
        verdict, named, no_gap, outside = decide(data)
        same = verdict == data["verdict"] and named == {tuple(n) for n in data["named"]}
        agree, total = agree + same, total + 1
        if not same:
            print(f"{folder}: the page {verdict} {sorted(named)} (no gap {no_gap:.3f}, outside {outside:.3f}), the program "
                  f"{data['verdict']} {data['named']} ({data['no_gap']:.3f}, {data['outside']:.3f})")
    print(f"{agree} of {total} verdicts agree")
    return 0 if agree >= 0.95 * total else 1


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
