"""MuJoCo's model of the true arm: its departures from the nominal model as bodies, joints, springs and tendons."""
import numpy as np

from model_files import inertia, quaternion, rotation, rotation_about, text

STEP = 0.004  # s, of the dynamics
HEAVY = 5e-4  # s^2: inertia over stiffness of what rubs, so that MuJoCo's soft friction sticks
RIGID = f'solimpfriction="0.9999 0.9999 0.001" solreffriction="{2 * STEP} 1"'
LOOSE_TOOL = 1e-3  # kg of the last link's: what hangs behind a loose flange, so that it tips without a load too
PIECES = 8  # of a link that bends
LAST = 1 - 0.5 / PIECES  # share of its length at which the last piece begins
WEIGHTLESS = 1e-6  # kg, which MuJoCo wants of a body
STOP = 1e6  # N m/rad: a flange that has tipped as far as it can


def fine_joint(name, kind, axis, stiffness):
    """A spring about zero that the nominal model lacks."""
    return f'<joint name="{name}" type="{kind}" axis="{text(axis)}" stiffness="{stiffness:.12g}" armature="0.01"/>'


def across(direction):
    """Two unit vectors across a direction."""
    first = np.cross(direction, np.eye(3)[np.argmin(np.abs(direction))])
    first /= np.linalg.norm(first)
    return first, np.cross(direction, first)


def document(shape, truth):
    """MuJoCo's text of the true arm."""
    base = rotation_about(truth.base_tilt)
    lines = ['<mujoco><compiler angle="radian"/><option gravity="0 0 -9.81" timestep="%g" integrator="implicitfast"/>' % STEP,
             '<size memory="4M"/><worldbody>', *world(shape, truth),
             f'<body name="base" pos="{text(truth.base_shift)}" quat="{text(quaternion(base))}">']
    lines += [fine_joint(f"base_{a}", "hinge", np.eye(3)[a], 1 / c) for a, c in enumerate(truth.base_compliance) if c > 0]
    lines.append('<inertial pos="0 0 0" mass="1e-6" diaginertia="1e-6 1e-6 1e-6"/>')
    bodies = 1
    for i in range(shape.size):
        lines += link_body(shape, truth, i)
        bent = bent_pieces(shape, truth, i)
        bodies += 1 + len(bent)
        lines += bent
    lines += tool(shape, truth) + ["</body>"] * bodies
    return "\n".join(lines + ["</worldbody>", *tendons(shape, truth), *actuators(shape, truth), "</mujoco>"])


def world(shape, truth):
    """What stands beside the arm."""
    lines = []
    if truth.cable:
        lines.append(f'<site name="cable_world" pos="{text(truth.cable[2])}"/>')
    for i, (stiffness, torque) in truth.belt.items():
        lines.append(f'<body name="belt_body_{i}" pos="0 0 -9"><inertial pos="0 0 0" mass="1e-3" diaginertia="1e-3 1e-3 1e-3"/>'
                     f'<joint name="belt_{i}" type="{shape.links[i].kind}" axis="0 0 1" frictionloss="{torque}" {RIGID}'
                     f' armature="{stiffness * HEAVY}" damping="{stiffness / 20}"/></body>')
    return lines


def link_body(shape, truth, i):
    """A link and its joint; what follows is inside it."""
    link = shape.links[i]
    start = np.array(link.place) + truth.shift[i]
    if i > 0 and (i - 1) in truth.bending:
        start = start - np.array(link.place) * LAST  # the bent link's last piece begins there
    turn = rotation(link.turn) @ rotation_about(truth.tilt[i])
    mass, centre = masses(shape, truth, i)[0]
    friction = f' frictionloss="{truth.friction[i]}" {RIGID} armature="{link.stiffness * HEAVY}"' if truth.friction[i] > 0 else ""
    lines = [f'<body name="link_{i + 1}" pos="{text(start)}" quat="{text(quaternion(turn))}">',
             f'<inertial pos="{text(centre)}" mass="{mass:.12g}" diaginertia="{text([inertia(link)] * 3)}"/>']
    lines.append(f'<joint name="{link.joint}" type="{link.kind}" axis="{text(link.axis)}"{friction}/>')
    if i == 0 and truth.gas_spring:  # its bracket turns with the column
        lines.append(f'<site name="gas_base" pos="{text(turn.T @ (np.array(truth.gas_spring[2]) - start))}"/>')
    for name, point in anchors(truth, i):
        lines.append(f'<site name="{name}" pos="{text(point)}"/>')
    return lines


def anchors(truth, i):
    """Ends of tendons on a link."""
    held = [("gas_link", truth.gas_spring), ("cable_link", truth.cable)]
    return [(name, element[4]) for name, element in held if element and element[3] == i]


def reach_of(shape, i):
    """From a link's joint to the next, or to the tip."""
    return np.array(shape.links[i + 1].place if i + 1 < shape.size else shape.tip)


def masses(shape, truth, i):
    """Masses of a link's pieces with their centres in the frame of the link; of a rigid link the only one.

    A tube lies evenly between the ends; what its centre leaves, a motor or a gear, sits at the nearer end.
    """
    link = shape.links[i]
    mass, centre = link.mass * (1 + truth.heavier[i]), np.array(link.centre) + truth.centre[i]
    if i not in truth.bending:
        return [(mass, centre)]
    reach = reach_of(shape, i)
    along = np.clip(centre @ reach / (reach @ reach), 0.0, 1.0)
    tube = 2 * min(along, 1 - along)
    cuts = np.array([0.0, *(np.arange(PIECES) + 0.5) / PIECES, 1.0])
    share, at = tube * np.diff(cuts), (cuts[1:] + cuts[:-1]) / 2
    end, motor = (0, 0.0) if along < 0.5 else (-1, 1.0)
    at[end] = (share[end] * at[end] + (1 - tube) * motor) / max(share[end] + 1 - tube, 1e-300)
    share[end] += 1 - tube
    return [(max(mass * s, WEIGHTLESS), centre + (a - along) * reach) for s, a in zip(share, at)]


def bent_pieces(shape, truth, i):
    """A link that bends as a cantilever tube of rigidity EI, in pieces: each has hinges of l/EI in its middle, slides of l^3/(12 EI), a twist of 1.3 l/EI."""
    if i not in truth.bending:
        return []
    reach = reach_of(shape, i)
    length, rigidity = np.linalg.norm(reach) / PIECES, truth.bending[i]
    found = []
    for k, (mass, centre) in enumerate(masses(shape, truth, i)[1:]):
        joints = [fine_joint(f"twist_{i}_{k}", "hinge", reach, rigidity / length / 1.3)]
        for a, axis in enumerate(across(reach / np.linalg.norm(reach))):
            joints += [fine_joint(f"bend_{i}_{k}_{a}", "hinge", axis, rigidity / length),
                       fine_joint(f"sag_{i}_{k}_{a}", "slide", axis, 12 * rigidity / length**3)]
        start = reach * (0.5 if k == 0 else 1.0) / PIECES
        found.append(f'<body name="piece_{i}_{k}" pos="{text(start)}"><inertial pos="{text(centre - (k + 0.5) / PIECES * reach)}"'
                     f' mass="{mass:.12g}" diaginertia="1e-6 1e-6 1e-6"/>' + "".join(joints))
    return found


def tool(shape, truth):
    """The measured point, and what the flange carries."""
    last = shape.size - 1
    tip = np.array(shape.tip) + truth.tip_shift
    if last in truth.bending:
        tip = tip - np.array(shape.tip) * LAST
    if truth.loose_flange == 0 and truth.payload == 0:
        return [f'<site name="tip" pos="{text(tip)}"/>']
    hinge = f'<joint name="flange" type="hinge" axis="0 1 0" armature="0.01" stiffness="{STOP}"/>' if truth.loose_flange > 0 else ""
    mass = 1e-6 + truth.payload + (LOOSE_TOOL if truth.loose_flange > 0 else 0)
    return [f'<body name="tool">{hinge}<inertial pos="{text(tip)}" mass="{mass}" diaginertia="1e-4 1e-4 1e-4"/>'
            f'<site name="tip" pos="{text(tip)}"/></body>']


def tendons(shape, truth):
    lines = []
    if truth.gas_spring:
        lines.append(f'<spatial name="gas" stiffness="{truth.gas_spring[0]}" springlength="{truth.gas_spring[1]}">'
                     '<site site="gas_base"/><site site="gas_link"/></spatial>')
    if truth.cable:
        lines.append(f'<spatial name="cable" stiffness="{truth.cable[0]}" springlength="0 {truth.cable[1]}"><site site="cable_world"/>'
                     f'<site site="cable_link"/></spatial>')
    for i, (stiffness, _) in truth.belt.items():
        lines.append(f'<fixed name="belt_{i}" stiffness="{stiffness}"><joint joint="{shape.links[i].joint}" coef="1"/>'
                     f'<joint joint="belt_{i}" coef="-1"/></fixed>')
    return ["<tendon>", *lines, "</tendon>"] if lines else []


def actuators(shape, truth):
    k = shape.stiffness * (1 + truth.softer)
    return ["<actuator>", *[f'<position joint="{link.joint}" kp="{k[i]:.12g}"/>' for i, link in enumerate(shape.links)], "</actuator>"]
