"""Critical forces to 40 digits beside an eigenvalue solver that shares nothing with them: mpmath's, at 75 digits or more.

    forty_digits.test.py PLUMBLINE [CHAINS]

Random chains of 2 to 39 links, whose lengths and stiffnesses reach over up to six powers of ten; some are pinned at the
base. Where the inner joints of a straight chain lie y_i aside, its links have theta_i = (y_i - y_(i-1)) / L_i, and twice its
energy under the end force P is the sum of k_i (theta_i - theta_(i-1))^2 - P L_i theta_i^2: the critical forces are the
eigenvalues of one quadratic form in y against another.
"""
import json
import multiprocessing
import random
import subprocess
import sys
import tempfile

from mpmath import eigsy, mp, mpf, zeros


def form(weights, rows):
    """The matrix of sum_r weights_r (rows_r . y)^2, rows as dictionaries."""
    size = max(max(row) for row in rows) + 1
    matrix = zeros(size, size)
    for weight, row in zip(weights, rows):
        for i, a in row.items():
            for j, b in row.items():
                matrix[i, j] += weight * a * b
    return matrix


def divided_by_factor(matrix, factor):
    """C^-1 matrix for the lower bidiagonal factor C."""
    size = matrix.rows
    result = zeros(size, size)
    for column in range(size):
        for i in range(size):
            known = factor[i, i - 1] * result[i - 1, column] if i > 0 else 0
            result[i, column] = (matrix[i, column] - known) / factor[i, i]
    return result


def critical_forces(length, stiffness):
    n = len(length)
    slope = [{j: s / length[i] for j, s in ((i, 1), (i - 1, -1)) if 0 <= j < n - 1} for i in range(n)]
    turn = [{j: slope[i].get(j, 0) - (slope[i - 1].get(j, 0) if i > 0 else 0)
             for j in {*slope[i], *(slope[i - 1] if i > 0 else ())}} for i in range(n)]
    springs, shortening = form(stiffness, turn), form(length, slope)
    factor = mp.cholesky(shortening)
    half = divided_by_factor(springs, factor)
    return sorted(eigsy(divided_by_factor(half.T, factor), eigvals_only=True))


def check(task):
    program, seed, folder = task
    draw = random.Random(seed)
    n, powers = draw.randint(2, 39), draw.choice([0.1, 1, 3, 6])
    length, stiffness = ([f"{10 ** draw.uniform(-powers / 2, powers / 2):.5e}" for _ in range(n)] for _ in range(2))
    if draw.random() < 0.3:
        stiffness[0] = "0"
    path = f"{folder}/{seed}.toml"
    with open(path, "w") as file:
        file.write(f"link_length = [{', '.join(length)}]\njoint_stiffness = [{', '.join(stiffness)}]\n")
    answer = subprocess.run([program, "critical", path, "--all", "--digits", "40", "--json", "-"], capture_output=True,
                            text=True, check=True)
    mp.dps = 75 + 4 * int(powers)
    found = [mpf(mode["force"]) for mode in json.loads(answer.stdout)["chains"][0]["modes"]]
    true = critical_forces([mpf(x) for x in length], [mpf(x) for x in stiffness])
    assert len(found) == len(true), f"chain {seed}: {len(found)} forces of {len(true)}"
    return len(found), max(abs(a / b - 1) for a, b in zip(found, true))


def main():
    program, chains = sys.argv[1], int(sys.argv[2]) if len(sys.argv) > 2 else 20
    with tempfile.TemporaryDirectory() as folder, multiprocessing.Pool() as pool:
        results = pool.map(check, [(program, seed, folder) for seed in range(1, chains + 1)])
    worst = max(error for _, error in results)
    print(f"{sum(count for count, _ in results)} loads of {chains} chains, worst relative error {mp.nstr(worst, 3)}")
    # 40 digits, rounded: a number that begins with 1 is off by 5e-40 of itself at most.
    sys.exit(worst > mpf("5.01e-40"))


if __name__ == "__main__":
    main()
