"""Serial arms in space out of simulators' models."""
from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np

from plumbline import _engine
from plumbline._engine import Error
from plumbline.models import Model, ModelFile, written_out
from plumbline.numbers import Floats


@dataclass(frozen=True, repr=False, eq=False)
class Arm:
    """The serial arm in space of a model, in SI and radians: what `diagnose_arm` takes as `arm`. Lists and rows are by
    link, from the base on; link i is moved by joint i."""

    base: str  #: names of the bodies or frames at its ends
    tip: str
    joints: list[str]  #: their names in the model
    links: list[str]
    kinds: list[str]  #: "revolute" or "prismatic"
    frames: Floats  #: n x 4 x 4: of the link at joint coordinate zero, in the frame of the link before, or of the base
    axes: Floats  #: n x 3: unit vectors through the origin of the link's frame, in it
    stiffness: Floats  #: N m/rad or N/m; 0 is rigid
    masses: Floats  #: kg, with what hangs on the link beside the way from base to tip
    centres: Floats  #: n x 3: of mass, in the frame of the link
    limits: Floats  #: n x 2; infinite without
    friction: Floats  #: N m or N: the dry friction of the model, which no key of [arm] has
    gravity: Floats  #: acceleration, in the world
    base_frame: Floats  #: 4 x 4: in the world
    tip_frame: Floats  #: 4 x 4: in the frame of the last link
    notes: list[str]  #: what was assumed and what was left out

    def __repr__(self) -> str:
        kinds = "".join(kind[0].upper() for kind in self.kinds)
        return (f"<plumbline.Arm {kinds}, {self.base!r} to {self.tip!r}: {self.masses.sum():.3g} kg, "
                f"{np.count_nonzero(self.stiffness)} of {len(kinds)} joints yield>")

    def settings(self) -> dict[str, Any]:
        """As the table [arm] of an experiment has it, joint by joint, where every number can be changed. The ends have no
        names there: points and loads at `tip` need no `body`."""
        return {"gravity": self.gravity.tolist(), **_pose(self.base_frame, "base_"), **_pose(self.tip_frame, "tip_"),
                "joint": [self._joint(i) for i in range(len(self.joints))]}

    def _joint(self, i: int) -> dict[str, Any]:
        joint = {"name": self.joints[i], "kind": self.kinds[i], **_pose(self.frames[i]), "axis": self.axes[i].tolist(),
                 "mass": float(self.masses[i]), "centre": self.centres[i].tolist()}
        if self.links[i] not in self.joints:  # a name stands once in a table
            joint["link"] = self.links[i]
        if self.stiffness[i] != 0:
            joint["stiffness"] = float(self.stiffness[i])
        if np.isfinite(self.limits[i]).all():
            joint["limits"] = self.limits[i].tolist()
        return joint


def _pose(frame: Floats, prefix: str = "") -> dict[str, list[float]]:
    """Place, and angles about the fixed axes x, y and z: right for every rotation, where the pitch is a quarter turn too."""
    turn = frame[:3, :3]
    yaw = math.atan2(turn[1, 0], turn[0, 0])
    c, s = math.cos(yaw), math.sin(yaw)
    rest = np.array([[c, s, 0], [-s, c, 0], [0, 0, 1]]) @ turn
    angles = np.array([math.atan2(-rest[1, 2], rest[1, 1]), math.atan2(-rest[2, 0], rest[0, 0]), yaw])
    return {f"{prefix}xyz": frame[:3, 3].tolist(), f"{prefix}rpy": (angles + 0.0).tolist()}  # no negative zero


def read_arm(model: Model, *, base: str = "", tip: str = "") -> Arm:
    """The serial arm in space of a simulator's model, as `plumbline arm` reads it (docs/models.md). No simulator is
    needed; an MJCF whose elements stand for several bodies is written out by the package `mujoco` first, where that is
    installed.

    :param model: a file (URDF, MJCF, SDF), or a `mujoco.MjSpec`
    :param base: the body at the base; without it the root of the tip
    :param tip: the body or frame at the tip; without it what is named as a tip, or the last body
    :raises Error: where no serial arm of hinges and slides leads from base to tip, with the joint or body
    """
    file = ModelFile(model)
    try:
        found = _engine.arm(file.path, base, tip)
    except Error as error:
        file = written_out(model, error)
        found = _engine.arm(file.path, base, tip)
    return Arm(**found)
