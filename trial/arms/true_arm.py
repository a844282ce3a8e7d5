"""Equilibria of the true arm, by MuJoCo's forces or, with memory, by its dynamics."""
import mujoco
import numpy as np

from model_files import quaternion, rotation_about
from true_model import STEP, document
from truth import Truth

MOVE, HOLD = 2.0, 1.0  # s: of a motion between two poses, of the rest after it
BEAT = 10  # steps between two commands of the servos
UNEVEN = 3  # times a turn: a spring that is stiffer at some angles
AT_REST = 1e-9  # rad or m: a smaller step is none

mujoco.set_mju_user_warning(lambda text: None)  # of steps of Newton's method that went too far; what fails is told by its residual


class TrueArm:
    """MuJoCo's model of a shape with a truth."""

    def __init__(self, shape, truth):
        self.shape, self.truth = shape, truth
        self.model = mujoco.MjModel.from_xml_string(document(shape, truth))
        self.data = mujoco.MjData(self.model)
        joint = [self.model.joint(link.joint) for link in shape.links]
        self.dof = np.array([j.dofadr[0] for j in joint])
        self.tip = self.model.site("tip").id
        self.flange = self.model.joint("flange").dofadr[0] if truth.loose_flange > 0 else None
        self.places = self.model.body_pos.copy()
        self.springs = self.stiffnesses()
        self.plain = TrueArm(shape, Truth(shape.size)) if truth.compensated else None

    def stiffnesses(self):
        """By degree of freedom, of springs and servos."""
        stiffness = self.model.jnt_stiffness[self.model.dof_jntid].copy()
        stiffness[self.dof] = self.model.actuator_gainprm[:, 0]
        stiffness[stiffness == 0] = 1.0
        return stiffness

    def set_reading(self, share):
        """What has changed by this share of the readings."""
        truth, model = self.truth, self.model
        model.body_pos[:] = self.places * (1 + truth.growth * share)
        if truth.sinking.any():
            turn = rotation_about(np.array([*truth.sinking, 0.0]) * share) @ rotation_about(truth.base_tilt)
            model.body("base").quat[:] = quaternion(turn)

    def apply(self, turned, force):
        """Servos, loads, and the laws that MuJoCo lacks, at the present joint coordinates."""
        model, data, truth = self.model, self.data, self.truth
        data.ctrl[:] = turned
        mujoco.mj_kinematics(model, data)
        mujoco.mj_comPos(model, data)
        data.qfrc_applied[:] = 0
        tip = data.site_xpos[self.tip].copy()
        if truth.floor:
            height, stiffness = truth.floor
            force = force + np.array([0, 0, stiffness * max(0.0, height - tip[2])])
        acts = tip + data.site_xmat[self.tip].reshape(3, 3) @ truth.load_offset
        mujoco.mj_applyFT(model, data, force, np.zeros(3), acts, model.site_bodyid[self.tip], data.qfrc_applied)
        if truth.compensated:
            data.qfrc_applied[self.dof] += truth.compensated * self.plain.weight(turned)
        d = data.qpos[self.dof] - turned
        k = self.shape.stiffness * (1 + truth.softer)
        data.qfrc_applied[self.dof] -= k * (truth.hardening * d**3 + truth.uneven * np.sin(UNEVEN * data.qpos[self.dof]) * d)

    def weight(self, q):
        """Torques of gravity that the joints have to hold."""
        self.data.qpos[:], self.data.qvel[:] = q, 0
        mujoco.mj_forward(self.model, self.data)
        return self.data.qfrc_bias[self.dof].copy()

    def unbalanced(self, q, turned, force):
        """Generalised forces that are out of balance at rest, constraints included."""
        model, data = self.model, self.data
        data.qpos[:], data.qvel[:] = q, 0
        self.apply(turned, force)
        mujoco.mj_forward(model, data)
        out = np.zeros(model.nv)
        mujoco.mj_mulM(model, data, out, data.qacc)
        return out

    def rest(self, turned, force):
        """The equilibrium without memory. Play lies at the side to which the load pushes it."""
        play = self.truth.play
        side = {i: 0.0 for i in play}
        flange = 0.0
        for _ in range(6):
            shifted = turned + np.array([play.get(i, 0.0) * side.get(i, 0.0) for i in range(self.shape.size)])
            if self.flange is not None:
                self.model.qpos_spring[self.flange] = flange * self.truth.loose_flange
            q = self.balance(shifted, force)
            yielded = q[self.dof] - shifted
            now = {i: np.sign(yielded[i]) for i in play}
            tipped = np.sign(q[self.flange] - self.model.qpos_spring[self.flange]) if self.flange is not None else 0.0
            if now == side and tipped == flange:
                return q
            side, flange = now, tipped
        raise ArithmeticError("a play that no load pushes to a side")

    def balance(self, turned, force):
        """Joint positions at which nothing is out of balance: springs yield to loads that hardly change; else Newton's method."""
        q = np.zeros(self.model.nv)
        q[self.dof] = turned
        last = np.inf
        for _ in range(12):
            step = self.unbalanced(q, turned, force) / self.springs
            size = np.abs(step).max()
            if size < AT_REST:
                return q
            if not size < 0.5 * last:
                break
            q, last = q + step, size
        return self.newton(q, turned, force)

    def newton(self, q, turned, force):
        """On MuJoCo's forces, with shorter steps where an element is slack."""
        r = self.unbalanced(q, turned, force)
        for _ in range(60):
            if np.abs(r / self.springs).max() < AT_REST:
                return q
            h = 1e-6
            jacobian = np.stack([(self.unbalanced(q + h * e, turned, force) - r) / h for e in np.eye(len(q))], 1)
            step = np.linalg.solve(jacobian, -r)
            size = min(1.0, 0.2 / max(1e-300, np.abs(step).max()))
            trial = self.unbalanced(q + size * step, turned, force)
            while np.linalg.norm(trial / self.springs) > np.linalg.norm(r / self.springs) and size > 1e-3:
                size /= 2
                trial = self.unbalanced(q + size * step, turned, force)
            q, r = q + size * step, trial
        raise ArithmeticError(f"no equilibrium: {np.abs(r / self.springs).max():.2g} of the stiffness is out of balance")

    def settle(self, q, turned_path, forces):
        """The equilibria with memory: MuJoCo's dynamics, each motion slow and damped, from rest at q. Joint positions by pose."""
        if self.truth.play or self.truth.loose_flange:
            raise ArithmeticError("play in motion, of which nothing here knows the way")
        model, data = self.model, self.data
        self.damp(q)
        data.qpos[:], data.qvel[:] = q, 0
        found = [q.copy()]
        for before, now, force in zip(turned_path, turned_path[1:], forces[1:]):
            for t in np.arange(0, MOVE + HOLD, BEAT * STEP):
                share = min(1.0, t / MOVE)
                turned = before + (now - before) * share**2 * (3 - 2 * share)
                self.apply(turned, force)
                for i in self.truth.belt:
                    tendon = model.tendon(f"belt_{i}").id
                    model.tendon_lengthspring[tendon] = turned[i]
                mujoco.mj_step(model, data, BEAT)
            found.append(data.qpos.copy())
        return found

    def damp(self, q):
        """So that no joint oscillates."""
        model, data = self.model, self.data
        data.qpos[:] = q
        mujoco.mj_forward(model, data)
        mass = np.zeros((model.nv, model.nv))
        mujoco.mj_fullM(model, data, mass)
        own = np.diag(mass)
        damping = np.maximum(4 * np.sqrt(self.springs * own), 10 * STEP * self.springs)
        model.dof_damping[self.dof] = damping[self.dof]

    def tip_pose(self, q):
        """Position and orientation of the measured point in the world."""
        self.data.qpos[:] = q
        mujoco.mj_kinematics(self.model, self.data)
        return self.data.site_xpos[self.tip].copy(), self.data.site_xmat[self.tip].reshape(3, 3).copy()
