"""Critical forces of straight elastic chains in plain Python floats.

usage: critical_forces.py CHAINS.csv > VALUES.csv

An example of an implementation to be checked: `plumbline check VALUES.csv` judges what this writes.
"""
import csv
import sys


def count_below(length, stiffness, force):
    """How many critical forces lie below a force: sign changes along the chain of
    h_{i+1} = h_i + z_{i+1}^2 / k_{i+1} g_{i+1}, where g_{i+1} = g_i - F L_i h_i / (z_i z_{i+1})."""
    distance = distances_to_end(length)
    h, g = 1.0, stiffness[0] / distance[0] / distance[0]
    count, positive = 0, True
    for i in range(1, len(length)):
        g -= force * h * length[i - 1] / distance[i - 1] / distance[i]
        if stiffness[i] > 0:
            h += distance[i] / stiffness[i] * distance[i] * g
        else:  # a passive joint: what follows starts afresh
            h, g = g, 0.0
        if h != 0 and (h > 0) != positive:
            count, positive = count + 1, not positive
        if abs(h) > 1e100:  # or long chains overflow
            h, g = h * 1e-100, g * 1e-100
        elif abs(h) < 1e-100 and abs(g) < 1e-100:
            h, g = h * 1e100, g * 1e100
    return count


def distances_to_end(length):
    """z_i = L_i + ... + L_n."""
    distance, total = [], 0.0
    for x in reversed(length):
        total += x
        distance.append(total)
    return distance[::-1]


def critical_force(length, stiffness, mode):
    """Bisection, geometric as long as the bounds differ by a factor, down to neighbouring floats."""
    low, high = 0.0, 1.0
    while count_below(length, stiffness, high) < mode:
        low, high = high, high * 1024
    while low == 0.0:
        trial = high / 1024
        if count_below(length, stiffness, trial) < mode:
            low = trial
        else:
            high = trial
    while True:
        middle = (low * high) ** 0.5 if high > 2 * low else (low + high) / 2
        if not low < middle < high:
            return middle
        if count_below(length, stiffness, middle) < mode:
            low = middle
        else:
            high = middle


def main():
    with open(sys.argv[1], newline="", encoding="utf-8") as file:
        chains = list(csv.DictReader(file))
    print("chain,mode,force")
    for chain in chains:
        length = [float(x) for x in chain["lengths"].split(";")]
        stiffness = [float(x) for x in chain["stiffness"].split(";")]
        modes = len(length) - 1 if len(length) <= 30 else 2
        for mode in range(1, modes + 1):
            print(chain["chain"], mode, repr(critical_force(length, stiffness, mode)), sep=",")


main()
