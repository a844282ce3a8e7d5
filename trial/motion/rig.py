"""The opponent's rigs: a servo and its load, in MuJoCo's own mechanics, with what MuJoCo lacks beside them.

Equations are those of docs/motion.md; no code is shared with Plumbline. Friction by MuJoCo's own constraint, unless it depends on speed or load:
then it is a torque that is computed before each step.
"""
import math
from dataclasses import dataclass

import mujoco
import numpy

STEP = 2e-4
GRAVITY = 9.81


def rigid(step):
    """Friction that holds, as dry friction does: it stops within one step. MuJoCo's own creeps."""
    return f'solreffriction="{2 * step} 1" solimpfriction="0.9999 0.9999 0.001 0.5 2"'


@dataclass
class Rig:
    """Numbers in SI; those that a model states, then those of the effects."""
    mass: float
    length: float
    hangs: bool  # a pendulum; else a wheel that no weight turns
    stall: float  # N m at duty 1
    damping: float  # back EMF and viscous friction together
    armature: float
    dry: float
    zero: float = 0.0
    # effects
    delay: float = 0.0
    lag: float = 0.0
    dead_band: float = 0.0
    duty_limit: float = 1.0
    speed_limit: float = math.inf
    command_offset: float = 0.0
    command_scale: float = 0.0
    encoder_scale: float = 0.0
    clock: float = 0.0
    play: float = 0.0
    gear_stiffness: float = math.inf
    gear_damping: float = 0.0
    spring: float = 0.0
    offset: float = 0.0
    extra_mass: float = 0.0
    stribeck: tuple = (0.0, 1.0)
    drag: float = 0.0
    loss: float = 0.0
    one_way: float = 0.0
    derivative: float = 0.0  # duty over the speed of the reading
    integral: float = 0.0  # duty over the integral of the error
    gravity_forward: float = 0.0  # share of the weight that the model has
    contact: tuple = (0.0, 0.0)  # stiffness, and the angle from which it acts: upward, or downward where it is negative
    cogging: tuple = (0.0, 1.0)
    ripple: tuple = (0.0, 1.0)  # of the motor's own torque
    # outside of the catalogue
    shaking: tuple = (0.0, 1.0)
    fading: float = 0.0

    @property
    def inertia(self):
        return self.mass * self.length**2


def model_of(rig):
    mass = rig.mass * (1 + rig.extra_mass)
    size = rig.inertia * (1 + rig.extra_mass)
    weight = f'<inertial pos="0 0 {-rig.length}" mass="{mass}" diaginertia="1e-9 1e-9 1e-9"/>'  # a point
    if not rig.hangs:  # the same inertia about the axis, balanced
        weight = f'<inertial pos="0 0 0" mass="{mass}" diaginertia="{size} {size} {size}"/>'
    # Damping acts at the end of MuJoCo's step; with so much less inertia it acts at its middle, and steps are of second order.
    armature = rig.armature - STEP / 2 * rig.damping
    rotor = f'armature="{armature}" damping="{rig.damping}" frictionloss="{max(0, rig.dry)}" {rigid(STEP)}'
    spring = f'stiffness="{rig.spring}"' if rig.spring else ""
    if rig.play == 0 and rig.gear_stiffness == math.inf:
        bodies = f'<body><joint name="motor" axis="0 1 0" {rotor} {spring}/>{weight}</body>'
    else:  # the joint turns on the rotor, which is a body of its own
        if rig.play:
            half = math.degrees(rig.play / 2)
            gear = f'limited="true" range="{-half} {half}" solreflimit="0.002 1"'
        else:
            gear = f'stiffness="{rig.gear_stiffness}" damping="{rig.gear_damping}"'
        bodies = (f'<body><joint name="motor" axis="0 1 0" {rotor}/><inertial pos="0 0 0" mass="1e-6" diaginertia="1e-7 1e-7 1e-7"/>'
                  f'<body><joint name="gear" axis="0 1 0" {gear}/>{weight}</body></body>')
    # Angle zero hangs down; gravity turned by the zero of the encoder instead of the geometry.
    g = (GRAVITY * math.sin(rig.zero), 0, -GRAVITY * math.cos(rig.zero))
    return mujoco.MjModel.from_xml_string(
        f'<mujoco><option timestep="{STEP}" integrator="implicitfast" gravity="{g[0]} {g[1]} {g[2]}"/>'
        f"<worldbody>{bodies}</worldbody></mujoco>")


class Servo:
    """From the command to the torque of the motor."""

    def __init__(self, rig, gain, first):
        self.rig, self.gain = rig, gain
        # A torque of MuJoCo's step acts from half a step before it: half of it is that of the command before.
        self.past = [first] * (1 + round(rig.delay / STEP))
        self.reference, self.acting = first, None
        self.speed, self.integrated = 0.0, 0.0

    def duty(self, reference, reading, speed):
        """Half a step of the servo."""
        rig = self.rig
        error = (1 + rig.command_scale) * reference + rig.command_offset - reading
        error -= max(-rig.dead_band, min(rig.dead_band, error))
        self.integrated = max(-1, min(1, self.integrated + STEP / 2 * rig.integral * error))
        duty = self.gain * error - rig.derivative * speed + self.integrated
        if rig.gravity_forward and rig.hangs:
            duty += rig.gravity_forward * rig.mass * GRAVITY * rig.length * math.sin(reading) / rig.stall
        return max(-rig.duty_limit, min(rig.duty_limit, duty))

    def torque(self, command, reading, speed, t):
        rig = self.rig
        self.past.append(command)
        duty, most = 0.0, rig.speed_limit * STEP / 2
        for late in (self.past.pop(0), self.past[0]):
            self.reference += max(-most, min(most, late - self.reference))
            duty += self.duty(self.reference, reading, 1.5 * speed - 0.5 * self.speed) / 2  # the speed at the middle of the step
        self.speed = speed
        share = 1 if rig.lag == 0 or self.acting is None else 1 - math.exp(-STEP / rig.lag)
        self.acting = duty if self.acting is None else self.acting + share * (duty - self.acting)
        return rig.stall * (1 - rig.fading * t) * self.acting


def beside(rig, angle, speed, motor):
    """Torques on the rotor that MuJoCo has no word for."""
    way = math.tanh(speed / 0.01)
    friction = way * (rig.stribeck[0] * math.exp(-abs(speed) / rig.stribeck[1]) + rig.drag * speed**2) + abs(way) * rig.one_way
    if rig.loss:
        weight = rig.mass * GRAVITY * rig.length * math.sin(angle + rig.zero) if rig.hangs else 0.0
        passed = (weight * rig.armature + motor * rig.inertia) / (rig.inertia + rig.armature)
        friction += way * rig.loss * abs(passed)
    wave = rig.cogging[0] * math.sin(rig.cogging[1] * angle) + motor * rig.ripple[0] * math.sin(rig.ripple[1] * angle)
    return -friction + rig.offset + wave


def follow(rig, gain, command, duration, rate, generator, quantum, sigma):
    """A log from rest: rows of time, command and position, as the logger has them."""
    model = model_of(rig)
    data = mujoco.MjData(model)
    every = round(1 / rate / STEP)
    servo = Servo(rig, gain, command(0.0))
    rows = []
    sent = command(0.0)
    geared = model.njnt == 2
    for k in range(round(duration / STEP)):
        t = k * STEP
        joint = sum(data.qpos)
        reading = joint / (1 + rig.encoder_scale)
        if k % every == 0:
            sent = command(t)
            noisy = reading + generator.normal(0, sigma)
            rows.append((t / (1 + rig.clock), sent, round(noisy / quantum) * quantum))
        motor = servo.torque(sent, reading, sum(data.qvel) / (1 + rig.encoder_scale), t)
        data.qfrc_applied[0] = motor + beside(rig, data.qpos[0], data.qvel[0], motor)
        load = rig.shaking[0] * math.sin(rig.shaking[1] * t)
        stiffness, begin = rig.contact
        if begin * joint > begin * begin:
            load -= stiffness * (joint - begin)
        data.qfrc_applied[1 if geared else 0] += load
        if geared:
            data.qfrc_applied[0] += load  # what turns the joint turns the rotor's coordinate with it
        mujoco.mj_step(model, data)
    return numpy.array(rows)
