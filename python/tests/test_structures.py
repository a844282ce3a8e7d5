"""Other ends and loads, against the published reference values and closed forms."""
import decimal
import json
import re
import pathlib
import subprocess
import sys

import numpy as np
import plumbline
import pytest

ROOT = pathlib.Path(__file__).parents[2]
CANTILEVER = {"lengths": [1, 1], "stiffness": [1, 1], "end_point": "free"}
FOLLOWER = {**CANTILEVER, "masses": [2, 1], "loads": [{"follower": 1}]}

UNIVERSAL = {"lengths": [1, 1, 1], "joints": [{"axes": [[0, 0, 1], [0, 1, 0]], "stiffness": [1, 3]}] * 3}


def test_equal_links_fixed_and_free_are_the_textbook_s():
    for n in (1, 2, 7, 30):
        found = plumbline.critical_factors({"lengths": np.ones(n), "stiffness": [1] * n, "end_point": "free"})
        m = np.arange(1, n + 1)
        np.testing.assert_allclose(found, 4 * np.sin((2 * m - 1) * np.pi / (4 * n + 2)) ** 2, rtol=1e-14)


def test_the_paper_s_ends_have_the_critical_forces():
    lengths, stiffness = ["1.1", 1, decimal.Decimal("0.7"), 2], [0.5, 1, 2, "1e-3"]
    assert (plumbline.critical_factors({"lengths": lengths, "stiffness": stiffness}, digits=40)
            == plumbline.critical_forces(lengths, stiffness, digits=40)).all()


def test_every_kind_of_end_support_and_load_is_read():
    chain = {"lengths": [1, 2, 1], "stiffness": [0, 1, "1.5"], "base": {"turn": "held"},
             "end_point": {"across": 0.5, "turn": 0.25}, "supports": [{"at": 3, "across": 2}], "foundation": "0.1",
             "loads": [{"weight": [1, 2, 1]}, {"force": [-1, 0], "at": 2, "fixed": True}]}
    assert len(plumbline.critical_factors(chain)) == 2
    text = 'lengths = [1, 1]\nstiffness = [1, 1]\nend_point = "free"\n'
    assert plumbline.critical_factors(text, lowest=1, digits=6, number=str).tolist() == ["0.381966"]


def test_in_space_the_weaker_plane_gives_way_first():
    found = plumbline.critical_factors(UNIVERSAL)
    plane = [plumbline.critical_forces([1, 1, 1], [k] * 3) for k in (1, 3)]
    np.testing.assert_allclose(found, np.sort(np.concatenate(plane)), rtol=1e-14)


def test_a_follower_force_makes_ziegler_s_pendulum_flutter():
    loss = plumbline.stability_loss(FOLLOWER)
    assert (loss.kind, loss.first) == ("flutter", True)
    assert loss.factor == pytest.approx(3.5 - 2 ** 0.5, rel=1e-15)


@pytest.mark.parametrize("chain", [CANTILEVER, FOLLOWER, UNIVERSAL])
def test_certificates_hold(chain, tmp_path):
    text = plumbline.structure_certificate(chain, digits=30, name="two links")
    assert json.loads(text)["certificates"][0]["structure"] == "two links"
    (tmp_path / "certificates.json").write_text(text)
    checker = ROOT / "proofs/certificates/check_structures.py"
    subprocess.run([sys.executable, "-B", checker, tmp_path / "certificates.json"], check=True)


@pytest.mark.parametrize("change, message", [
    ({"end_point": "loose"}, "end_point: found"),
    ({"loads": [{"weight": 1, "force": [-1, 0]}]}, "in one load"),
    ({"stiffness": [0, 1]}, "mechanism"),
    ({"colour": "red"}, "colour"),
    ({"lengths": [1, float("nan")]}, "lengths"),
    ({"loads": [{"follower": 1}]}, "follower"),
])
def test_what_is_wrong_is_one_line(change, message):
    with pytest.raises(plumbline.Error, match=message) as error:
        plumbline.critical_factors({**CANTILEVER, **change})
    assert "\n" not in str(error.value)


def as_chain(entry):
    """A reference structure as a chain file has it."""
    n = len(entry["lengths"])
    loads = []
    for load in entry["loads"]:
        force = decimal.Decimal(load["force"])
        one = {"follower": -force} if load["follows"] else {"force": [force, 0]}
        loads.append({**one, "at": load["at"] + 1 if load["at"] < n else "end_point", "fixed": not load["multiplied"]})
    supports = [{"at": i + 2, "across": across} for i, across in enumerate(entry["across"]) if across != "free"]
    chain = {name: entry[name] for name in ("lengths", "stiffness", "base", "end_point", "masses") if name in entry}
    return {**chain, **({"supports": supports} if supports else {}), "loads": loads}


def test_fifty_digits_are_the_reference_values():
    with open(ROOT / "verify/reference/values/structures.json", encoding="utf-8") as file:
        structures = json.load(file)["structures"]
    for entry in structures:
        # a chain file has decimals; thirds are exact in the reference alone
        if len(entry["lengths"]) > 7 or re.search(r'"-?\d+/\d+"', json.dumps(entry)):
            continue
        chain = as_chain(entry)
        if entry["kind"] == "buckling":
            factors = plumbline.critical_factors(chain, digits=50, lowest=len(entry["factor"]), number=str).tolist()
        else:
            loss = plumbline.stability_loss(chain, digits=50, number=str)
            assert loss.kind == entry["kind"]
            factors = [loss.factor]
        assert factors == entry["factor"], entry["structure"]


UPRIGHT = {"lengths": [1, 1, 1], "stiffness": [2, 1, 1], "end_point": "free", "loads": [{"weight": 1}]}


def test_a_column_under_its_weight_leaves_the_line_where_it_buckles():
    pytest.importorskip("pandas")
    way = plumbline.structure_path(UPRIGHT, factor=0.4)
    assert list(way.columns[:3]) == ["factor", "x", "y"] and way["factor"].iloc[-1] == 0.4
    assert (way["negative_directions"] == 0).all()
    buckled = way[way["y"].abs() > 1e-6]
    assert buckled["factor"].min() >= float(plumbline.critical_factors(UPRIGHT, lowest=1)[0]) - 1e-9
    other = plumbline.structure_path(UPRIGHT, factor=0.4, side=-1)
    assert other["y"].iloc[-1] == pytest.approx(-way["y"].iloc[-1], rel=1e-9)


def test_a_proved_list_of_equilibria_is_complete():
    pytest.importorskip("pandas")
    sampled, proved = plumbline.structure_equilibria(UPRIGHT, factor=0.4), plumbline.structure_equilibria(UPRIGHT, factor=0.4, certify=True)
    assert len(sampled) == len(proved) == 3  # the line, and what it buckles to on either side
    assert proved.attrs["complete"] and not sampled.attrs["complete"]
    np.testing.assert_allclose(sorted(sampled["energy"]), sorted(proved["energy"].astype(float)), rtol=1e-10)


def test_a_chain_that_is_none_is_refused_in_one_line():
    with pytest.raises(plumbline.Error, match="lengths"):
        plumbline.structure_path({"lengths": [1, -1], "stiffness": [1, 1], "end_point": "free"})
