"""The likelihood with its discrepancy and noise, by docs/how-it-decides.md, from what the rig predicts (hypotheses.cpp)."""
import numpy as np

from volume import log_half_cauchy, log_normalised, log_size, log_smaller, log_sum

AMPLITUDE = np.array([0, 0.01, 0.02, 0.04, 0.08, 0.16, 0.32, 0.64, 1.28])
LENGTH = [0.15, 0.4, 1.0]
CORRELATION = np.array([0, 0.35, 0.65, 0.85, 0.95])
TYPICAL = 0.1
AT_REST = 0.2  # of the variance of the discrepancy
SHARE, WIDTH, EVIDENCE = 0.02, 10, 50  # of outliers


def log_listed(exact):
    """By amplitude, beside a cause of the catalogue whose model is exact with this probability."""
    small = np.where(AMPLITUDE > 0, np.exp(-AMPLITUDE / 0.1), 0)
    with np.errstate(divide="ignore"):
        return np.where(AMPLITUDE > 0, np.log((1 - exact) * small / small.sum()), np.log(exact))


EXACT = 0.5
LOG_CORRELATION = log_normalised(-((CORRELATION / 0.3) ** 2) / 2)


class Outliers:
    def __init__(self, marked):
        self.share = (EVIDENCE * SHARE + max(1, marked.sum()) - 1) / (EVIDENCE + len(marked) - 1)

    def outlier(self, z):
        return np.log(self.share / (WIDTH * np.pi)) - np.log1p((z / WIDTH) ** 2)

    def inlier(self, z):
        return np.log((1 - self.share) / np.sqrt(2 * np.pi)) - z**2 / 2

    def either(self, z):
        return np.logaddexp(self.outlier(z), self.inlier(z))


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
        run = np.array([data["places"][i][0] for i in self.kept])
        steps = np.abs(np.diff(nominal[self.kept]))[np.diff(run) == 0]
        quiet = 0.5 * np.median(steps) / 0.6745 / np.sqrt(2) if len(steps) else 1
        low, high = np.clip(quiet, 0.02, 0.25), max(4.0, 1.3 * self.unit)
        steps = int(np.clip(np.ceil(np.log(high / low) / np.log(1.25)), 10, 30))
        self.scale = low * (high / low) ** (np.arange(steps + 1) / steps)
        self.log_scale = log_normalised(-2.5 * np.log1p((np.log(self.scale) / 0.25) ** 2 / 4))
        larger = self.scale >= 1
        self.nugget = np.where(larger, -np.log(larger.sum()) - self.log_scale, -np.inf)
        value = np.array(data["value"])[self.rows]
        self.typical = max(1.0, TYPICAL * np.sqrt(np.mean(((value - value.mean()) / np.array(data["sigma"])[self.rows]) ** 2)))
        self.clock = data["clock"]
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
            if j > 0 and places[i][0] == places[self.kept[j - 1]][0] and self.clock[places[i][0]]:
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
        width, gain = 0.04 * self.unit * 2.0 ** np.arange(8), []
        for white, *_ in self.cells:
            step = white @ column
            information, along = step @ step / self.scale**2, step @ (white @ residual[self.kept]) / self.scale**2
            terms = [log_smaller(width[0] / np.sqrt(2) / self.typical) + 0 * along]
            terms += [log_size(w / self.typical) + along**2 / (information + w**-2) / 2 - np.log1p(information * w**2) / 2 for w in width]
            gain.append([log_sum([t[s] for t in terms]) for s in range(len(self.scale))])
        return log_sum(noise + np.array(gain)) - log_sum(noise)

    def discrepancy(self, grid):
        """By amplitude, its variance over that of the noise, one at most."""
        quiet = [np.exp(grid[:, a] - log_sum(grid[:, a])).sum(0) @ self.scale**-2 for a in range(len(AMPLITUDE))]
        return np.minimum(1, (AMPLITUDE * self.unit) ** 2 * np.array(quiet))

    def size_of_nugget(self, grid):
        """Its posterior mean, in declared sigmas."""
        weight = np.exp(grid[:, 0] + self.nugget - log_sum(grid[:, 0] + self.nugget)).sum(0)
        return weight @ np.sqrt(np.maximum(self.scale**2 - 1, 0))


def expected(log_likelihood, log_prior, values):
    return np.exp(log_normalised(log_likelihood + log_prior)) @ values


class Look:
    """What is said of one residual: by amplitude, and by kind of a cause outside the catalogue."""


class Likelihood:
    def __init__(self, data):
        self.data = data
        self.states = States(data["runs"])
        self.blocks = [Block(data, self.states, *b) for b in data["blocks"]]
        self.outlier = np.array(data["outlier"])
        self.outliers = Outliers(self.outlier)
        self.gap = max(1e-3, np.sqrt(np.mean(np.array(data["nominal"])[~self.outlier] ** 2)))
        count = np.array([len(b.rows) for b in self.blocks])
        self.share = count / count.sum()
        self.typical = np.exp(self.share @ np.log([b.typical / b.unit for b in self.blocks]))
        self.log_outside = np.append(log_smaller(AMPLITUDE[1] / np.sqrt(2) / self.typical), log_size(AMPLITUDE[1:] / self.typical))
        self.log_imitated = np.append(-np.inf, log_half_cauchy(AMPLITUDE[1:] / self.typical))
        periodic = np.array(data["periodic"]).reshape(-1, len(self.outlier)).T
        self.periodic, self.weight = periodic, np.where(self.outlier, 0, 1 / np.array(data["relative"]))

    def look(self, residual, jacobian):
        """Gauss and Newton's gradient and information are by the parameters; z is what is left in standard deviations."""
        look = Look()
        grids = [b.grid(residual) for b in self.blocks]
        channel = [np.array([log_sum(g[:, a]) for a in range(len(AMPLITUDE))]) for g in grids]
        by_amplitude = sum(channel)
        discrepancy = [b.discrepancy(g) for b, g in zip(self.blocks, grids)]
        look.discrepancy = self.share @ np.array(discrepancy)
        nugget = np.array([log_sum(g[:, 0] + b.nugget) - log_sum(g[:, 0]) for b, g in zip(self.blocks, grids)])
        share = np.exp(log_normalised(nugget))
        look.scatter_size = sum(w * b.size_of_nugget(g) for w, b, g in zip(share, self.blocks, grids)) / self.gap
        alone = np.array([log_sum(c + self.log_outside) - c[0] for c in channel])
        look.alone = np.exp(log_normalised(alone)) @ [expected(c, self.log_outside, d) for c, d in zip(channel, discrepancy)] / len(alone)
        posterior = log_normalised(by_amplitude + log_listed(EXACT))
        information, gradient = np.zeros((jacobian.shape[1],) * 2), np.zeros(jacobian.shape[1])
        left, sigma = residual.copy(), np.array(self.data["relative"])
        for b, g, c in zip(self.blocks, grids, channel):
            weight = np.exp(g - c[None, :, None] + posterior[None, :, None])
            for w, (white, values, axes, *_) in zip(weight, b.cells):
                variance = (AMPLITUDE * b.unit)[:, None, None] ** 2 * values + b.scale[None, :, None] ** 2
                precision = (w[:, :, None] / variance).sum((0, 1))
                slopes, along = axes.T @ (white @ jacobian[b.kept]), axes.T @ (white @ residual[b.kept])
                information += slopes.T @ (precision[:, None] * slopes)
                gradient -= slopes.T @ (precision * along)
            cell, a, k = np.unravel_index(np.argmax(weight), weight.shape)
            white, values, axes, _, _, cross = b.cells[cell]
            size = (AMPLITUDE[a] * b.unit) ** 2
            mean = axes.T @ (white @ residual[b.kept]) / (size * values + b.scale[k] ** 2)
            left[b.rows] -= size * cross @ (white.T @ (axes @ mean))
            sigma[b.rows] *= b.scale[k]
        if self.periodic.size:
            fit = np.linalg.lstsq(self.weight[:, None] * self.periodic, self.weight * left, rcond=None)[0]
            left -= self.periodic @ fit
        look.z = z = left / sigma
        own = self.outliers.either(z) - np.log(sigma * np.array(self.data["sigma"]))
        marked = np.where(self.outlier, own, np.log(1 - self.outliers.share)).sum()
        inlier = np.exp(self.outliers.inlier(z) - self.outliers.either(z))
        curve = np.where(self.outlier, inlier + (1 - inlier) * 2 / (WIDTH**2 + z**2), 0)
        slopes = jacobian / sigma[:, None]
        look.gradient, look.information = gradient - slopes.T @ (curve * z), information + slopes.T @ (curve[:, None] * slopes)
        look.by_amplitude = by_amplitude + marked
        look.scatter = look.by_amplitude[0] + log_sum(nugget) - np.log(len(nugget))
        look.one_channel = look.by_amplitude[0] + log_sum(alone) - np.log(len(alone))
        return look

    def log_step(self, residual):
        """Log Bayes factor of a step at any reading but the first of a run, in each channel or not, over noise alone."""
        places = sorted({tuple(p) for p in self.data["places"]})
        later = [p for before, p in zip(places, places[1:]) if before[0] == p[0]]
        sums = [sum(log_sum([b.step(self.data["places"], *p, residual), 0]) - np.log(2) for b in self.blocks) for p in later]
        return log_sum(sums) - np.log(len(sums)) if sums else -np.inf
