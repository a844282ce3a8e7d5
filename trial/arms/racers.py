"""Other ways to fit an experiment with an arm: least squares as a user writes it, and MuJoCo's system identification.

Each has names of its parameters, fit(experiment) -> (what predict takes, parameters in standard errors), and
predict(that, experiment) -> places and reached coordinates.
"""
import mujoco
import numpy as np
from mujoco import sysid
from scipy.optimize import least_squares

from batch_statics import PlainArm
from model_files import mjcf


def predicted(arm, experiment, turned):
    """Places of the points, and reached coordinates of the joints as their encoders count, by reading."""
    q = arm.rest(turned, experiment.forces)
    *_, place, axes = arm.posture(q)
    places = np.stack([place + axes @ offset for offset in experiment.offsets], 1)
    return places, experiment.commands + q - turned


def residual(experiment, places, reached):
    parts = [(places - experiment.places) / experiment.sigma["place"]]
    if experiment.reached is not None:
        parts.append((reached - experiment.reached) / experiment.sigma["q"])
    return np.concatenate([part.ravel() for part in parts])


class OffsetsAndStiffnesses:
    """Zeros and stiffnesses of all joints, and the place of the tool."""
    name = "zeros and stiffnesses"

    def __init__(self, shape):
        self.shape = shape
        joints = range(1, shape.size + 1)
        self.names = [f"zero({j})" for j in joints] + [f"stiffness({j})" for j in joints] + ["tool x", "tool y", "tool z"]

    def predict(self, x, experiment):
        n = self.shape.size
        arm = PlainArm.of_shape(self.shape)
        arm.stiffness, arm.tip = arm.stiffness * np.exp(x[n:2 * n]), arm.tip + x[2 * n:]
        return predicted(arm, experiment, experiment.commands + x[:n])

    def fit(self, experiment):
        n = self.shape.size
        scale = np.concatenate([np.full(n, 1e-3), np.full(n, 0.1), np.full(3, 1e-3 * self.shape.length)])

        def r(u):
            return residual(experiment, *self.predict(scale * u, experiment))

        # a weak tie to the nominal values holds what the poses do not show
        found = least_squares(lambda u: np.concatenate([r(u), 1e-2 * u]), np.zeros(2 * n + 3), diff_step=1e-3, max_nfev=10)
        noise = np.sqrt(np.mean(r(found.x) ** 2))
        error = noise * np.sqrt(np.diag(np.linalg.inv(found.jac.T @ found.jac)))
        return scale * found.x, found.x / error


class Sysid:
    """MuJoCo's system identification: servo gains, masses and centres of the bodies."""
    name = "mujoco.sysid"

    def __init__(self, shape):
        self.shape = shape
        self.text = mjcf(shape)
        self.arm = PlainArm.of_shape(shape)
        joints = range(1, shape.size + 1)
        self.names = [f"gain({j})" for j in joints] + [f"{what}({j})" for j in joints for what in ("mass", "centre x", "centre y", "centre z")]

    def parameters(self):
        """Factors of the gains, and of the masses; displacements of the centres."""
        shape, found = self.shape, sysid.ParameterDict()
        far = 0.3 * shape.length

        for i, link in enumerate(shape.links):
            def gain(spec, p, i=i, link=link):
                sysid.apply_pgain(spec, spec.actuators[i].name, link.stiffness * np.exp(p.value[0]))

            found.add(sysid.Parameter(f"gain_{i}", 0.0, min_value=-3.0, max_value=3.0, modifier=gain))
        for i, link in enumerate(shape.links):
            def inertial(spec, p, i=i, link=link):
                body = spec.body(f"link_{i + 1}")
                body.mass = link.mass * np.exp(p.value[0])
                body.ipos = np.array(link.centre) + far * p.value[1:]

            found.add(sysid.Parameter(f"body_{i}", np.zeros(4), min_value=-np.ones(4) * 3, max_value=np.ones(4) * 3, modifier=inertial))
        return found

    def predict(self, parameters, experiment):
        spec = mujoco.MjSpec.from_string(self.text)
        for i, actuator in enumerate(spec.actuators):
            actuator.name = f"servo_{i}"
        return predicted(self.arm.with_numbers_of(sysid.apply_param_modifiers(parameters, spec)), experiment, experiment.commands)

    def fit(self, experiment):
        def residuals(x, parameters, **_):
            x = np.asarray(x)
            columns = []
            for column in (x[:, None] if x.ndim == 1 else x).T:
                parameters.update_from_vector(column)
                columns.append(np.append(residual(experiment, *self.predict(parameters, experiment)), 1e-2 * column))
            result = np.stack(columns, 1)
            return [result[:, 0] if x.ndim == 1 else result], [], []

        found, result = sysid.optimize(self.parameters(), residuals, optimizer="mujoco", verbose=False, max_iters=10)
        x, jacobian = found.as_vector(), np.asarray(result.jac)
        rows = jacobian.shape[0] - len(x)
        noise = np.sqrt(np.sum(np.asarray(residuals(x, found)[0][0])[:rows] ** 2) / rows)
        error = noise * np.sqrt(np.diag(np.linalg.inv(jacobian.T @ jacobian)))
        found.update_from_vector(x)
        return found, x / error
