"""The verbs that the program answers say the same from Python."""
import pathlib

import plumbline
import pytest

CASES = pathlib.Path(__file__).parents[2] / "tests/cases"
EXAMPLES = pathlib.Path(__file__).parents[2] / "docs/examples"
NOMINAL = {"link_length": [0.3], "joint_stiffness": [2.0]}
NOISE = {"q": 0.002}
RUN = {"id": "load", "control": "force", "rest": [0.4]}
COLUMNS = {"q": ["q1"]}
BENCH = """
format = "chain-experiment/1"
name = "bench"
nominal = { link_length = [0.3], joint_stiffness = [2.0] }
bench = { gravity_plane = "horizontal" }
noise = { q = 0.002 }
columns = { q = ["q1"] }
run = [{ id = "load", control = "force", rest = [0.4] }]
"""


def test_a_bench_in_memory_is_planned_as_one_in_a_folder(tmp_path):
    (tmp_path / "experiment.toml").write_text(BENCH)
    shares = []
    plans = [plumbline.plan(NOMINAL, [RUN], noise=NOISE, columns=COLUMNS, bench={"gravity_plane": "horizontal"},
                            progress=shares.append),
             plumbline.plan_folder(tmp_path)]
    came_from = [plan.pop("provenance") for plan in plans]
    assert plans[0] == plans[1] and plans[0]["experiment"] == "bench"
    assert came_from[0]["command"] == "plumbline.plan(…)" and shares == sorted(shares)


def test_of_samples_a_plan_takes_the_commands():
    commands = {"t": [0.0, 1.0, 2.0], "Fx": [0.0, 0.0, 0.0], "Fy": [0.0, 1.0, 2.0]}
    plan = plumbline.plan(NOMINAL, [{**RUN, "samples": commands}], noise=NOISE, bench={"gravity_plane": "horizontal"},
                          progress=False)
    assert "load" in str(plan)
    with pytest.raises(plumbline.Error, match=r"run\[1\].samples.Fy: found 1 readings, expected 3 as in t"):
        plumbline.plan(NOMINAL, [{**RUN, "samples": {**commands, "Fy": [1.0]}}], noise=NOISE)


def test_many_experiments_are_compared(tmp_path):
    found = plumbline.diagnose_folders([CASES / "alternating", CASES / "zero-return"], reports=tmp_path / "reports")
    assert [one["name"] for one in found["experiments"]] == ["alternating", "zero-return"]
    assert found["same_cause"].startswith("it may be")  # two benches with a soft spring, of which a gain is an alias
    assert {file.name for file in (tmp_path / "reports").glob("*.json")} == {"alternating.json", "zero-return.json"}
    with pytest.raises(plumbline.Error, match="found 1 folders, expected two or more"):
        plumbline.diagnose_folders([CASES / "alternating"])


SERVO = """
format = "motion/1"
name = "a log"
logs = { files = ["chirp-08.csv"] }
servo = { gain = 8, duty_per_error = 0.16, supply = 12.0 }
load = { mass = 0.5, length = 0.12 }
drive = { stall_torque = 0.3, back_emf = 0.25, armature = 0.006, encoder_zero = 0.01, joint_friction = 0.06, viscous_friction = 0.03 }
noise = { position = 0.0006 }
model = { file = "servo.xml" }
"""


def test_logs_in_motion_are_diagnosed(tmp_path):
    for name in ("chirp-08.csv", "servo.xml"):
        (tmp_path / name).write_bytes((EXAMPLES / "servo-log" / name).read_bytes())
    (tmp_path / "experiment.toml").write_text(SERVO)
    found = plumbline.diagnose_logs(tmp_path, corrected=tmp_path / "corrected.xml")
    delay = found["causes"][0]["effects"][0]
    assert found["verdict"] == "identified" and delay["effect"] == "command_delay"
    # a command acts 30 ms late in make.py, whose steps of 5e-5 s are the finest delay that it knows
    assert delay["parameters"][0]["value"] == pytest.approx(0.030, abs=5e-5)
    assert "delay=" in (tmp_path / "corrected.xml").read_text()
    (tmp_path / "experiment.toml").write_text(SERVO.replace("chirp-08", "none"))
    with pytest.raises(plumbline.Error, match="none.csv"):
        plumbline.diagnose_logs(tmp_path)


def test_another_paper_is_judged():
    claims = plumbline.verify(pathlib.Path(__file__).parents[2] / "verify/papers/bar-chains")
    assert len(claims) and set(claims["verdict"]) <= {"confirmed", "refuted", "imprecise", "convention"}
