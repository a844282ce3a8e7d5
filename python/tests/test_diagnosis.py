"""The diagnosis from arrays is the diagnosis from files."""
import json
import os
import pathlib
import subprocess

import numpy as np
import plumbline
import pytest

ROOT = pathlib.Path(__file__).parents[2]
FOLDER = ROOT / "docs/examples/experiment"
RESTS = {"u-press": [-0.32, 0.06, 0.38, 0.35], "z-press": [-0.24, 0.68, -0.80, 0.52],
         "u-aside": [-0.30, 0.10, 0.30, 0.30], "u-again": [-0.36, 0.08, 0.36, 0.30]}
NOMINAL = {"link_length": np.full(4, 0.25), "joint_stiffness": np.full(4, 2.0)}
NOISE = {"Fx": 0.02, "Fy": 0.02}
BENCH = {"gravity_plane": "horizontal"}


def samples(run):
    table = np.genfromtxt(FOLDER / f"{run}.csv", delimiter=",", names=True)
    return {name: table[name] for name in table.dtype.names}


def run(name, **changes):
    return {"id": name, "control": "displacement", "rest": RESTS[name], "samples": samples(name), **changes}


@pytest.fixture(scope="module")
def diagnosis():
    shares = []
    found = plumbline.diagnose(NOMINAL, [run(name) for name in RESTS], noise=NOISE, bench=BENCH, name="four-link bench",
                               progress=shares.append)
    assert shares[-1] == 1 and shares == sorted(shares)
    return found


def test_the_json_is_that_of_the_command_line(diagnosis):
    command = subprocess.run([os.environ["PLUMBLINE"], "diagnose", FOLDER, "--json", "-"], capture_output=True, check=True)
    reports = [json.loads(text) for text in (command.stdout, diagnosis.to_json(), plumbline.diagnose_folder(FOLDER).to_json())]
    came_from = [report.pop("provenance") for report in reports]
    assert reports[0] == reports[1] == reports[2]
    assert came_from[0]["inputs_sha256"] == came_from[2]["inputs_sha256"]  # of the same files
    assert came_from[2]["command"] == f"plumbline.diagnose_folder('{FOLDER}')"


def test_the_report_names_the_cause(diagnosis):
    assert diagnosis.verdict == "identified"
    assert [effect["id"] for effect in diagnosis.report["cause"]["effects"]] == ["joint_friction"]
    assert str(diagnosis).startswith("four-link bench\n") and "Identified: joint_friction" in str(diagnosis)


def test_the_page_stands_in_a_frame(diagnosis):
    page, frame = diagnosis.to_html(), diagnosis._repr_html_()
    assert page.startswith("<!DOCTYPE html>") and "<svg" in page
    assert frame.startswith("<iframe srcdoc=") and frame.count("<") == 2  # itself and its end: all else is escaped


def test_a_curve_is_told_in_a_line(diagnosis):
    first = diagnosis.curves()[0]
    assert repr(first) == f"<plumbline.Curve {first.channel} ({first.unit}) of run {first.run!r}: {len(first.measured)} readings>"


def test_curves_hold_what_was_measured_and_the_corrected_model_is_nearer(diagnosis):
    curves = diagnosis.curves()
    assert [(curve.run, curve.channel) for curve in curves] == [(name, force) for force in ("Fx", "Fy") for name in RESTS]
    for curve in curves:
        np.testing.assert_array_equal(curve.measured, samples(curve.run)[curve.channel])
        # 43 readings tell a standard deviation of 0.02 to about a tenth
        assert np.std(curve.measured - curve.corrected) < min(0.024, np.std(curve.measured - curve.nominal))


def test_the_curves_are_drawn(diagnosis):
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("Agg")
    figure = diagnosis.plot()
    assert [axes.get_title() for axes in figure.axes][:3] == ["u-press: Fx", "u-press: Fy", "z-press: Fx"]


def test_a_frame_of_pandas_and_other_units_mean_the_same(diagnosis):
    pandas = pytest.importorskip("pandas")
    runs = []
    for name in RESTS:
        frame = pandas.DataFrame(samples(name)).rename(columns={"Fx": "pull"})
        frame["pull"] = np.round(-1000 * frame["pull"])  # mN, and of the other sign
        runs.append(run(name, samples=frame))
    columns = {"Fx": {"column": "pull", "unit": "mN", "sign": -1}}
    found = plumbline.diagnose(NOMINAL, runs, noise={"Fx": 20, "Fy": 0.02}, bench=BENCH, columns=columns,
                               name="four-link bench")
    assert found.report["cause"] == diagnosis.report["cause"]


def test_a_finger_is_bent_by_its_tendon_alone():
    tension = np.concatenate([np.arange(13.0), np.arange(11.0, -1, -1)])
    stiffness, radius, rest = np.array([0.16, 0.12, 0.10]), np.array([0.008, 0.006, 0.005]), np.array([0.2, 0.3, 0.2])
    angles = rest + tension[:, None] * radius / (stiffness * [1, 0.8, 1])
    angles += np.random.default_rng(3).normal(0, 0.002, angles.shape)
    table = {"t": 2 * np.arange(25.0), "pull": 1000 * tension, "q1": angles[:, 0], "q2": angles[:, 1], "q3": angles[:, 2]}
    found = plumbline.diagnose({"link_length": [0.045, 0.03, 0.025], "joint_stiffness": stiffness, "rest": rest},
                               [{"id": "bend", "control": "force", "samples": table}], noise={"q": 0.002}, bench=BENCH,
                               loads=[{"tendon": "tension", "radius": 1000 * radius}], units={"radius": "mm"},
                               columns={"covariate": {"tension": {"column": "pull", "unit": "mN"}}})
    assert [(effect["id"], effect["joint"]) for effect in found.report["cause"]["effects"]] == [("joint_stiffness", 2)]
    assert found.curves()[0].command == "tension, N"


def broken(**changes):
    readings = samples("u-press")
    readings.update(changes)
    return readings


@pytest.mark.parametrize("changes, runs, message", [
    ({}, [{"id": "a"}], "experiment: run[1].samples: found no such key, expected columns of readings"),
    ({}, [run("u-press", rest=[0, 0])], "experiment: run[1].rest: found 2 values, expected 4, one for each link of the nominal chain"),
    ({}, [run("u-press", control="push")],
     "experiment: run[1].control: found 'push', expected \"displacement\", \"force\" or \"command\""),
    ({}, [run("u-press", speed=1)], "experiment: run[1].speed: found an unknown key, expected one of "),
    ({}, [run("u-press"), run("u-press")], 'experiment: run[2].id: found "u-press" again, expected an id that no other'),
    ({"nominal": {**NOMINAL, "joint_stiffness": [1, 1, -1, 1]}}, [run("u-press")],
     "experiment: nominal.joint_stiffness[3]: found -1, expected zero (passive) or a positive stiffness"),
    ({"noise": {"Fx": "much"}}, [run("u-press")], "experiment: noise.Fx: found 'much', expected a number, zero or"),
    ({}, [run("u-press", samples=broken(Fx=[1, 2]))], "experiment: run[1].samples.Fx: found 2 readings, expected 47"),
    ({}, [run("u-press", samples=broken(Fx=np.full(47, np.inf)))], 'samples of run "u-press":1, Fx: found \'inf\''),
    ({}, [run("u-press", samples=broken(x=np.full(47, np.nan)))],
     'samples of run "u-press":1: found an empty imposed channel, expected the commanded x and y'),
    ({}, [run("u-press", samples=broken(t=np.arange(47)[::-1]))], 'samples of run "u-press":2, t: found 45, expected'),
    ({}, [run("u-press", samples={"x": [1.0], "Fx": [0.0]})], "samples of run \"u-press\": found no column 'y'"),
    ({}, [run("u-press", samples=broken(x=np.full(47, 7.0)))], 'run "u-press", reading 1: found an end point 7'),
    ({"nominal": "arm.obj"}, [run("u-press")], "arm.obj: found "),
])
def test_errors_name_the_place_as_for_files(changes, runs, message):
    given = {"nominal": NOMINAL, "noise": NOISE, "bench": BENCH, **changes}
    with pytest.raises(plumbline.Error) as raised:
        plumbline.diagnose(given.pop("nominal"), runs, **given)
    assert str(raised.value).startswith(message) and "\n" not in str(raised.value)


def test_a_sign_that_looks_wrong_is_asked_about_first():
    turned = [run(name, samples={key: -v if key in ("Fx", "Fy") else v for key, v in samples(name).items()}) for name in RESTS]
    with pytest.raises(plumbline.Error, match="sign"):
        plumbline.diagnose(NOMINAL, turned, noise=NOISE, bench=BENCH)


def test_an_interrupt_ends_a_diagnosis():
    class Stop(Exception):
        pass

    def stop(_):
        raise Stop

    with pytest.raises(Stop):
        plumbline.diagnose(NOMINAL, [run("u-press")], noise=NOISE, bench=BENCH, progress=stop)
