(* What the theorems rest on: all of them in one term, whose assumptions are those of any. The output is compared with
   assumptions.txt. *)
Require chain determinant string recursion forces definite modes eigenvalues stability checker integers sound.

Definition theorems :=
  (@definite.moment_form,
   @definite.stiffness_form,
   @definite.M_definite,
   @definite.det_M,
   @definite.det_A,
   @definite.rank_A,
   @definite.det_B,
   @definite.det_B_zero,
   @definite.energy_factor,
   @determinant.recursion_det,
   @recursion.string_theorem,
   @forces.critical_forces,
   @forces.simple_forces,
   @forces.roots_of_inj,
   @modes.critical_root,
   @modes.string_mode,
   @eigenvalues.rank_BinvA,
   @eigenvalues.rank_B,
   @eigenvalues.jordan_chain,
   @eigenvalues.kernel_of_BinvA,
   @eigenvalues.characteristic_polynomial,
   @eigenvalues.zero_twice,
   @eigenvalues.eigenvalues,
   @eigenvalues.eigenvalues_distinct,
   @eigenvalues.semisimple,
   @stability.energy_least,
   @sound.forces_sound).

Print Assumptions theorems.
