"""Equilibria and paths of loaded chains."""
import json
import pathlib
import subprocess
import sys

import numpy as np
import plumbline
import pytest

ROOT = pathlib.Path(__file__).parents[2]
Z = ([1, 1, 1, 1], [1, 1, 1, 1], [-0.2417, 0.6821, -0.7958, 0.5170])  # of the paper's Table 1


def end_points(lengths, q):
    theta = np.cumsum(q, axis=-1)
    return np.stack([np.cos(theta) @ lengths, np.sin(theta) @ lengths], axis=-1)


def checked(script, text, tmp_path):
    file = tmp_path / "certificate.json"
    file.write_text(text, encoding="utf-8")
    return subprocess.run([sys.executable, "-B", str(ROOT / "proofs/certificates" / script), str(file)], capture_output=True,
                          check=False).returncode


def test_every_point_of_a_path_is_in_balance():
    lengths, stiffness, rest = (np.array(part, dtype=float) for part in Z)
    path = plumbline.path(*Z, to=1.5)
    assert repr(path).startswith("<plumbline.Path along (") and len(repr(path)) < 100
    assert len(path.branches) == 1 and path.branches[0].event_kinds == ["quasi-buckling"]
    points = path.branches[0].points
    np.testing.assert_allclose(points.end_point, end_points(lengths, points.q), atol=1e-12)
    theta = np.cumsum(points.q, axis=1)
    for i in range(4):  # k_i (q_i - rest_i) is the moment of the force about joint i
        arm_x, arm_y = np.cos(theta[:, i:]) @ lengths[i:], np.sin(theta[:, i:]) @ lengths[i:]
        moment = arm_x * points.force[:, 1] - arm_y * points.force[:, 0]
        np.testing.assert_allclose(stiffness[i] * (points.q[:, i] - rest[i]), moment, atol=1e-10)
    np.testing.assert_allclose(points.energy, 0.5 * ((points.q - rest) ** 2 @ stiffness), atol=1e-12)
    # Table "events" of the reference values: case paper-four-link-z
    assert path.branches[0].events.load[0] == pytest.approx(0.5851967123556739, abs=1e-9)


def test_a_path_as_a_table_has_the_rows_of_the_command_line():
    pytest.importorskip("pandas")
    path = plumbline.path(*Z, to=1.5)
    table = path.to_pandas()
    assert list(table.columns)[:2] == ["branch", "point"] and list(table["event"]).count("quasi-buckling") == 1
    assert len(table) == len(path.branches[0].points) + 1
    assert table["load"].is_monotonic_increasing


def test_a_path_is_drawn():
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("Agg")
    axes = plumbline.path(*Z, to=0.5).plot()
    assert axes.get_xlabel() == "deflection along the load" and len(axes.lines) == 3


def test_a_certified_path_and_its_certificate(tmp_path):
    chain = ([1, 1], [1, 1], [0.3, -0.5])
    path = plumbline.path(*chain, to=0.3, certify=True)
    assert [proof.certified for proof in path.proofs] == [True] and path.proofs[0].failure is None
    text = plumbline.path_certificate(*chain, to=0.3)
    assert json.loads(text)["provenance"]["command"].startswith("plumbline.path_certificate(['1', '1'], ")
    assert checked("check_paths.py", text, tmp_path) == 0
    assert checked("check_paths.py", text.replace("0.3", "0.4"), tmp_path) != 0


@pytest.mark.parametrize("given", [{"at": (0.4, 0)}, {"end_point": ("2.5", 0.25)}, {"force": (-0.4, 0)}])
def test_equilibria_found_are_those_proved(given):
    found, proved = plumbline.equilibria(*Z, **given), plumbline.equilibria(*Z, **given, certify=True)
    assert proved.complete and not found.complete and len(found) == len(proved)
    np.testing.assert_allclose(found.energy, proved.energy, rtol=1e-9)
    np.testing.assert_allclose(found.q, proved.q, atol=1e-7)
    np.testing.assert_array_equal(found.stable, proved.stable)
    assert proved.stable.any()


def test_digits_of_proved_equilibria_are_those_of_more_digits():
    few = plumbline.equilibria(*Z, at=(0.4, 0), certify=True, digits=20, number=str)
    many = plumbline.equilibria(*Z, at=(0.4, 0), certify=True, digits=35, number=str)
    assert few.q.shape == many.q.shape == (len(few), 4)
    for short, long in zip(few.energy, many.energy):
        assert abs(float(short) - float(long)) == 0 and len(long) > len(short)


def test_a_certificate_of_equilibria(tmp_path):
    text = plumbline.equilibria_certificate([1, 1], [0, 1], [0, 0], end_point=("1.6", 0))
    assert checked("check_equilibria.py", text, tmp_path) == 0
    assert checked("check_equilibria.py", text.replace('"1.6"', '"1.5"'), tmp_path) != 0


@pytest.mark.parametrize("given, message", [
    ({}, "load: found neither to nor force, expected one"),
    ({"to": 1, "force": (1, 0)}, "load: found both to and force, expected one"),
    ({"to": 0}, "load: found nothing to do, expected a finite load that is not zero"),
    ({"force": (float("inf"), 0)}, "load: found (inf, 0), expected two finite numbers"),
    ({"to": 0.1, "branches": "some"}, "branches: found 'some', expected 'stable' or 'all'"),
])
def test_a_wrong_load_is_one_line(given, message):
    with pytest.raises(plumbline.Error) as raised:
        plumbline.path(*Z, **given)
    assert str(raised.value) == message


def test_out_of_reach_is_one_line():
    with pytest.raises(plumbline.Error, match="^end point: found distance 9 from the base, expected "):
        plumbline.equilibria(*Z, end_point=(9, 0))
