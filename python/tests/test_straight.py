"""The straight chain, against the published reference values."""
import csv
import decimal
import json
import pathlib
import subprocess
import sys
import threading

import mpmath
import numpy as np
import plumbline
import pytest

ROOT = pathlib.Path(__file__).parents[2]


def reference():
    """Every chain of the set with its critical forces as texts."""
    with open(ROOT / "verify/reference/values/chains.csv", encoding="utf-8") as file:
        chains = {row["chain"]: (row["lengths"].split(";"), row["stiffness"].split(";")) for row in csv.DictReader(file)}
    forces = {}
    with open(ROOT / "verify/reference/values/forces.csv", encoding="utf-8") as file:
        for row in csv.DictReader(file):
            forces.setdefault(row["chain"], []).append(row["force"])
    return [(*chains[name], forces[name]) for name in chains]


def test_doubles_agree_with_every_reference_value():
    # Rounding the inputs moves a force by six times that at most (verify/reference/values/README.md), and the result is rounded.
    for lengths, stiffness, forces in reference():
        found = plumbline.critical_forces(np.array(lengths, dtype=float), np.array(stiffness, dtype=float),
                                          lowest=len(forces))
        np.testing.assert_allclose(found, [float(force) for force in forces], rtol=8 * 2.0 ** -52)


def test_fifty_digits_are_the_reference_values():
    for lengths, stiffness, forces in reference():
        if len(lengths) <= 12:
            assert plumbline.critical_forces(lengths, stiffness, digits=50, lowest=len(forces), number=str).tolist() == forces


def test_digits_come_as_what_is_wanted():
    lengths, stiffness = [1, decimal.Decimal("1.5"), mpmath.mpf("0.25")], [0.5, "1", 2]
    decimals = plumbline.critical_forces(lengths, stiffness, digits=40)
    assert isinstance(decimals[0], decimal.Decimal) and len(decimals[0].as_tuple().digits) == 40
    with mpmath.workdps(45):
        precise = plumbline.critical_forces(lengths, stiffness, digits=40, number=mpmath.mpf)
        assert mpmath.almosteq(precise[0], mpmath.mpf(str(decimals[0])), 1e-39)
    assert np.allclose(plumbline.critical_forces(lengths, stiffness), decimals.astype(float), rtol=1e-14)


def test_modes_solve_the_linear_equations():
    # (29) in the moments about each joint: k_i q_i = F sum_{j >= i} z_max(i, j) q_j + Fy z_i
    rng = np.random.default_rng(1)
    for n in (2, 5, 9):
        lengths, stiffness = rng.uniform(0.5, 2, n), rng.uniform(0.5, 2, n)
        modes = plumbline.critical_modes(lengths, stiffness)
        z = np.cumsum(lengths[::-1])[::-1]
        assert len(modes) == n - 1 and np.all(np.diff(modes.force) > 0)
        for force, q, fy in zip(modes.force, modes.q, modes.fy):
            heights = np.array([sum(z[j] * q[j] for j in range(n)) * 0 + sum(lengths[m] * q[: m + 1].sum()
                                for m in range(i, n)) for i in range(n)])
            balance = stiffness * q - force * heights + fy * z
            assert np.abs(balance).max() < 1e-11 * np.abs(stiffness * q).max() or np.abs(
                stiffness * q - force * heights - fy * z).max() < 1e-11 * np.abs(stiffness * q).max()


def test_a_batch_is_what_each_chain_gives_alone():
    rng = np.random.default_rng(2)
    lengths, stiffness = rng.uniform(0.1, 10, (3000, 6)), rng.uniform(0.1, 10, (3000, 6))
    forces = plumbline.lowest_critical_forces(lengths, stiffness)
    assert forces.shape == (3000,)
    alone = [plumbline.critical_forces(L, k, lowest=1)[0] for L, k in zip(lengths[:50], stiffness[:50])]
    np.testing.assert_allclose(forces[:50], alone, rtol=1e-15)
    np.testing.assert_array_equal(plumbline.lowest_critical_forces(lengths[::2], np.asfortranarray(stiffness[::2])),
                                  forces[::2])


@pytest.mark.parametrize("lengths, stiffness, message", [
    ([1], [1], "chain: found one link, expected two links or more: a single link has no buckling mode"),
    ([1, -1], [1, 1], "lengths, entry 2: found a value that is not positive, expected a positive length"),
    ([1, float("nan")], [1, 1], "lengths, entry 2: found a value that is not finite, expected a finite number"),
    ([1, 1], [0, 0], "stiffness: found 2 passive joints, expected at most one: with two the chain is a mechanism"),
])
def test_errors_are_exceptions_of_one_line(lengths, stiffness, message):
    with pytest.raises(ValueError) as raised:
        plumbline.critical_forces(lengths, stiffness)
    assert type(raised.value) is plumbline.Error and str(raised.value) == message


def test_a_wrong_chain_of_a_batch_is_named():
    with pytest.raises(plumbline.Error, match="^chain 2: lengths, entry 1: "):
        plumbline.lowest_critical_forces([[1, 1], [-1, 1]], [[0, 1], [0, 1]])


def test_other_threads_go_on_while_forces_are_computed():
    counted, stop = [0], threading.Event()

    def count():
        while not stop.is_set():
            counted[0] += 1

    lengths = np.linspace(1, 2, 16000)  # a third of a second, for a busy machine may keep a thread waiting
    counter = threading.Thread(target=count)
    counter.start()
    try:
        before = counted[0]
        plumbline.critical_forces(lengths, lengths)
        # with the lock held, not one turn of the loop falls between the two
        assert counted[0] > before + 1000
    finally:
        stop.set()
        counter.join()


def test_a_table_of_modes():
    pandas = pytest.importorskip("pandas")
    table = plumbline.critical_modes([1, 1, 1, 1], [1, 1, 1, 1]).to_pandas()
    assert isinstance(table, pandas.DataFrame)
    assert list(table.columns) == ["force", "fy", "shape", "signs", "q1", "q2", "q3", "q4"]
    assert list(table.index) == [1, 2, 3] and table["shape"][1] == "U"


def test_the_stand_alone_checker_accepts_a_certificate(tmp_path):
    file = tmp_path / "certificates.json"
    text = plumbline.critical_certificate([1, 0.5, 2], [0, 1, 3], digits=30, name="mine")
    file.write_text(text, encoding="utf-8")
    assert json.loads(text)["provenance"]["command"].startswith("plumbline.critical_certificate(['1', '0.5', '2'], ")
    checker = [sys.executable, "-B", str(ROOT / "proofs/certificates/check_certificates.py"), str(file)]
    assert subprocess.run(checker, capture_output=True, check=False).returncode == 0
    file.write_text(text.replace('"0.5"', '"0.6"'), encoding="utf-8")
    assert subprocess.run(checker, capture_output=True, check=False).returncode != 0
