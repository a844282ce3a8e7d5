"""Statics of a plain serial arm at many poses at once, with the numbers of a MuJoCo model: springs at its joints and nothing else."""
from dataclasses import dataclass

import numpy as np

from model_files import rotation

GRAVITY = np.array([0.0, 0.0, -9.81])


@dataclass
class PlainArm:
    """Lists are by link."""
    slides: list
    place: np.ndarray
    turn: np.ndarray  # matrices
    axis: np.ndarray
    mass: np.ndarray
    centre: np.ndarray
    stiffness: np.ndarray
    tip: np.ndarray

    @classmethod
    def of_shape(cls, shape):
        links = shape.links
        return cls([link.kind == "slide" for link in links], *(np.array([getattr(link, name) for link in links], float) for name in ("place",)),
                   np.array([rotation(link.turn) for link in links]),
                   *(np.array([getattr(link, name) for link in links], float) for name in ("axis", "mass", "centre", "stiffness")),
                   np.array(shape.tip))

    def with_numbers_of(self, model):
        """Masses, centres and gains of a compiled MuJoCo model of the same arm."""
        body = [model.body(f"link_{i + 1}").id for i in range(len(self.mass))]
        return PlainArm(self.slides, self.place, self.turn, self.axis, model.body_mass[body].copy(), model.body_ipos[body].copy(),
                        model.actuator_gainprm[:, 0].copy(), self.tip)

    def posture(self, q):
        """By link: axes and origins of the joints, centres of mass; then place and axes of the tip. Leading index: the pose."""
        p, r = np.zeros((len(q), 3)), np.tile(np.eye(3), (len(q), 1, 1))
        axes, origins, centres = [], [], []
        for i, slides in enumerate(self.slides):
            p = p + r @ self.place[i]
            r = r @ self.turn[i]
            axes.append(r @ self.axis[i])
            origins.append(p)
            if slides:
                p = p + q[:, i, None] * axes[-1]
            else:
                r = r @ rotations(skew(self.axis[i]), q[:, i])
            centres.append(p + r @ self.centre[i])
        return axes, origins, centres, p + r @ self.tip, r

    def load(self, q, force):
        """Torques, or forces, of weights and of a force at the tip on the joints."""
        axes, origins, centres, tip, _ = self.posture(q)
        pull, moment = force.copy(), cross(tip, force)
        found = np.zeros_like(q)
        for i in reversed(range(len(axes))):
            weight = self.mass[i] * GRAVITY
            pull = pull + weight
            moment = moment + cross(centres[i], weight)
            on_joint = pull if self.slides[i] else moment - cross(origins[i], pull)
            found[:, i] = np.sum(axes[i] * on_joint, 1)
        return found

    def rest(self, turned, force):
        """Joint coordinates at rest: the springs are so stiff that three repetitions leave less than any tracker sees."""
        q = turned
        for _ in range(3):
            q = turned + self.load(q, force) / self.stiffness
        return q


def skew(v):
    return np.array([[0, -v[2], v[1]], [v[2], 0, -v[0]], [-v[1], v[0], 0]])


def rotations(axis, angles):
    """Matrices about one axis, which is given as its cross product's matrix (Rodrigues)."""
    return np.eye(3) + np.sin(angles)[:, None, None] * axis + (1 - np.cos(angles))[:, None, None] * (axis @ axis)


AHEAD, BEHIND = np.array([1, 2, 0]), np.array([2, 0, 1])


def cross(a, b):
    """By row; NumPy's own costs ten times as much for so few."""
    return a[..., AHEAD] * b[..., BEHIND] - a[..., BEHIND] * b[..., AHEAD]
