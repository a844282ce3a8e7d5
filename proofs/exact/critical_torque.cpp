#include "proofs/exact/critical_torque.hpp"

#include "proofs/exact/exact_matrix.hpp"

namespace plumbline::proofs {

CriticalTorque critical_torque(const SpaceStructure<Rational>& structure, int digits) {
  const TorquePencil<Rational> pencil = torque_pencil(structure);
  if (determinant(pencil.stiffness) == 0)
    throw Error("structure", "a mechanism, which moves across without any force",
                "ends, springs and stiffnesses that hold it");
  const PositiveRoots roots(pencil_determinant(pencil.stiffness, -pencil.torque));
  if (roots.all().empty())
    throw Error("load", "a torque that bends the straight chain at no value", "joints about two axes");
  const RootBracket& root = roots.all().front();
  return {narrowed(root, digits, [&](const Rational& torque) { return roots.reached(root, torque); }),
          pencil.conservative};
}

}  // namespace plumbline::proofs
