(* What every theorem rests on: printed here, compared with assumptions.txt. *)
Require chain determinant string recursion forces definite modes eigenvalues stability checker integers sound.

Print Assumptions definite.moment_form.
Print Assumptions definite.stiffness_form.
Print Assumptions definite.M_definite.
Print Assumptions definite.det_M.
Print Assumptions definite.det_A.
Print Assumptions definite.rank_A.
Print Assumptions definite.det_B.
Print Assumptions definite.det_B_zero.
Print Assumptions definite.energy_factor.
Print Assumptions determinant.recursion_det.
Print Assumptions recursion.string_theorem.
Print Assumptions forces.critical_forces.
Print Assumptions forces.simple_forces.
Print Assumptions forces.roots_of_inj.
Print Assumptions modes.critical_root.
Print Assumptions modes.string_mode.
Print Assumptions eigenvalues.rank_BinvA.
Print Assumptions eigenvalues.rank_B.
Print Assumptions eigenvalues.jordan_chain.
Print Assumptions eigenvalues.kernel_of_BinvA.
Print Assumptions eigenvalues.characteristic_polynomial.
Print Assumptions eigenvalues.zero_twice.
Print Assumptions eigenvalues.eigenvalues.
Print Assumptions eigenvalues.eigenvalues_distinct.
Print Assumptions eigenvalues.semisimple.
Print Assumptions stability.energy_least.
Print Assumptions sound.forces_sound.
