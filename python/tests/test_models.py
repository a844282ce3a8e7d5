"""Models, drafts and corrected models from Python."""
import json
import pathlib

import numpy as np
import pandas
import pytest

import plumbline

ARM = """<mujoco><compiler angle="radian"/><option gravity="0 0 0"/>
<worldbody><body name="a"><joint name="j1" axis="0 0 1"/><geom type="capsule" size="0.01" fromto="0 0 0 0.3 0 0" mass="0.05"/>
<body name="b" pos="0.3 0 0"><joint name="j2" axis="0 0 1"/><geom type="capsule" size="0.01" fromto="0 0 0 0.2 0 0" mass="0.05"/>
<site name="tip" pos="0.2 0 0"/></body></body></worldbody>
<actuator><position name="m1" joint="j1" kp="2"/><position name="m2" joint="j2" kp="1.5"/></actuator>
<keyframe><key name="home" ctrl="0.4 -0.9"/></keyframe></mujoco>
"""


@pytest.fixture
def arm(tmp_path: pathlib.Path) -> pathlib.Path:
    file = tmp_path / "arm.xml"
    file.write_text(ARM)
    return file


def held(softer: float = 1.0) -> pandas.DataFrame:
    """The arm loaded at its end point, without friction: where its springs hold the force."""
    stiffness = np.array([2.0, 1.5 * softer])
    rest = np.array([0.4, -0.9])
    noise = np.random.default_rng(1)
    rows = []
    for force in np.linspace(0, 3, 25):
        q = rest.copy()
        for _ in range(60):
            directions = np.cumsum(q)
            jacobian = np.array([[-0.3 * np.sin(directions[0]) - 0.2 * np.sin(directions[1]), -0.2 * np.sin(directions[1])],
                                 [0.3 * np.cos(directions[0]) + 0.2 * np.cos(directions[1]), 0.2 * np.cos(directions[1])]])
            q = q + 0.5 * (rest + jacobian.T @ np.array([0, force]) / stiffness - q)
        directions = np.cumsum(q)
        rows.append([0.3 * np.cos(directions[0]) + 0.2 * np.cos(directions[1]) + 2e-4 * noise.normal(),
                     0.3 * np.sin(directions[0]) + 0.2 * np.sin(directions[1]) + 2e-4 * noise.normal(), 0, force])
    return pandas.DataFrame(rows, columns=["x", "y", "Fx", "Fy"])


def test_a_servo_arm_is_read_without_any_simulator(arm: pathlib.Path) -> None:
    chain = plumbline.read_chain(arm)
    assert chain.link_length.tolist() == [0.3, 0.2]
    assert chain.joint_stiffness.tolist() == [2, 1.5]
    assert chain.rest.tolist() == [0.4, -0.9]
    assert chain.joints == ["j1", "j2"]
    assert any("spring of 2 N m/rad about its command" in note for note in chain.notes)
    with pytest.raises(plumbline.Error, match="no joint j9"):
        plumbline.read_chain(arm, ["j9"])


def test_from_tables_to_the_corrected_servo(arm: pathlib.Path, tmp_path: pathlib.Path) -> None:
    readings = held(softer=0.7)
    found = plumbline.diagnose(arm, [{"id": "load", "control": "force", "samples": readings}], noise={"x": 2e-4, "y": 2e-4},
                               bench={"gravity_plane": "horizontal"}, progress=None)
    assert found.report["gap"]["present"]
    models = found.corrected_models("xml")
    softened = [one for one in models if 'name="m2"' in one.text and "joint_stiffness" in str(one.effects)]
    assert softened, [one.effects for one in models]
    text = softened[0].write(tmp_path / "corrected.xml").read_text()
    assert plumbline.read_chain(tmp_path / "corrected.xml").joint_stiffness[1] == pytest.approx(1.05, rel=0.05), text
    assert found.corrected_models()[0].text.count("[nominal]") == 1


def test_a_draft_says_what_it_guessed(arm: pathlib.Path, tmp_path: pathlib.Path) -> None:
    readings = held()
    table = pandas.DataFrame({"X [mm]": 1000 * readings.x, "Y [mm]": 1000 * readings.y, "Force y (N)": readings.Fy})
    draft = plumbline.draft(arm, {"load": table})
    assert any(guess.what.startswith("control") and guess.value == "force" for guess in draft.guesses), draft.guesses
    folder = draft.write(tmp_path / "lab")
    assert (folder / "load.csv").exists()
    assert not plumbline.diagnose_folder(folder, progress=None).report["gap"]["present"], draft.settings
    with pytest.raises(plumbline.Error, match="something there already"):
        draft.write(folder)


def test_panels_of_ones_own_and_a_title_that_says_the_cause(arm: pathlib.Path) -> None:
    import matplotlib.pyplot
    found = plumbline.diagnose(arm, [{"id": "load", "control": "force", "samples": held(0.7)}], noise={"x": 2e-4, "y": 2e-4},
                               bench={"gravity_plane": "horizontal"}, progress=None)
    figure = found.plot()
    assert figure._suptitle is not None and found.verdict in figure._suptitle.get_text()
    _, axes = matplotlib.pyplot.subplots(1, 1)
    assert found.plot(channel="x", axes=[axes]) is axes.get_figure()
    assert [line.get_label() for line in axes.lines][0] == "nominal model"
    with pytest.raises(plumbline.Error, match="expected one of load: x"):
        found.plot(channel="q7")


def test_verbs_of_the_program_as_tables() -> None:
    claims = plumbline.verify(section="2")
    assert set(claims.verdict) <= {"confirmed", "refuted", "imprecise", "convention", "unjudged"} and len(claims) > 5
    chains = pandas.DataFrame({"chain": ["mine"], "lengths": [[1, 1]], "stiffness": [[0, 1]]})
    values = pandas.DataFrame({"chain": ["mine"], "mode": [1], "force": [2.0]})
    assert json.dumps(plumbline.check(values, chains))
    with pytest.raises(plumbline.Error, match="no such folder"):
        plumbline.check_experiment("/nowhere")
