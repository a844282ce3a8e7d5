"""What is drawn: rigs of many sizes, their servos, motions and encoders, and what the model of each lacks."""
import math

import numpy
from rig import Rig

RATES = (50, 100, 200, 500)
PERIODS = (7, 24)  # in a turn of the joint, that its torque may have: said in every experiment


def log_between(generator, low, high):
    return math.exp(generator.uniform(math.log(low), math.log(high)))


def drawn_rig(generator):
    mass, length = log_between(generator, 0.1, 1.5), log_between(generator, 0.06, 0.25)
    inertia, torque = mass * length**2, mass * 9.81 * length
    hangs = generator.random() < 0.8
    natural = math.sqrt(torque / inertia)
    return Rig(mass, length, hangs, stall=torque * log_between(generator, 2, 5), damping=inertia * natural * log_between(generator, 0.5, 2),
               armature=inertia * log_between(generator, 0.2, 1.5), dry=torque * log_between(generator, 0.02, 0.12), zero=0.0)


# Names of Plumbline's rows, and how each is planted: by its share of a typical size.
def effects(rig, g):
    torque = rig.mass * 9.81 * rig.length
    size = log_between(g, 0.6, 2.5)
    sign = 1 if g.random() < 0.5 else -1
    critical = 2 * math.sqrt(rig.inertia * torque)
    return {
        "command_delay": {"delay": 0.02 * size},
        "drive_lag": {"lag": 0.02 * size},
        "dead_band": {"dead_band": 0.012 * size},
        "duty_limit": {"duty_limit": 0.75 / (0.7 + size)},
        "speed_limit": {"speed_limit": 1.6 / size},
        "clock_rate": {"clock": 0.04 * sign * size},
        "command_offset": {"command_offset": 0.02 * sign * size},
        "command_scale": {"command_scale": 0.05 * sign * size},
        "encoder_scale": {"encoder_scale": 0.04 * sign * size},
        "backlash": {"play": 0.03 * size},
        "elastic_gear": {"gear_stiffness": torque / (0.12 * size), "gear_damping": 0.04 * critical},
        "stribeck_friction": {"stribeck": (0.1 * torque * size, 0.4)},
        "quadratic_drag": {"drag": 0.03 * torque * size},
        "load_friction": {"loss": min(0.5, 0.15 * size)},
        "one_way_friction": {"one_way": 0.04 * torque * sign * size},
        "load_mass": {"extra_mass": 0.12 * sign * size},
        "torque_offset": {"offset": 0.06 * torque * sign * size},
        "spring": {"spring": 0.15 * torque * size},
        "derivative_gain": {"derivative": 0.3 * size * rig.damping / rig.stall},
        "integral_gain": {"integral": 1.5 * size},
        "gravity_forward": {"gravity_forward": min(1.0, 0.3 * size)},
        "contact_above": {"contact": (2 * torque * size, 0.25 / size)},
        "contact_below": {"contact": (2 * torque * size, -0.25 / size)},
        f"cogging({PERIODS[0]})": {"cogging": (0.12 * torque * size, PERIODS[0])},
        f"torque_ripple({PERIODS[1]})": {"ripple": (min(0.6, 0.25 * size), PERIODS[1])},
        "joint_friction": {"dry": rig.dry + 0.06 * torque * size},
        "armature": {"armature": rig.armature * (1 + 0.3 * size)},
        "viscous_friction": {"damping": rig.damping * (1 + 0.3 * size)},
        "stall_torque": {"stall": rig.stall * (1 - 0.12 * size)},
        "encoder_zero": {"zero": 0.03 * sign * size},
    }


def outside(rig, g):
    torque = rig.mass * 9.81 * rig.length
    size = log_between(g, 0.8, 2)
    return {
        "cogging": {"cogging": (0.12 * torque * size, 31.0)},  # of a count that nobody says
        "shaken base": {"shaking": (0.12 * torque * size, 37.0)},
        "motor that fades": {"fading": 0.06 * size},
    }


# The model leaves these to the fit in a third of the experiments; then a wrong one is no cause.
UNKNOWN = ("stall_torque", "armature", "joint_friction", "viscous_friction", "encoder_zero")
# What a log of positions cannot tell apart, beside the row itself: each of a class is a right answer.
SAME = [{"viscous_friction", "back_emf", "derivative_gain"}]


def motions(g):
    a, b = g.uniform(0.5, 0.9), g.uniform(0.15, 0.3)
    w, v, c = g.uniform(1.6, 3.0), g.uniform(5, 9), g.uniform(0.9, 1.8)
    return {
        "sines": lambda t: a * math.sin(w * t) + b * math.sin(v * t),
        "chirp": lambda t: 0.9 * a * math.sin(c * t * t),
        "slow": lambda t: a * (min(t, 1.2) / 1.2 - 0.5 * max(0.0, min(t - 1.8, 0.8)) / 0.8),
        "steps": lambda t: a * (0.0, 0.6, -0.5, 0.9)[min(3, int(t / 0.9))],
    }


def drawn(number, seed):
    """A rig as it is, the rig as its model has it, and how it is logged."""
    g = numpy.random.default_rng([seed, number])
    nominal = drawn_rig(g)
    unknown = UNKNOWN if g.random() < 1 / 3 else ()
    kind = g.choice(["one", "one", "one", "one", "one", "two", "none", "outside"])
    listed = [name for name in effects(nominal, g) if name not in unknown]
    if not nominal.hangs:  # no weight acts: the zero and the mass alone do not show
        listed = [name for name in listed if name not in ("encoder_zero", "load_mass", "gravity_forward")]
    truth = []
    if kind == "outside":
        truth = [str(g.choice(sorted(outside(nominal, g))))]
        values = outside(nominal, g)[truth[0]]
    else:
        count = {"none": 0, "one": 1, "two": 2}[kind]
        truth = sorted(str(name) for name in g.choice(listed, size=count, replace=False))
        values = {}
        for name in truth:
            values.update(effects(nominal, g)[name])
    actual = Rig(**{**vars(nominal), **values})
    if unknown:  # the drive's own numbers are others than anybody's guess
        for name in ("stall", "armature", "dry", "damping"):
            setattr(actual, name, getattr(actual, name) * log_between(g, 0.8, 1.25))
        actual.zero += g.normal(0, 0.015)
    logging = {"rate": int(g.choice(RATES)), "quantum": 2 * math.pi / int(g.choice([4096, 4096, 16384])), "sigma": 6e-4}
    return g, nominal, actual, str(kind), truth, unknown, logging, motions(g)
