"""Workbooks, MCAP recordings and LeRobot datasets, written with the libraries that read them."""
import datetime
import json
import pathlib
from typing import Any

import numpy as np
import pytest

import plumbline
from plumbline.converted_tables import is_converted, new
from plumbline.spreadsheets import sheet_as_csv, sheet_names

openpyxl = pytest.importorskip("openpyxl")

ARM = """<mujoco><compiler angle="radian"/><option gravity="0 0 0"/>
<worldbody><body name="a"><joint name="shoulder" axis="0 0 1"/><geom type="capsule" size="0.01" fromto="0 0 0 0.3 0 0" mass="0.05"/>
<body name="b" pos="0.3 0 0"><joint name="elbow" axis="0 0 1"/><geom type="capsule" size="0.01" fromto="0 0 0 0.2 0 0" mass="0.05"/>
<site name="tip" pos="0.2 0 0"/></body></body></worldbody>
<actuator><position name="m1" joint="shoulder" kp="20"/><position name="m2" joint="elbow" kp="15"/></actuator></mujoco>
"""
ROWS = [["t", "x [mm]", "y [mm]", "Fx", "Fy"], [0, 451.8, 20.9, 0, 0], [1, 445.8, 20.9, -1.69, 0.16], [2, 439.8, 20.9, -2.4, 0.22],
        [3, 433.8, 20.9, -3.04, 0.26]]


@pytest.fixture
def arm(tmp_path: pathlib.Path) -> pathlib.Path:
    file = tmp_path / "arm.xml"
    file.write_text(ARM)
    return file


def workbook(file: pathlib.Path, **sheets: list[list[Any]]) -> pathlib.Path:
    book = openpyxl.Workbook()
    book.remove(book.active)
    for name, rows in sheets.items():
        sheet = book.create_sheet(name)
        for row in rows:
            sheet.append(row)
    book.save(file)
    return file


def test_a_sheet_is_the_table_that_stands_in_it(tmp_path: pathlib.Path) -> None:
    file = workbook(tmp_path / "press.xlsx", Notes=[], Monday=[[], *ROWS, []])
    assert sheet_names(file) == ["Monday"]
    assert sheet_as_csv(file).splitlines() == [",".join(map(str, row)) for row in ROWS]


def test_numbers_keep_their_digits_and_times_become_seconds(tmp_path: pathlib.Path) -> None:
    at = datetime.datetime(2026, 3, 1, 12, 0, 0, 500000)
    file = workbook(tmp_path / "a.xlsx", A=[["t", "x"], [at, 451.83125], [datetime.time(0, 1, 2), None]])
    rows = [row.split(",") for row in sheet_as_csv(file).splitlines()]
    assert float(rows[1][0]) == pytest.approx(at.replace(tzinfo=datetime.timezone.utc).timestamp(), abs=1e-6)
    assert float(rows[1][1]) == 451.83125
    assert rows[2] == ["62.0", ""]


def test_a_sheet_among_several_is_to_be_named(tmp_path: pathlib.Path) -> None:
    file = workbook(tmp_path / "press.xlsx", Monday=ROWS, Tuesday=ROWS[:3])
    with pytest.raises(plumbline.Error, match="found the sheets Monday, Tuesday, expected the name of one"):
        sheet_as_csv(file)
    assert len(sheet_as_csv(file, "Tuesday").splitlines()) == 3
    with pytest.raises(plumbline.Error, match="found no sheet Friday with values, expected one of Monday, Tuesday"):
        sheet_as_csv(file, "Friday")


def test_what_is_no_table_is_refused_in_one_line(tmp_path: pathlib.Path) -> None:
    with pytest.raises(plumbline.Error, match="found empty sheets alone"):
        sheet_as_csv(workbook(tmp_path / "empty.xlsx", A=[]))
    with pytest.raises(plumbline.Error, match="A!B2: found a formula without its value"):
        sheet_as_csv(workbook(tmp_path / "formula.xlsx", A=[["t", "x"], [0, "=1+1"]]))
    (tmp_path / "text.xlsx").write_text("t,x\n")
    with pytest.raises(plumbline.Error, match="expected a workbook") as refused:
        sheet_as_csv(tmp_path / "text.xlsx")
    assert "\n" not in str(refused.value)
    with pytest.raises(plumbline.Error, match="no such file"):
        sheet_as_csv(tmp_path / "nowhere.xlsx")


def test_a_workbook_is_drafted_as_its_sheet_is(arm: pathlib.Path, tmp_path: pathlib.Path) -> None:
    file = workbook(tmp_path / "press.xlsx", Monday=ROWS, Tuesday=ROWS)
    (tmp_path / "press.csv").write_text(sheet_as_csv(file, "Monday"))
    of_text, of_book = plumbline.draft(arm, [tmp_path / "press.csv"]), plumbline.draft(arm, [file], sheet="Monday")
    assert of_book.settings == of_text.settings and of_book.tables == of_text.tables


def test_the_command_takes_a_workbook(arm: pathlib.Path, tmp_path: pathlib.Path, capfd: pytest.CaptureFixture[str]) -> None:
    file = workbook(tmp_path / "press.xlsx", Monday=ROWS, Tuesday=ROWS)
    words = [str(tmp_path / "lab"), str(file), "--model", str(arm)]
    assert is_converted(str(file)) and not is_converted(str(arm))
    assert new(words) == 2
    assert "found the sheets Monday, Tuesday" in capfd.readouterr().err
    assert new([*words, "--sheet", "Monday"]) in (0, 1)
    assert (tmp_path / "lab" / "press.csv").is_file()


JOINT_STATE = """std_msgs/Header header
string[] name
float64[] position
float64[] velocity
float64[] effort
================================================================================
MSG: std_msgs/Header
builtin_interfaces/Time stamp
string frame_id
================================================================================
MSG: builtin_interfaces/Time
int32 sec
uint32 nanosec
"""


def swept() -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Times, commands and what was reached: a sweep there and back with a lag that a spring would have."""
    t = np.arange(40) * 0.5
    sent = np.stack([0.02 * np.minimum(np.arange(40), 39 - np.arange(40)), -0.03 * np.minimum(np.arange(40), 39 - np.arange(40))], axis=1)
    return t, sent, sent + 0.001 * np.sin(7 * np.arange(80)).reshape(40, 2)


def recorded(file: pathlib.Path) -> pathlib.Path:
    writer_of = pytest.importorskip("mcap_ros2.writer")
    t, sent, reached = swept()
    with open(file, "wb") as out:
        writer = writer_of.Writer(out)
        schema = writer.register_msgdef("sensor_msgs/msg/JointState", JOINT_STATE)
        for i, time in enumerate(t):
            for topic, angles, late in (("/joint_commands", sent[i], 0), ("/joint_states", reached[i], 1000)):
                stamp = {"sec": 1000 + int(time), "nanosec": int(1e9 * (time % 1)) + late}
                message = {"header": {"stamp": stamp, "frame_id": ""}, "name": ["shoulder", "elbow"],
                           "position": list(angles), "velocity": [], "effort": []}
                writer.write_message(topic, schema, message, log_time=int(1e9 * (1000 + time)) + late)
        writer.finish()
    return file


def test_joint_states_of_a_recording_with_their_commands(tmp_path: pathlib.Path) -> None:
    file = recorded(tmp_path / "sweep.mcap")
    t, sent, reached = swept()
    table = plumbline.read_recording(file, commands="/joint_commands")["sweep"]
    assert list(table.columns) == ["t", "q shoulder", "q elbow", "q shoulder cmd", "q elbow cmd"]
    assert np.allclose(table.t, t, rtol=0, atol=1e-6)  # stamps of 1e3 s are doubles to 1e-13 s; the first is late by 1 us
    assert (table[["q shoulder", "q elbow"]].to_numpy() == reached).all()
    assert (table[["q shoulder cmd", "q elbow cmd"]].to_numpy() == sent).all()
    assert list(plumbline.read_recording(file)["sweep"].columns) == ["t", "q shoulder", "q elbow"]


def test_a_recording_without_what_is_asked_for_is_refused_in_one_line(tmp_path: pathlib.Path) -> None:
    file = recorded(tmp_path / "sweep.mcap")
    with pytest.raises(plumbline.Error, match="no message on /arm, expected one of /joint_commands, /joint_states"):
        plumbline.read_recording(file, topic="/arm")
    (tmp_path / "bad.mcap").write_bytes(b"no recording")
    with pytest.raises(plumbline.Error, match="expected an MCAP file of ROS 2") as refused:
        plumbline.read_recording(tmp_path / "bad.mcap")
    assert "\n" not in str(refused.value)
    with pytest.raises(plumbline.Error, match="no such file"):
        plumbline.read_recording(tmp_path / "nowhere.mcap")


def dataset(folder: pathlib.Path, names: Any) -> pathlib.Path:
    """Two episodes of a sweep, a file each, as the second version of the format has them; the third has both in one file."""
    pytest.importorskip("pyarrow")
    import pyarrow.parquet
    t, sent, reached = swept()
    (folder / "meta").mkdir(parents=True)
    (folder / "data" / "chunk-000").mkdir(parents=True)
    feature = {"dtype": "float64", "shape": [2], "names": names}
    features = {"observation.state": feature, "action": feature, "timestamp": {}, "episode_index": {}}
    (folder / "meta" / "info.json").write_text(json.dumps({"codebase_version": "v2.1", "fps": 2, "features": features}))
    for episode in range(2):
        table = pyarrow.table({"timestamp": t, "episode_index": np.full(len(t), episode),
                               "observation.state": list(reached + episode), "action": list(sent + episode)})
        pyarrow.parquet.write_table(table, folder / "data" / "chunk-000" / f"episode_{episode:06d}.parquet")
    return folder


@pytest.mark.parametrize("names", [["shoulder.pos", "elbow.pos"], {"motors": ["shoulder", "elbow"]}])
def test_episodes_of_a_dataset_are_runs(tmp_path: pathlib.Path, names: Any) -> None:
    t, sent, reached = swept()
    tables = plumbline.read_recording(dataset(tmp_path / "set", names))
    assert list(tables) == ["episode-0", "episode-1"]
    assert list(tables["episode-1"].columns) == ["t", "q shoulder", "q elbow", "q shoulder cmd", "q elbow cmd"]
    assert (tables["episode-1"]["q elbow"] == reached[:, 1] + 1).all()
    assert (tables["episode-0"]["q shoulder cmd"] == sent[:, 0]).all()


def test_a_folder_that_is_no_dataset_is_refused_in_one_line(tmp_path: pathlib.Path) -> None:
    pytest.importorskip("pyarrow")
    with pytest.raises(plumbline.Error, match="no meta/info.json"):
        plumbline.read_recording(tmp_path)
    (tmp_path / "meta").mkdir()
    (tmp_path / "meta" / "info.json").write_text("{}")
    with pytest.raises(plumbline.Error, match="no feature observation.state"):
        plumbline.read_recording(tmp_path)


def test_a_dataset_becomes_an_experiment_of_commanded_joints(arm: pathlib.Path, tmp_path: pathlib.Path) -> None:
    tables = plumbline.read_recording(dataset(tmp_path / "set", ["shoulder", "elbow"]))
    draft = plumbline.draft(arm, {"episode-0": tables["episode-0"]})
    assert 'control = "command"' in draft.settings and "q_command" in draft.settings, draft.settings
    folder = draft.write(tmp_path / "lab")
    assert "the joints' commands are imposed, 40 readings" in plumbline.check_experiment(folder)
