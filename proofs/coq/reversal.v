(* A chain on a passive base read from its end point: theorem "Reversal" of theorems.md. *)
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp Require Import polyrcf.
From mathcomp Require Import zify ring.
Require Import chain determinant string recursion forces definite modes orientations.

Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Import Order.TTheory GRing.Theory Num.Theory.
Local Open Scope ring_scope.

Section Reversed.

Variables (R : realFieldType) (n : nat).
Implicit Types (L k t : nat -> R) (q : 'cV[R]_n).

Definition reversed (f : nat -> R) j : R := f (n.-1 - j)%N.
Definition reversed_stiffness k i : R := if i is 0 then 0 else k (n - i)%N.

Lemma reversedK f j : (j < n)%N -> reversed (reversed f) j = f j.
Proof. by move=> j_n; rewrite /reversed subKn // -ltnS prednK // (leq_ltn_trans _ j_n). Qed.

Lemma reversed_sum (f : nat -> R) i : (i <= n)%N -> \sum_(i <= l < n) reversed f l = \sum_(0 <= l < n - i) f l.
Proof.
move=> i_n; rewrite -{1}[i]add0n big_addn [RHS]big_nat_rev; apply: eq_big_nat => l /andP [_ l_n].
by rewrite /reversed; congr f; lia.
Qed.

(* The orientations in reverse order. *)
Definition backwards q : 'cV[R]_n := shape n (reversed (theta q)).

Lemma backwardsK q : backwards (backwards q) = q.
Proof.
rewrite [RHS]shape_theta; apply: eq_shape => i i_n; rewrite -[RHS](reversedK _ i_n) /backwards.
by rewrite {1}/reversed theta_shape //; lia.
Qed.

Lemma backwards_neq0 q : q != 0 -> backwards q != 0.
Proof.
apply: contra => /eqP e; rewrite -[q]backwardsK e /backwards shape_eq0; apply/forallP => i.
by rewrite /reversed /theta big1 // => j _; rewrite mxE.
Qed.

Variables (L k : nat -> R).
Hypotheses (pos : forall i, (i < n)%N -> 0 < L i) (base : k 0%N = 0).

Theorem mode_backwards F q Fy : mode L k F q Fy ->
  Fy = 0 /\ mode (reversed L) (reversed_stiffness k) F (backwards q) 0.
Proof.
rewrite {1}[q]shape_theta => /mode_moments []; rewrite -shape_theta => q0 e axis.
have n0 : (0 < n)%N by case: n q q0 {e axis} => // q; rewrite flatmx0 eqxx.
have z0 : distance n L 0 != 0 by rewrite gt_eqF // distance_pos.
have Fy0 : Fy = 0.
  have /eqP := e 0%N n0; rewrite /moment base axis mul0r mulr0 subr0 add0r mulf_eq0 (negPf z0) orbF.
  by move/eqP.
split=> //; apply/mode_moments; split; first exact: backwards_neq0.
  case=> [|i] i_n; rewrite /moment [0 * distance _ _ _]mul0r addr0.
    by rewrite mul0r sub0r (@reversed_sum (fun l => L l * theta q l)) // subn0 axis mulr0 oppr0.
  rewrite (@reversed_sum (fun l => L l * theta q l)) 1?ltnW //; set j := (n - i.+1)%N.
  have [j0 j_n] : (0 < j)%N /\ (j < n)%N by rewrite /j; lia.
  have -> : turn_of (reversed (theta q)) i.+1 = - turn_of (theta q) j.
    rewrite /turn_of /reversed opprB /=; have -> : (n.-1 - i)%N = j by rewrite /j; lia.
    by have -> : j = (n.-1 - i.+1).+1 by rewrite /j; lia.
  have := e j j_n; rewrite /moment Fy0 mul0r addr0 mulrN => /eqP; rewrite subr_eq0 => /eqP ->.
  have := axis; rewrite (@big_cat_nat _ _ _ j) //= 1?ltnW // => /eqP; rewrite addrC addr_eq0 => /eqP ->.
  by rewrite mulrN opprK addrN.
by rewrite (@reversed_sum (fun l => L l * theta q l)) // subn0.
Qed.

(* Bent chains with the rest angles a, turned by half a turn, so that the orientations stay: the energy, and whatever the
   links add up to one by one, as the place of the end point. *)
Definition rest_backwards (a : nat -> R) i : R := if i is 0 then 0 else - a (n - i)%N.
Definition bent_energy k a t : R := \sum_(0 <= i < n) k i * (turn_of t i - a i) ^+ 2.

Theorem energy_backwards a t :
  bent_energy (reversed_stiffness k) (rest_backwards a) (reversed t) = bent_energy k a t.
Proof.
rewrite /bent_energy; case: (posnP n) => [->|n0]; first by rewrite !big_geq.
rewrite !(big_ltn n0) /= base !mul0r !add0r [RHS]big_nat_rev; apply: eq_big_nat => -[|i] // /andP [_ i_n].
have -> : (1 + n - i.+2)%N = (n - i.+1)%N by lia.
rewrite /= -[in RHS]sqrrN; congr (_ * _ ^+ 2); rewrite /turn_of /reversed !opprB.
have -> : (n.-1 - i)%N = (n - i.+1)%N by lia.
have -> : (n - i.+1)%N = (n.-1 - i.+1).+1 by lia.
by rewrite opprK addrC.
Qed.

Theorem place_backwards (u : R -> R) t :
  \sum_(0 <= j < n) reversed L j * u (reversed t j) = \sum_(0 <= j < n) L j * u (t j).
Proof. by rewrite (@reversed_sum (fun l => L l * u (t l))) // subn0. Qed.

End Reversed.

(* Only the values below n matter. *)
Lemma eq_mode (R : fieldType) n (L L' k k' : nat -> R) F (q : 'cV[R]_n) Fy : (forall i, (i < n)%N -> L i = L' i) ->
  (forall i, (i < n)%N -> k i = k' i) -> mode L k F q Fy -> mode L' k' F q Fy.
Proof.
move=> eL ek; have dE i : distance n L i = distance n L' i by apply: eq_big_nat => j /andP [_ /eL].
have -> : mode L' k' F q Fy = mode L k F q Fy; last by [].
rewrite /mode; have -> : S0 n L' = S0 n L by apply/colP => i; rewrite !mxE dE.
have -> : S1 n L' = S1 n L by apply/matrixP => i j; rewrite !mxE dE.
by have -> : Kq n k' = Kq n k by apply/matrixP => i j; rewrite !mxE ek.
Qed.

Section Forces.

Variables (R : rcfType) (n : nat) (L k : nat -> R).
Hypotheses (two : (1 < n)%N) (links : chain_of_links n L k) (one : at_most_one_passive n k) (base : k 0%N = 0).

Lemma reversed_links : chain_of_links n (reversed n L) (reversed_stiffness n k).
Proof.
have [pos k0] := links; split=> [i i_n|[|i] i_n //=]; first by apply: pos; lia.
by apply: k0; lia.
Qed.

Lemma elastic i : (0 < i)%N -> (i < n)%N -> k i != 0.
Proof. by move=> i0 i_n; apply/eqP => ki; have := one i_n (ltnW two) ki base; lia. Qed.

Lemma reversed_one : at_most_one_passive n (reversed_stiffness n k).
Proof.
by move=> [|i] [|j] i_n j_n //= ki kj; try (by have := elastic (i := n - i.+1); rewrite ki eqxx; lia);
  have := elastic (i := n - j.+1); rewrite kj eqxx; lia.
Qed.

(* The critical forces are the same. *)
Theorem forces_backwards fs : roots_of (D n L k) fs <-> roots_of (D n (reversed n L) (reversed_stiffness n k)) fs.
Proof.
have pos i : (i < n)%N -> 0 < L i by have [+ _] := links; apply.
have [pos' _] := reversed_links; have n0 := ltnW two.
have same F : critical n L k F <-> critical n (reversed n L) (reversed_stiffness n k) F.
  split=> -[q [Fy m]]; first by have [_ m'] := mode_backwards pos base m; exists (backwards q), 0.
  have [_ m'] := mode_backwards pos' (erefl _) m; exists (backwards q), 0.
  apply: eq_mode m' => [i i_n|[|i] i_n]; rewrite ?reversedK //= ?base //; case e: (n - i.+1)%N => [|l] /=; [lia|].
  by congr k; lia.
have [gs [rgs _ _ _]] := critical_forces two links one.
have [hs [rhs _ _ _]] := critical_forces two reversed_links reversed_one.
have ug : uniq gs by apply: (simple_forces two links one _ rgs) => i i0 i_n; apply: elastic => //; apply: ltnW.
suff gh : gs = hs.
  by split=> [/(roots_of_inj rgs) <-|/(roots_of_inj rhs) <-]; rewrite ?gh // -gh.
have uh : uniq hs.
  apply: (simple_forces two reversed_links reversed_one _ rhs) => -[|i] //= _ i_n; apply: elastic; lia.
have [sg _] := rgs; have [sh _] := rhs; apply: (le_sorted_eq sg sh); apply: uniq_perm => // F.
rewrite -(roots_of_root F rgs) -(roots_of_root F rhs); apply/idP/idP.
  by move/(critical_root k n0 pos)/same/(critical_root _ n0 pos').
by move/(critical_root _ n0 pos')/same/(critical_root k n0 pos).
Qed.

End Forces.
