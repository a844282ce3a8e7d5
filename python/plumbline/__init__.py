"""Elastic serial chains under load: critical forces, equilibria and paths with certificates, and the diagnosis of the
gap between a chain's experiment and its model.

Lengths, stiffnesses and forces are in any units that fit together, angles in radians; experiments are in SI. Joints
count from the base. A wrong input raises `plumbline.Error`, a `ValueError` of one line: the place, what was found, what
was expected.
"""
import numpy as _numpy

from plumbline._engine import Error, newest_numpy as _newest_numpy, version as __version__

if int(_numpy.__version__.split(".")[0]) > _newest_numpy:
    raise ImportError(f"plumbline: found NumPy {_numpy.__version__}, expected NumPy {_newest_numpy}: the engine was built with "
                      "pybind11 before 2.12; build it with a later one (pip install pybind11)")

from plumbline.arms import Arm, read_arm
from plumbline.diagnosis import CorrectedModel, Curve, Diagnosis, diagnose, diagnose_arm, diagnose_folder, plan
from plumbline.loaded import (Branch, Equilibria, Path, Points, Proof, equilibria, equilibria_certificate, path,
                              path_certificate)
from plumbline.models import Draft, Guess, NominalChain, draft, read_chain
from plumbline.program import check, check_experiment, diagnose_folders, diagnose_logs, figure, plan_folder, reference, trial, verify
from plumbline.recordings import read_logs, read_recording
from plumbline.straight import (Modes, critical_certificate, critical_forces, critical_modes, lowest_critical_forces)
from plumbline.structures import (Chain, StabilityLoss, critical_factors, stability_loss, structure_certificate,
                                  structure_equilibria, structure_path)

__all__ = [
    "Arm", "Branch", "Chain", "CorrectedModel", "Curve", "Diagnosis", "Draft", "Equilibria", "Error", "Guess", "Modes",
    "NominalChain", "Path", "Points", "Proof", "StabilityLoss", "__version__", "check", "check_experiment",
    "critical_certificate", "critical_factors", "critical_forces", "critical_modes", "diagnose", "diagnose_arm",
    "diagnose_folder", "diagnose_folders", "diagnose_logs", "draft", "equilibria", "equilibria_certificate", "figure",
    "lowest_critical_forces", "path", "path_certificate", "plan", "plan_folder", "read_arm", "read_chain", "read_logs",
    "read_recording", "reference", "stability_loss", "structure_certificate", "structure_equilibria", "structure_path", "trial",
    "verify",
]
