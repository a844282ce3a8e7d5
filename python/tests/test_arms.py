"""Arms in space from arrays and DataFrames: the diagnosis is that of the folder, and the corrected model the edited file."""
import json
import pathlib
import tomllib

import numpy as np
import pandas
import pytest

import plumbline
from plumbline.program import run as program

FOLDER = pathlib.Path(__file__).parents[2] / "docs/examples/arm"
SETTINGS = tomllib.loads((FOLDER / "experiment.toml").read_text())

URDF = """<robot name="bench">
  <link name="base_link"/>
  <link name="column"><inertial><origin xyz="0 0 0.15"/><mass value="3"/>
    <inertia ixx="0.04" iyy="0.04" izz="0.01" ixy="0" ixz="0" iyz="0"/></inertial></link>
  <link name="upper"><inertial><origin xyz="0.2 0 0"/><mass value="2"/>
    <inertia ixx="0.002" iyy="0.03" izz="0.03" ixy="0" ixz="0" iyz="0"/></inertial></link>
  <link name="fore"><inertial><origin xyz="0.05 0 0"/><mass value="1"/>
    <inertia ixx="0.001" iyy="0.001" izz="0.001" ixy="0" ixz="0" iyz="0"/></inertial></link>
  <link name="roll"/>
  <link name="hand"/>
  <link name="tool0"/>
  <joint name="pan" type="continuous"><parent link="base_link"/><child link="column"/><axis xyz="0 0 1"/></joint>
  <joint name="lift" type="revolute"><parent link="column"/><child link="upper"/>
    <origin xyz="0 0 0.3" rpy="0 0.2 0.1"/><axis xyz="0 1 0"/><limit lower="-1.5" upper="1.5" effort="50" velocity="1"/></joint>
  <joint name="elbow" type="revolute"><parent link="upper"/><child link="fore"/>
    <origin xyz="0.4 0 0"/><axis xyz="0 1 0"/><limit lower="-1.5" upper="1.5" effort="50" velocity="1"/></joint>
  <joint name="roll" type="continuous"><parent link="fore"/><child link="roll"/><origin xyz="0.1 0 0"/><axis xyz="1 0 0"/></joint>
  <joint name="bend" type="continuous"><parent link="roll"/><child link="hand"/><origin xyz="0.25 0 0"/><axis xyz="0 1 0"/></joint>
  <joint name="flange" type="fixed"><parent link="hand"/><child link="tool0"/><origin xyz="0.1 0 0"/></joint>
</robot>
"""
BALL = [0.05, 0.03, 0.02]
NOISE = 3e-5  # m
WRONG_ZERO = np.array([0, 0, 0.01, 0, 0])  # rad


def samples(name):
    table = np.genfromtxt(FOLDER / f"{name}.csv", delimiter=",", names=True)
    return {column: table[column] for column in table.dtype.names}


def run(name="loaded", **changes):
    return {"id": name, "samples": samples(name), **changes}


def changed(**columns):
    """The readings with some columns changed, or left out where there is none."""
    return run(samples={name: values for name, values in {**samples("loaded"), **columns}.items() if values is not None})


def ball(arm, q):
    """Where the arm has the ball, in the world."""
    at = arm.base_frame
    for frame, (x, y, z), angle in zip(arm.frames, arm.axes, q):
        cross, turn = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]]), np.eye(4)
        turn[:3, :3] += np.sin(angle) * cross + (1 - np.cos(angle)) * cross @ cross
        at = at @ frame @ turn
    return (at @ arm.tip_frame @ [*BALL, 1])[:3]


@pytest.fixture(scope="module")
def urdf(tmp_path_factory):
    file = tmp_path_factory.mktemp("model") / "bench.urdf"
    file.write_text(URDF)
    return file


@pytest.fixture(scope="module")
def poses(urdf):
    """Where a tracker saw the ball on the arm whose elbow has a wrong zero."""
    arm, random = plumbline.read_arm(urdf), np.random.default_rng(7)
    commands = random.uniform(-1.2, 1.2, (40, 5))
    places = np.array([ball(arm, q + WRONG_ZERO) for q in commands]) + random.normal(0, NOISE, (40, 3))
    return pandas.DataFrame(np.hstack([commands, places]),
                            columns=[*(f"q_command{j}" for j in range(1, 6)), "ball_x", "ball_y", "ball_z"])


@pytest.fixture(scope="module")
def of_file(urdf, poses):
    return plumbline.diagnose_arm(urdf, [{"id": "poses", "samples": poses}], noise={"place": NOISE}, name="bench",
                                  points=[{"name": "ball", "body": "tool0", "offset": BALL}])


@pytest.fixture(scope="module")
def example():
    """One run in arrays, one in a DataFrame with a column of words."""
    shares, frame = [], pandas.DataFrame(samples("loaded"))
    frame["remark"] = "warm"
    found = plumbline.diagnose_arm(SETTINGS["arm"], [run("unloaded"), run("loaded", samples=frame)], noise=SETTINGS["noise"],
                                   units=SETTINGS["units"], columns={"ignore": ["remark"]}, name=SETTINGS["name"],
                                   progress=shares.append)
    assert shares[-1] == 1 and shares == sorted(shares)
    return found


def without_provenance(diagnosis):
    report = json.loads(diagnosis.to_json())
    return report, report.pop("provenance")


def test_arrays_and_a_frame_give_the_report_of_the_folder(example):
    (report, came_from), (of_folder, _) = map(without_provenance, (example, plumbline.diagnose_folder(FOLDER)))
    assert report == of_folder
    assert came_from["command"] == "plumbline.diagnose_arm(…)"
    assert ("rest_angle", 3) in {(effect["id"], effect["joint"]) for effect in report["cause"]["effects"]}
    assert example.to_html().startswith("<!DOCTYPE html>") and str(example).startswith("six axes\n")


def test_curves_of_poses_stand_by_their_readings(example):
    curves = example.curves()
    assert {(curve.run, curve.channel) for curve in curves} == {(name, axis) for name in ("unloaded", "loaded")
                                                                for axis in ("x1", "y1", "z1")}
    for curve in curves:
        assert (curve.command, curve.unit) == ("reading", "m")
        np.testing.assert_array_equal(curve.along, np.arange(25))
        np.testing.assert_allclose(1000 * curve.measured, samples(curve.run)[f"tip_{curve.channel[0]}"], rtol=1e-12)
    left, before = (sum(np.sum((curve.measured - getattr(curve, model)) ** 2) for curve in curves)
                    for model in ("corrected", "nominal"))
    # 150 values tell a variance to about an eighth
    assert left < 1.5 * 150 * NOISE ** 2 < before


def test_what_the_models_leave_of_poses_is_drawn(example):
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("Agg")
    figure = example.plot(run="loaded")
    assert [axes.get_title() for axes in figure.axes] == ["loaded: x1", "loaded: y1", "loaded: z1"]
    assert figure.axes[2].get_ylabel() == "z1, measured less model, m" and figure.axes[2].get_xlabel() == "reading"
    drawn = {line.get_label(): line.get_ydata() for line in figure.axes[2].lines}
    curve = next(curve for curve in example.curves() if (curve.run, curve.channel) == ("loaded", "z1"))
    np.testing.assert_array_equal(drawn["nominal model"], curve.measured - curve.nominal)
    np.testing.assert_array_equal(drawn[curve.model], curve.measured - curve.corrected)


def test_an_arm_is_read_as_arrays(urdf):
    arm = plumbline.read_arm(urdf)
    assert repr(arm) == "<plumbline.Arm RRRRR, 'base_link' to 'tool0': 6 kg, 0 of 5 joints yield>"
    assert arm.joints == ["pan", "lift", "elbow", "roll", "bend"]
    assert arm.links == ["column", "upper", "fore", "roll", "hand"]
    assert (arm.frames.shape, arm.tip_frame.shape) == ((5, 4, 4), (4, 4))
    np.testing.assert_array_equal(arm.masses, [3, 2, 1, 0, 0])
    np.testing.assert_allclose(arm.axes[3], [1, 0, 0], atol=1e-16)
    np.testing.assert_array_equal(arm.limits, [[-np.inf, np.inf], [-1.5, 1.5], [-1.5, 1.5], [-np.inf, np.inf], [-np.inf, np.inf]])
    forward = 0.9 * np.cos(0.2) + 0.02 * np.sin(0.2)
    np.testing.assert_allclose(ball(arm, np.zeros(5)), [np.cos(0.1) * forward - np.sin(0.1) * 0.03,
                                                        np.sin(0.1) * forward + np.cos(0.1) * 0.03,
                                                        0.3 - 0.9 * np.sin(0.2) + 0.02 * np.cos(0.2)], rtol=1e-12)
    assert plumbline.read_arm(urdf, base="column", tip="fore").joints == ["lift", "elbow"]


def leaves(table):
    """Numbers and words of a table by their places."""
    if not isinstance(table, (dict, list)):
        return {"": table}
    entries = table.items() if isinstance(table, dict) else enumerate(table)
    return {f"{key}.{place}": value for key, entry in entries for place, value in leaves(entry).items()}


def test_settings_are_those_that_the_program_prints(urdf):
    printed = tomllib.loads(program("arm", urdf))["arm"]
    assert printed["joint"][3].pop("link") == "roll"  # that of its joint too: in a table a name stands once
    # the program prints twelve digits
    assert leaves(plumbline.read_arm(urdf).settings()) == pytest.approx(leaves(printed), rel=1e-11, abs=1e-11)


def test_the_corrected_urdf_is_the_file_with_the_correction(of_file, urdf, poses, tmp_path):
    assert [(effect["id"], effect["joint"]) for effect in of_file.report["cause"]["effects"]] == [("rest_angle", 3)]
    model = of_file.corrected_models("urdf")[0]
    assert "Edited: bench.urdf." in model.text and '<mass value="3"' in model.text
    assert [(effect, carried) for effect, carried, _ in model.effects] == [("frame of joint elbow", True)]
    arm = plumbline.read_arm(model.write(tmp_path / "corrected.urdf"))
    commands, places = np.split(poses.to_numpy(), [5], axis=1)
    left = np.array([ball(arm, q) for q in commands]) - places
    assert np.sqrt(np.mean(left ** 2)) < 1.5 * NOISE
    with pytest.raises(plumbline.Error, match="expected a file .urdf, or .toml"):
        of_file.corrected_models("xml")


def test_a_folder_with_the_model_says_the_same(of_file, urdf, poses, tmp_path):
    (tmp_path / "bench.urdf").write_text(urdf.read_text())
    poses.to_csv(tmp_path / "poses.csv", index=False)
    (tmp_path / "experiment.toml").write_text(f"""format = "chain-experiment/1"
name = "bench"
arm = {{ model = "bench.urdf", point = [{{ name = "ball", body = "tool0", offset = {BALL} }}] }}
noise = {{ place = {NOISE} }}
run = [{{ id = "poses", samples = "poses.csv" }}]
""")
    of_folder = plumbline.diagnose_folder(tmp_path)
    assert without_provenance(of_folder)[0] == without_provenance(of_file)[0]
    assert [one.text for one in of_folder.corrected_models("urdf")] == [one.text for one in of_file.corrected_models("urdf")]


def test_an_arm_that_was_read_is_one_joint_by_joint(of_file, urdf, poses):
    found = plumbline.diagnose_arm(plumbline.read_arm(urdf), [{"id": "poses", "samples": dict(poses)}], noise={"place": NOISE},
                                   points=[{"name": "ball", "offset": BALL}], name="bench")
    assert [(effect["id"], effect["joint"]) for effect in found.report["cause"]["effects"]] == [("rest_angle", 3)]
    assert found.report["joint_names"] == of_file.report["joint_names"]
    assert tomllib.loads(found.corrected_models()[0].text)["arm"]["joint"][2]["name"] == "elbow"
    with pytest.raises(plumbline.Error, match="found an arm that was not read from a file of this format, expected a file .toml"):
        found.corrected_models("urdf")


@pytest.mark.parametrize("changes, runs, message", [
    ({"arm": "nowhere.urdf"}, [run()], "nowhere.urdf: found "),
    ({"arm": "arm.obj"}, [run()], "arm.obj: found "),
    ({"arm": 5}, [run()], "model: found int, expected a file (MJCF, URDF, SDF) or a mujoco.MjSpec"),
    ({"arm": {}}, [run()], "experiment: found neither arm.model nor arm.joint, expected one of them"),
    ({"arm": {**SETTINGS["arm"], "speed": 1}}, [run()], "experiment: arm.speed: found an unknown key, expected one of "),
    ({"arm": {**SETTINGS["arm"], "joint_stiffness": [1, 2]}}, [run()], "experiment: arm.joint_stiffness: found "),
    ({"points": [{"name": "tip", "body": "hand"}]}, [run()], 'experiment: arm.point[1].body: found "hand", expected one of tip, '),
    ({"points": [{"name": "a"}], "arm": {**SETTINGS["arm"], "point": [{"name": "b"}]}}, [run()],
     "points: found beside the key 'point' of the arm, expected one of the two"),
    ({"load": "flange"}, [run()], "experiment: arm.load: found 'flange', expected a table [load]"),
    ({"noise": {"x": 1}}, [run()], "experiment: noise.x: found an unknown key, expected one of "),
    ({"noise": {}}, [run()], 'noise.place: found 0, or nothing, expected a positive figure: run "loaded" measures it'),
    ({"units": {"place": "furlong"}}, [run()], "experiment: units.place: found "),
    ({"columns": {"drop": ["t"]}}, [run()], "experiment: columns.drop: found an unknown key, expected one of Fx Fy"),
    ({}, [], "experiment: run: found "),
    ({}, [{"id": "a"}], "experiment: run[1].samples: found no such key, expected columns of readings"),
    ({}, [run(), run()], 'experiment: run[2].id: found "loaded" again, expected an id that no other run has'),
    ({}, [run(loaded_by="crane")], "experiment: run[1].loaded_by: found 'crane', expected \"servo\" or \"weights\""),
    ({}, [run(samples=[1, 2])], "experiment: run[1].samples: found list, expected columns by name"),
    ({}, [changed(q_command3=None)],
     "samples of run \"loaded\": found no column 'q_command3', which the run imposes"),
    ({}, [changed(humidity=np.zeros(25))], "samples of run \"loaded\": found a column 'humidity', expected t, q_command1"),
    ({}, [changed(remark=["warm"] * 25)], "experiment: run[1].samples.remark, entry 1: found 'warm', expected a number"),
    ({}, [changed(tip_x=[1.0, 2.0])], "experiment: run[1].samples.tip_x: found 2 readings, expected 25 as in t"),
    ({}, [changed(tip_x=np.full(25, np.inf))], 'samples of run "loaded":1, tip_x: found \'inf\''),
    ({}, [changed(q_command1=np.full(25, np.nan))],
     'samples of run "loaded":1: found an empty q_command, expected the commanded angle of every joint'),
    ({"units": {}}, [run()], "experiment: found readings in which places look like mm"),
])
def test_errors_name_the_place(changes, runs, message):
    given = {"arm": SETTINGS["arm"], "noise": SETTINGS["noise"], "units": SETTINGS["units"], **changes}
    with pytest.raises(plumbline.Error) as raised:
        plumbline.diagnose_arm(given.pop("arm"), runs, **given)
    assert str(raised.value).startswith(message) and "\n" not in str(raised.value)


def test_what_is_no_arm_is_refused_in_a_line(urdf):
    with pytest.raises(plumbline.Error, match="bench.urdf: found no body or frame gripper, expected one of base_link, "):
        plumbline.read_arm(urdf, tip="gripper")
    with pytest.raises(plumbline.Error, match="^nowhere.urdf: found "):
        plumbline.read_arm("nowhere.urdf")
    with pytest.raises(plumbline.Error, match="^model: found list, expected a file"):
        plumbline.read_arm([1, 2])
