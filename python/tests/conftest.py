"""What several tests need."""
import pathlib

import pytest

ARM = """<mujoco><compiler angle="radian"/><option gravity="0 0 0"/>
<worldbody><body name="a"><joint name="shoulder" axis="0 0 1"/><geom type="capsule" size="0.01" fromto="0 0 0 0.3 0 0" mass="0.05"/>
<body name="b" pos="0.3 0 0"><joint name="elbow" axis="0 0 1"/><geom type="capsule" size="0.01" fromto="0 0 0 0.2 0 0" mass="0.05"/>
<site name="tip" pos="0.2 0 0"/></body></body></worldbody>
<actuator><position name="m1" joint="shoulder" kp="20"/><position name="m2" joint="elbow" kp="15"/></actuator></mujoco>
"""


@pytest.fixture
def arm(tmp_path: pathlib.Path) -> pathlib.Path:
    file = tmp_path / "arm.xml"
    file.write_text(ARM)
    return file
