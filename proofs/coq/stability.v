(* Towards the stability of the straight chain: its quadratic energy along the string is no less than that of springs
   in series, wherever all deflections of the recursion are positive. *)
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp Require Import polyrcf.
From mathcomp Require Import ring.
Require Import chain determinant string recursion forces definite modes.

Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Import Order.TTheory GRing.Theory Num.Theory.
Local Open Scope ring_scope.

(* The energy along the string: springs k_i q_i^2, beads -F m_i s_i^2. *)
Section Along.

Variables (R : rcfType) (z k q s : nat -> R) (F : R) (m : nat).
Hypotheses (dz : distances m z) (s0 : s 0%N = 0) (sS : forall i, s i.+1 = s i + z i * q i).
Hypotheses (k0 : forall i, (i <= m)%N -> 0 <= k i) (Hp : forall i, (i <= m)%N -> 0 < (H z k i).[F]).

Definition energy j : R := \sum_(i < j.+1) k i * q i ^+ 2 - F * \sum_(i < j) bead z i * s i.+1 ^+ 2.

(* Springs in series: what is left of the energy when the deflection s_j is given. *)
Definition least j : R := k j * (G z k j).[F] / (H z k j).[F] * s j.+1 ^+ 2.

Lemma energyS j : energy j.+1 = energy j + k j.+1 * q j.+1 ^+ 2 - F * bead z j * s j.+1 ^+ 2.
Proof. by rewrite /energy big_ord_recr [\sum_(i < j.+1) bead _ _ * _]big_ord_recr /=; ring. Qed.

Lemma energy_least j : (j <= m)%N -> least j <= energy j.
Proof.
elim: j => [|j IH] j_m.
  rewrite /energy /least big_ord0 mulr0 subr0 big_ord1 /= !hornerC sS s0 add0r mulr1.
  have z0 : 0 < z 0%N by have [->] := dz.
  by rewrite [X in X <= _](_ : _ = k 0%N * q 0%N ^+ 2) //; field; rewrite gt_eqF.
have zj : 0 < z j.+1 by have [->] := dz.
have hj := Hp (ltnW j_m); have hj1 := Hp j_m; have HE := H_at z k j F.
rewrite energyS; apply: le_trans (_ : least j + k j.+1 * q j.+1 ^+ 2 - F * bead z j * s j.+1 ^+ 2 <= _); last first.
  by rewrite ler_add2r ler_add2r IH // ltnW.
rewrite /least [s j.+2]sS -subr_ge0.
set h := (H z k j).[F] in hj HE *; set h1 := (H z k j.+1).[F] in hj1 HE *.
set g1 := (G z k j.+1).[F] in HE *; set a := s j.+1; set b := q j.+1.
have gE : k j * (G z k j).[F] = g1 + F * bead z j * h by rewrite /g1 G_at /h; ring.
rewrite gE [X in 0 <= X](_ : _ = (g1 * a - k j.+1 / z j.+1 * h * b) ^+ 2 * (z j.+1 ^+ 2 / (h * h1))).
  by rewrite mulr_ge0 ?sqr_ge0 // divr_ge0 ?sqr_ge0 ?mulr_ge0 // ltW.
have -> : h1 = k j.+1 * h + z j.+1 ^+ 2 * g1 by [].
have : k j.+1 * h + z j.+1 ^+ 2 * g1 != 0 by rewrite -HE gt_eqF.
move: (k j.+1) (z j.+1) zj hj => kk zz zj hj nz; field.
by rewrite nz !gt_eqF.
Qed.

End Along.
