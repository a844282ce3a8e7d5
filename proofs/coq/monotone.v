(* No critical force falls where stiffnesses grow: theorem "Monotone in stiffness" of theorems.md. *)
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp Require Import polyrcf.
Require Import chain determinant string recursion forces definite modes stability inertia directions.

Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Import Order.TTheory GRing.Theory Num.Theory.
Local Open Scope ring_scope.

Section Monotone.

Variables (R : rcfType) (n : nat) (L k k' : nat -> R).
Hypotheses (two : (1 < n)%N) (links : chain_of_links n L k) (one : at_most_one_passive n k).
Hypotheses (links' : chain_of_links n L k') (one' : at_most_one_passive n k').
Hypothesis stiffer : forall i, (i < n)%N -> k i <= k' i.

Lemma energy_monotone F (q : 'cV[R]_n) : second_variation L k F q <= second_variation L k' F q.
Proof.
rewrite !second_variationE ler_add2r; apply: ler_sum => i _.
by rewrite ler_wpmul2r ?sqr_ge0 // stiffer.
Qed.

Theorem forces_monotone fs fs' m : roots_of (D n L k) fs -> roots_of (D n L k') fs' -> (m < n.-1)%N -> fs`_m <= fs'`_m.
Proof.
move=> rfs rfs' m_n; rewrite -[X in _ <= fs'`_X]addn0.
apply: (forces_compared two links one two links' one' (X := 1%:M) (Z := [::]) rfs rfs') => //; last by rewrite addn0.
by move=> F q _ axis _; rewrite mul1mx; split=> //; apply: energy_monotone.
Qed.

End Monotone.
