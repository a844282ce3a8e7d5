"""Bags of ROS 2 and LeRobot datasets, written with the libraries that read them or by their definition."""
import json
import pathlib
import sqlite3
import struct
from typing import Any

import numpy as np
import pytest

import plumbline
from plumbline.converted_tables import is_converted, new

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


def stamp_of(time: float) -> dict[str, int]:
    return {"sec": int(time), "nanosec": round(1e9 * (time % 1))}


def written(file: pathlib.Path, messages: list[tuple[str, float, dict[str, Any]]], first_stamp: float = 1000) -> pathlib.Path:
    """Joint states by topic and time of recording, s; their stamps count from `first_stamp`, and None are zero."""
    writer_of = pytest.importorskip("mcap_ros2.writer")
    with open(file, "wb") as out:
        writer = writer_of.Writer(out)
        schema = writer.register_msgdef("sensor_msgs/msg/JointState", JOINT_STATE)
        for topic, time, fields in messages:
            stamped = fields.get("stamped", time)
            message = {"header": {"stamp": stamp_of(0 if stamped is None else first_stamp + stamped), "frame_id": ""},
                       "name": ["shoulder", "elbow"], "velocity": [], "effort": [],
                       **{key: value for key, value in fields.items() if key != "stamped"}}
            writer.write_message(topic, schema, message, log_time=round(1e9 * (first_stamp + time)))
        writer.finish()
    return file


def recorded(file: pathlib.Path) -> pathlib.Path:
    """The sweep, each state 1 us after its command."""
    return written(file, [message for time, sent, reached in zip(*swept())
                          for message in (("/joint_commands", time, {"position": list(sent)}),
                                          ("/joint_states", time + 1e-6, {"position": list(reached)}))])


def test_joint_states_of_a_recording_with_their_commands(tmp_path: pathlib.Path) -> None:
    file = recorded(tmp_path / "sweep.mcap")
    t, sent, reached = swept()
    table = plumbline.read_recording(file, commands="/joint_commands")["sweep"]
    assert list(table.columns) == ["t", "q shoulder", "q elbow", "q shoulder cmd", "q elbow cmd"]
    assert np.allclose(table.t, t, rtol=0, atol=1e-9)  # stamps are whole nanoseconds
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


def test_a_dataset_of_one_joint_holds_numbers_in_place_of_lists(tmp_path: pathlib.Path) -> None:
    pytest.importorskip("pyarrow")
    import pyarrow.parquet
    t, sent, reached = swept()
    folder = dataset(tmp_path / "set", ["shoulder", "elbow"])
    feature = {"dtype": "float64", "shape": [1], "names": ["shoulder"]}
    features = {"observation.state": feature, "action": feature, "timestamp": {}, "episode_index": {}}
    (folder / "meta" / "info.json").write_text(json.dumps({"features": features}))
    for episode, file in enumerate(sorted((folder / "data").rglob("*.parquet"))):
        pyarrow.parquet.write_table(pyarrow.table({"timestamp": t, "episode_index": np.full(len(t), episode),
                                                   "observation.state": reached[:, 0], "action": sent[:, 0]}), file)
    log = plumbline.read_logs(folder)["episode-0"]
    assert (log["position shoulder"] == reached[:, 0]).all()
    assert (log["command shoulder"] == sent[:, 0]).all()


def test_a_folder_that_is_no_dataset_is_refused_in_one_line(tmp_path: pathlib.Path) -> None:
    pytest.importorskip("pyarrow")
    with pytest.raises(plumbline.Error, match="no metadata.yaml and no meta/info.json"):
        plumbline.read_recording(tmp_path)
    (tmp_path / "meta").mkdir()
    (tmp_path / "meta" / "info.json").write_text("{}")
    with pytest.raises(plumbline.Error, match="no feature observation.state"):
        plumbline.read_recording(tmp_path)


def test_a_dataset_becomes_an_experiment_of_commanded_joints(arm: pathlib.Path, tmp_path: pathlib.Path) -> None:
    tables = plumbline.read_recording(dataset(tmp_path / "set", ["shoulder", "elbow"]))
    folder = plumbline.draft(arm, {"episode-0": tables["episode-0"]}).write(tmp_path / "lab")
    assert "the joints' commands are imposed, 40 readings" in plumbline.check_experiment(folder)


def test_a_bag_of_several_files_is_one_run(tmp_path: pathlib.Path) -> None:
    (tmp_path / "bag").mkdir()
    (tmp_path / "bag" / "metadata.yaml").touch()
    for part in range(3):
        written(tmp_path / "bag" / f"bag_{part}.mcap", [("/joint_states", 4 * part + i, {"position": [part, i]}) for i in range(4)])
    table = plumbline.read_recording(tmp_path / "bag")["bag"]
    assert list(table.t) == list(range(12))
    assert list(table["q shoulder"]) == [0] * 4 + [1] * 4 + [2] * 4
    assert is_converted(str(tmp_path / "bag")) and not is_converted(str(tmp_path))


def in_sqlite(file: pathlib.Path, messages: list[tuple[str, int, bytes]], kind: str = "sensor_msgs/msg/JointState") -> pathlib.Path:
    """A bag with what ROS 2 writes of messages: topic, nanoseconds, CDR."""
    bag = sqlite3.connect(file)
    bag.execute("CREATE TABLE topics(id INTEGER PRIMARY KEY, name TEXT, type TEXT, serialization_format TEXT)")
    bag.execute("CREATE TABLE messages(id INTEGER PRIMARY KEY, topic_id INTEGER, timestamp INTEGER, data BLOB)")
    names = sorted({topic for topic, _, _ in messages})
    bag.executemany("INSERT INTO topics VALUES (?, ?, ?, 'cdr')", [(at, name, kind) for at, name in enumerate(names, 1)])
    bag.executemany("INSERT INTO messages(topic_id, timestamp, data) VALUES (?, ?, ?)",
                    [(1 + names.index(topic), time, data) for topic, time, data in messages])
    bag.commit()
    bag.close()
    return file


@pytest.mark.parametrize("order", "<>")
def test_a_message_in_sqlite_is_read_by_the_rules_of_cdr(tmp_path: pathlib.Path, order: str) -> None:
    """Numbers are aligned to their size behind a head of four bytes that tells their order; texts end with a zero."""
    message = bytes([0, order == "<", 0, 0]) + struct.pack(f"{order}iI I1sxxx I I2sxx I6sxx I4x2d I Id", 1000, 500_000_000, 1, b"", 2,
                                                           2, b"a", 6, b"elbow", 2, 0.5, -1.0, 0, 1, 7.0)
    (folder := tmp_path / "bag").mkdir()
    (folder / "metadata.yaml").touch()
    with pytest.raises(plumbline.Error, match="found metadata.yaml alone, expected .mcap or .db3"):
        plumbline.read_logs(folder)
    in_sqlite(folder / "bag_0.db3", [("/joint_states", 5, message)] * 2)
    log = plumbline.read_logs(folder)["bag"]
    assert {name: list(log[name]) for name in log} == {"t": [0], "position a": [0.5], "torque a": [7], "position elbow": [-1]}
    assert is_converted(str(folder))


def test_the_command_takes_a_bag_and_the_topic_of_its_commands(arm: pathlib.Path, tmp_path: pathlib.Path,
                                                                capfd: pytest.CaptureFixture[str]) -> None:
    def state(time: float, angles: np.ndarray) -> bytes:
        return bytes([0, 1, 0, 0]) + struct.pack("<iI I1sxxx I I9sxxx I6sxx I4x2d I I", int(time), round(1e9 * (time % 1)), 1, b"", 2, 9, b"shoulder",
                                                 6, b"elbow", 2, *angles, 0, 0)

    bag = in_sqlite(tmp_path / "sweep.db3", [message for time, sent, reached in zip(*swept())
                                             for message in (("/cmd", round(1e9 * time), state(1 + time, sent)),
                                                             ("/joint_states", round(1e9 * time), state(1 + time, reached)))])
    assert new([str(tmp_path / "lab"), str(bag), "--commands", "/cmd", "--model", str(arm)]) in (0, 1)
    assert "the joints' commands are imposed, 40 readings" in plumbline.check_experiment(tmp_path / "lab")
    assert new([str(tmp_path / "lab"), str(bag), "--commands"]) == 2
    assert "--commands: found no name, expected one" in capfd.readouterr().err


def test_bags_in_sqlite_and_in_mcap_hold_the_same(tmp_path: pathlib.Path) -> None:
    file = recorded(tmp_path / "sweep.mcap")
    from mcap.reader import make_reader
    with open(file, "rb") as recording:
        messages = [(channel.topic, message.log_time, message.data) for _, channel, message in make_reader(recording).iter_messages()]
    (folder := tmp_path / "sqlite").mkdir()
    bag = in_sqlite(folder / "sweep.db3", messages)
    tables = [plumbline.read_recording(one, commands="/joint_commands")["sweep"] for one in (file, bag)]
    assert tables[0].equals(tables[1])


def test_what_is_no_bag_in_sqlite_is_refused_in_one_line(tmp_path: pathlib.Path) -> None:
    other = in_sqlite(tmp_path / "other.db3", [("/tf", 1, b"")], "tf2_msgs/msg/TFMessage")
    with pytest.raises(plumbline.Error, match="found tf2_msgs/msg/TFMessage on /tf, expected sensor_msgs/msg/JointState"):
        plumbline.read_recording(other, topic="/tf")
    with pytest.raises(plumbline.Error, match="no message on /joint_states, expected one of /tf"):
        plumbline.read_recording(other)
    (tmp_path / "text.db3").write_text("none")
    for bad in (in_sqlite(tmp_path / "short.db3", [("/joint_states", 1, bytes(9))]), tmp_path / "text.db3"):
        with pytest.raises(plumbline.Error, match="where it is read, expected a bag of ROS 2 in SQLite") as refused:
            plumbline.read_recording(bad)
        assert "\n" not in str(refused.value)


def test_without_stamps_the_times_of_recording_order_states_and_commands(tmp_path: pathlib.Path) -> None:
    states = [("/joint_states", i, {"position": [i, 0]}) for i in range(4)]
    sent = [("/cmd", i - 0.25, {"position": [10 + i, 0], "stamped": None}) for i in range(1, 4)]
    file = written(tmp_path / "a.mcap", sorted(states + sent, key=lambda message: message[1]))
    table = plumbline.read_recording(file, commands="/cmd")["a"]
    assert list(table.t) == [0, 1, 2, 3]
    assert np.isnan(table["q shoulder cmd"][0]) and list(table["q shoulder cmd"][1:]) == [11, 12, 13]


def test_a_log_holds_all_that_was_recorded_of_a_joint_in_whole_readings(tmp_path: pathlib.Path) -> None:
    def state(i: int) -> dict[str, Any]:
        return {"position": [0.1 * i, 5], "velocity": [i, 0], "effort": [2.0 * i, np.nan]}

    moving = [("/joint_states", i, state(i)) for i in (0, 1, 2, 2, 3)]  # the third is recorded twice
    gripper = [("/joint_states", 1.5, {"name": ["gripper"], "position": [7]})]
    sent = [("/cmd", 0.5, {"name": ["shoulder"], "position": [9]})]
    file = written(tmp_path / "a.mcap", sorted(moving + gripper + sent, key=lambda message: message[1]))
    log = plumbline.read_logs(file, "shoulder", commands="/cmd")["a"]
    assert {name: list(log[name]) for name in log} == {
        "t": [0, 1, 2], "position shoulder": [0.1, 0.2, 0.1 * 3], "velocity shoulder": [1, 2, 3],
        "torque shoulder": [2, 4, 6], "command shoulder": [9, 9, 9]}
    assert list(plumbline.read_logs(file, ["elbow"])["a"]) == ["t", "position elbow", "velocity elbow"]
    assert plumbline.read_logs(file, "shoulder", unit="deg")["a"]["velocity shoulder"][1] == pytest.approx(np.pi / 180, rel=1e-15)
    with pytest.raises(plumbline.Error, match="a.mcap, a: found no joint 'wrist', expected one of shoulder, elbow, gripper"):
        plumbline.read_logs(file, ["wrist"])
    with pytest.raises(plumbline.Error, match="found no reading of all of .*, expected some; name fewer joints"):
        plumbline.read_logs(file)
    with pytest.raises(plumbline.Error, match='unit: found \'turns\', expected "rad" or "deg"'):
        plumbline.read_logs(file, unit="turns")


EXAMPLE = pathlib.Path(__file__).parents[2] / "docs" / "examples" / "servo-log"


def test_logs_that_were_recorded_are_diagnosed(tmp_path: pathlib.Path) -> None:
    """The example of logs in motion as a dataset in degrees gives the tables again, and the program takes them."""
    pytest.importorskip("pyarrow")
    import pyarrow.parquet
    kept = [np.loadtxt(EXAMPLE / f"{name}.csv", delimiter=",", skiprows=1) for name in ("slow-08", "chirp-08")]
    (tmp_path / "meta").mkdir()
    (tmp_path / "data").mkdir()
    features = {"observation.state": {"names": ["hinge.pos", "hinge.vel"]}, "action": {"names": ["hinge.pos"]}, "timestamp": {},
                "episode_index": {}}
    (tmp_path / "meta" / "info.json").write_text(json.dumps({"features": features}))
    rows = [(time, episode, [np.degrees(position), 0.0], [np.degrees(command)])
            for episode, log in enumerate(kept) for time, command, position in log]
    pyarrow.parquet.write_table(pyarrow.table(dict(zip(("timestamp", "episode_index", "observation.state", "action"),
                                                       map(list, zip(*rows))))), tmp_path / "data" / "file-000.parquet")
    logs = plumbline.read_logs(tmp_path, unit="deg")
    assert list(logs) == ["episode-0", "episode-1"]
    for name, log in zip(logs, kept):
        # degrees and back: two products, half a unit in the last place each
        assert np.allclose(logs[name][["t", "command hinge", "position hinge"]].to_numpy(), log, rtol=1e-15, atol=0)
        logs[name].to_csv(tmp_path / f"{name}.csv", index=False)
    (tmp_path / "experiment.toml").write_text("""
format = "motion/1"
name = "recorded"
logs = { files = ["episode-0.csv", "episode-1.csv"] }
columns = { command = "command hinge", position = "position hinge" }
servo = { gain = 8, duty_per_error = 0.16, supply = 12.0 }
load = { mass = 0.5, length = 0.12 }
drive = { stall_torque = 0.3, back_emf = 0.25, armature = 0.006, encoder_zero = 0.01, joint_friction = 0.06, viscous_friction = 0.03 }
noise = { position = 0.0006 }
""")
    found = plumbline.diagnose_logs(tmp_path)
    assert [one["effect"] for one in found["causes"][0]["effects"]] == ["command_delay"]


def test_what_is_no_dataset_is_refused_in_one_line(tmp_path: pathlib.Path) -> None:
    pytest.importorskip("pyarrow")
    folder = dataset(tmp_path / "set", ["shoulder", "elbow"])
    (folder / "data" / "chunk-000" / "episode_000001.parquet").write_text("none")
    with pytest.raises(plumbline.Error, match="episode_000001.parquet: found ArrowInvalid where it is read") as refused:
        plumbline.read_recording(folder)
    assert "\n" not in str(refused.value)
    (folder / "meta" / "info.json").write_text("{")
    with pytest.raises(plumbline.Error, match="info.json: found no object of JSON"):
        plumbline.read_recording(folder)
