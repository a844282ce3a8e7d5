"""The true arm in MuJoCo: its departures from the nominal model as bodies, joints, springs and tendons, and its equilibria."""
import mujoco
import numpy as np

from model_files import inertia, quaternion, rotation, rotation_about, text
from truth import Truth

MOVE, HOLD, STEP = 2.0, 1.0, 0.004  # s: of a motion between two poses, of the rest after it, of a time step
BEAT = 10  # steps between two commands of the servos
HEAVY = 5e-4  # s^2: inertia over stiffness of what rubs, so that MuJoCo's soft friction sticks
RIGID = f'solimpfriction="0.9999 0.9999 0.001" solreffriction="{2 * STEP} 1"'
LOOSE_TOOL = 0.3  # kg: the tool behind a loose flange
STOP = 3000.0  # N m/rad: a flange that has tipped as far as it can
AT_REST = 1e-9  # rad or m: a smaller step is none


def fine_joint(name, kind, axis, stiffness):
    """A spring about zero that the nominal model lacks."""
    return f'<joint name="{name}" type="{kind}" axis="{text(axis)}" stiffness="{stiffness:.12g}" armature="0.01"/>'


def across(direction):
    """Two unit vectors across a direction."""
    first = np.cross(direction, np.eye(3)[np.argmin(np.abs(direction))])
    first /= np.linalg.norm(first)
    return first, np.cross(direction, first)


mujoco.set_mju_user_warning(lambda text: None)  # of steps of Newton's method that went too far; what fails is told by its residual


class TrueArm:
    """MuJoCo's model of a shape with a truth."""

    def __init__(self, shape, truth):
        self.shape, self.truth = shape, truth
        self.model = mujoco.MjModel.from_xml_string(self.document())
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

    # the document

    def document(self):
        truth, shape = self.truth, self.shape
        base = rotation_about(truth.base_tilt)
        lines = ['<mujoco><compiler angle="radian"/><option gravity="0 0 -9.81" timestep="%g" integrator="implicitfast"/>' % STEP,
                 '<size memory="4M"/><worldbody>', *self.world(),
                 f'<body name="base" pos="{text(truth.base_shift)}" quat="{text(quaternion(base))}">']
        lines += [fine_joint(f"base_{a}", "hinge", np.eye(3)[a], 1 / c) for a, c in enumerate(truth.base_compliance) if c > 0]
        lines.append('<inertial pos="0 0 0" mass="1e-6" diaginertia="1e-6 1e-6 1e-6"/>')
        if truth.gas_spring:
            lines.append(f'<site name="gas_base" pos="{text(truth.gas_spring[2])}"/>')
        bodies = 1
        for i in range(shape.size):
            lines += self.link(i)
            bodies += 1 + len(self.bent(i))
            lines += self.bent(i)
        lines += self.tool() + ["</body>"] * bodies
        return "\n".join(lines + ["</worldbody>", *self.tendons(), *self.actuators(), "</mujoco>"])

    def world(self):
        truth, lines = self.truth, []
        if truth.cable:
            lines.append(f'<site name="cable_world" pos="{text(truth.cable[2])}"/>')
        for i, (stiffness, torque) in truth.belt.items():
            kind, axis = self.shape.links[i].kind, "0 0 1"
            lines.append(f'<body name="belt_body_{i}" pos="0 0 -9"><inertial pos="0 0 0" mass="{1e-3}" diaginertia="1e-3 1e-3 1e-3"/>'
                         f'<joint name="belt_{i}" type="{kind}" axis="{axis}" frictionloss="{torque}" {RIGID}'
                         f' armature="{stiffness * HEAVY}" damping="{stiffness / 20}"/></body>')
        return lines

    def link(self, i):
        truth, link = self.truth, self.shape.links[i]
        start = np.array(link.place) + truth.shift[i]
        if i > 0 and (i - 1) in truth.bending:
            start = start - np.array(link.place) / 2  # the bent link's second half begins at its middle
        turn = rotation(link.turn) @ rotation_about(truth.tilt[i])
        mass = link.mass * (1 + truth.heavier[i])
        friction = f' frictionloss="{truth.friction[i]}" {RIGID} armature="{link.stiffness * HEAVY}"' if truth.friction[i] > 0 else ""
        lines = [f'<body name="link_{i + 1}" pos="{text(start)}" quat="{text(quaternion(turn))}">',
                 f'<inertial pos="{text(np.array(link.centre) + truth.centre[i])}" mass="{mass:.12g}" diaginertia="{text([inertia(link)] * 3)}"/>']
        lines.append(f'<joint name="{link.joint}" type="{link.kind}" axis="{text(link.axis)}"{friction}/>')
        for name, point in self.anchors(i):
            lines.append(f'<site name="{name}" pos="{text(point)}"/>')
        return lines

    def anchors(self, i):
        truth = self.truth
        held = [("gas_link", truth.gas_spring), ("cable_link", truth.cable)]
        return [(name, element[4]) for name, element in held if element and element[3] == i]

    def bent(self, i):
        """A link that bends as a cantilever tube of rigidity EI: hinges of L/EI in its middle, slides of L^3/(12 EI), a twist of 1.3 L/EI."""
        if i not in self.truth.bending:
            return []
        reach = np.array(self.shape.links[i + 1].place if i + 1 < self.shape.size else self.shape.tip)
        length, rigidity = np.linalg.norm(reach), self.truth.bending[i]
        joints = [fine_joint(f"twist_{i}", "hinge", reach / length, rigidity / length / 1.3)]
        for a, axis in enumerate(across(reach / length)):
            joints += [fine_joint(f"bend_{i}_{a}", "hinge", axis, rigidity / length),
                       fine_joint(f"sag_{i}_{a}", "slide", axis, 12 * rigidity / length**3)]
        return [f'<body name="half_{i}" pos="{text(reach / 2)}"><inertial pos="0 0 0" mass="1e-6" diaginertia="1e-6 1e-6 1e-6"/>' + "".join(joints)]

    def tool(self):
        truth = self.truth
        last = self.shape.size - 1
        tip = np.array(self.shape.tip) + truth.tip_shift
        if last in truth.bending:
            tip = tip - np.array(self.shape.tip) / 2
        if truth.loose_flange == 0 and truth.payload == 0:
            return [f'<site name="tip" pos="{text(tip)}"/>']
        hinge = f'<joint name="flange" type="hinge" axis="0 1 0" armature="0.01" stiffness="{STOP}"/>' if truth.loose_flange > 0 else ""
        mass = 1e-6 + truth.payload + (LOOSE_TOOL if truth.loose_flange > 0 else 0)
        return [f'<body name="tool">{hinge}<inertial pos="{text(tip)}" mass="{mass}" diaginertia="1e-4 1e-4 1e-4"/>'
                f'<site name="tip" pos="{text(tip)}"/></body>']

    def tendons(self):
        truth, lines = self.truth, []
        if truth.gas_spring:
            lines.append(f'<spatial name="gas" stiffness="{truth.gas_spring[0]}" springlength="{truth.gas_spring[1]}"><site site="gas_base"/><site site="gas_link"/></spatial>')
        if truth.cable:
            lines.append(f'<spatial name="cable" stiffness="{truth.cable[0]}" springlength="0 {truth.cable[1]}"><site site="cable_world"/>'
                         f'<site site="cable_link"/></spatial>')
        for i, (stiffness, _) in truth.belt.items():
            lines.append(f'<fixed name="belt_{i}" stiffness="{stiffness}"><joint joint="{self.shape.links[i].joint}" coef="1"/>'
                         f'<joint joint="belt_{i}" coef="-1"/></fixed>')
        return ["<tendon>", *lines, "</tendon>"] if lines else []

    def actuators(self):
        k = self.shape.stiffness * (1 + self.truth.softer)
        return ["<actuator>", *[f'<position joint="{link.joint}" kp="{k[i]:.12g}"/>' for i, link in enumerate(self.shape.links)], "</actuator>"]

    # the statics

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
        data.qfrc_applied[self.dof] -= k * truth.hardening * d**3

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
