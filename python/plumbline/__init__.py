"""Elastic serial chains under load: critical forces, equilibria and paths with certificates, and the diagnosis of the
gap between a chain's experiment and its model.

Lengths, stiffnesses and forces are in any units that fit together, angles in radians; experiments are in SI. Joints
count from the base. A wrong input raises `plumbline.Error`, a `ValueError` of one line: the place, what was found, what
was expected.
"""
from plumbline._engine import Error, version as __version__
from plumbline.diagnosis import Curve, Diagnosis, diagnose, diagnose_folder
from plumbline.loaded import (Branch, Equilibria, Path, Points, Proof, equilibria, equilibria_certificate, path,
                              path_certificate)
from plumbline.straight import (Modes, critical_certificate, critical_forces, critical_modes, lowest_critical_forces)
from plumbline.structures import Chain, StabilityLoss, critical_factors, stability_loss, structure_certificate

__all__ = [
    "Branch", "Chain", "Curve", "Diagnosis", "Equilibria", "Error", "Modes", "Path", "Points", "Proof", "StabilityLoss",
    "__version__", "critical_certificate", "critical_factors", "critical_forces", "critical_modes", "diagnose", "diagnose_folder", "equilibria",
    "equilibria_certificate", "lowest_critical_forces", "path", "path_certificate",
    "stability_loss", "structure_certificate",
]
