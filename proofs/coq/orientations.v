(* Modes by the orientations of the links: the moments at the joints, and their differences from link to link. What a
   passive base makes of them: theorem "Passive base" of theorems.md. *)
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp Require Import ring.
Require Import chain determinant string recursion forces definite.

Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Import GRing.Theory.
Local Open Scope ring_scope.

Section Orientations.

Variables (R : fieldType) (n : nat) (L k : nat -> R).
Implicit Types (t : nat -> R) (F Fy : R) (q : 'cV[R]_n).

(* The angle of joint i, where the links have the orientations t. *)
Definition turn_of t i : R := t i - (if i is i'.+1 then t i' else 0).
Definition shape t : 'cV[R]_n := \col_i turn_of t i.

Lemma theta_shape t j : (j < n)%N -> theta (shape t) j = t j.
Proof.
move=> j_n; rewrite /theta; have -> : \sum_(i < n | (i <= j)%N) shape t i 0 = \sum_(0 <= i < j.+1) turn_of t i.
  by rewrite (big_nat_widen _ _ n) // big_mkord; apply: eq_big => [i|i _]; rewrite ?mxE // ltnS.
elim: j {j_n} => [|j IH]; first by rewrite big_nat1 /turn_of subr0.
by rewrite big_nat_recr //= IH /turn_of addrC subrK.
Qed.

Lemma shape_theta q : q = shape (theta q).
Proof.
apply/colP => i; rewrite mxE /turn_of /theta; case: i => -[|i] h /=.
  rewrite (bigD1 (Ordinal h)) //= big1 ?addr0 ?subr0 // => j /andP [j0].
  by rewrite -val_eqE /=; case: (val j) j0.
rewrite (bigD1 (Ordinal h)) //= [X in _ + X - _](eq_bigl (fun j : 'I_n => (j <= i)%N)) ?addrK // => j.
by rewrite -val_eqE /= leq_eqVlt ltnS; case: eqP => [->|_] /=; rewrite ?ltnn ?andbT.
Qed.

Lemma eq_shape t t' : (forall i, (i < n)%N -> t i = t' i) -> shape t = shape t'.
Proof.
by move=> e; apply/colP => -[[|i] h]; rewrite !mxE /turn_of /= ?e // ltnW.
Qed.

Lemma shape_eq0 t : (shape t == 0) = [forall i : 'I_n, t i == 0].
Proof.
apply/eqP/forallP => [e i|e].
  by rewrite -theta_shape // e /theta big1 // => j _; rewrite mxE.
rewrite (@eq_shape _ (fun=> 0)); last by move=> i h; apply/eqP/(e (Ordinal h)).
by apply/colP => -[[|i] h]; rewrite !mxE /turn_of /= subr0.
Qed.

(* What acts on joint i. *)
Definition moment F Fy t i : R := k i * turn_of t i - F * (\sum_(i <= l < n) L l * t l) + Fy * distance n L i.

Lemma mode_moments F t Fy : mode L k F (shape t) Fy <->
  [/\ shape t != 0, forall i, (i < n)%N -> moment F Fy t i = 0 & \sum_(0 <= l < n) L l * t l = 0].
Proof.
have tail i : (i <= n)%N -> \sum_(i <= l < n) L l * t l = \sum_(l < n) (i <= l)%N%:R * (L l * t l).
  move=> i_n; rewrite big_geq_mkord [LHS]big_mkcond; apply: eq_bigr => l _.
  by case: (i <= l)%N; rewrite ?mul1r ?mul0r.
have Mq i : (M n L *m shape t) i 0 = \sum_(i <= l < n) L l * t l.
  rewrite tail ?(ltnW (ltn_ord i)) // M_factor -!mulmxA mxE; apply: eq_bigr => l _.
  by rewrite mul_diag_mx [X in X * _]mxE [X in X * _]mxE [X in _ * X]mxE [X in _ * (X * _)]mxE T_theta theta_shape.
have row i : (Kq n k *m shape t + F *: (S1 n L *m shape t) + Fy *: S0 n L) i 0 = moment F Fy t i.
  rewrite -[S1 n L]opprK -/(M n L) mulNmx scalerN [LHS]mxE [X in X + _]mxE [X in _ + X]mxE [X in _ + X + _]mxE [X in _ - X + _]mxE.
  rewrite Mq [S0 _ _ _ _]mxE /moment; congr (_ - F * _ + _); rewrite mxE.
  by rewrite (bigD1 i) //= big1 ?addr0 => [|j /negPf j_i]; rewrite !mxE ?eqxx ?mulr1n // eq_sym j_i mulr0n mul0r.
have axis : ((S0 n L)^T *m shape t) 0 0 = \sum_(0 <= l < n) L l * t l.
  case: n shape Mq tail => [|p] sh Mq' tail'; first by rewrite mxE big_ord0 big_geq.
  by rewrite -(Mq' ord0) !mxE; apply: eq_bigr => j _; rewrite !mxE opprK max0n.
split=> -[q0 e1 e2]; split=> //.
- by move=> i i_n; rewrite -(row (Ordinal i_n)) e1 mxE.
- by rewrite -axis e2 mxE.
- by apply/colP => i; rewrite row e1 ?mxE.
by apply/matrixP => a b; rewrite !ord1 axis e2 mxE.
Qed.

(* What acts on link j alone. *)
Definition balance F Fy t j : R :=
  k j * turn_of t j - (if (j.+1 < n)%N then k j.+1 * turn_of t j.+1 else 0) - F * (L j * t j) + Fy * L j.

Lemma balanceE F Fy t j : (j < n)%N ->
  balance F Fy t j = moment F Fy t j - (if (j.+1 < n)%N then moment F Fy t j.+1 else 0).
Proof.
move=> j_n; rewrite /balance /moment /distance (big_ltn j_n) [\sum_(j <= l < n) L l](big_ltn j_n).
case: ifP => [h|/negbT]; first by move: (\sum_(_ <= _ < _) _) (\sum_(_ <= _ < _) _) => a b; ring.
by rewrite -leqNgt => h; rewrite !big_geq //; ring.
Qed.

Lemma moments_balances F Fy t :
  (forall i, (i < n)%N -> moment F Fy t i = 0) <-> (forall j, (j < n)%N -> balance F Fy t j = 0).
Proof.
split=> e i i_n; first by rewrite balanceE // e //; case: ifP => [h|_]; rewrite ?e // subr0.
suff h m : (m <= n)%N -> forall j, (n - m <= j < n)%N -> moment F Fy t j = 0 by apply: (h n (leqnn n)); rewrite subnn.
elim: m => [|m IH] m_n j; first by rewrite subn0 => /andP [/leq_ltn_trans h /h]; rewrite ltnn.
case/andP => h j_n; case: (ltnP j (n - m)) => [j_m|m_j]; last by apply: IH; rewrite ?m_j // ltnW.
have := e j j_n; rewrite balanceE //; case: ifP => [j1|_]; last by rewrite subr0.
by rewrite [moment _ _ _ j.+1]IH ?subr0 ?(ltnW m_n) // j1 andbT leq_subLR addnS -addSn -leq_subLR.
Qed.

(* On a passive base no lateral force acts, and the links are masses in a row, free at both ends. *)
Theorem free_row F Fy t : (forall i, (i < n)%N -> distance n L i != 0) -> k 0%N = 0 -> F != 0 -> (0 < n)%N ->
  mode L k F (shape t) Fy <-> [/\ shape t != 0, Fy = 0 & forall j, (j < n)%N -> balance F 0 t j = 0].
Proof.
move=> z0 k0 F0 n0; have axis G : moment F G t 0 = - F * (\sum_(0 <= l < n) L l * t l) + G * distance n L 0.
  by rewrite /moment k0 mul0r sub0r mulNr.
rewrite mode_moments; split=> [[q0 e1 e2]|[q0 -> /moments_balances e1]].
  have Fy0 : Fy = 0.
    have /eqP := e1 0%N n0; rewrite axis e2 mulr0 add0r mulf_eq0 (negPf (z0 _ n0)) orbF.
    by move/eqP.
  by rewrite Fy0 in e1; split=> //; apply/moments_balances.
split=> //; have /eqP := e1 0%N n0; rewrite axis mul0r addr0 mulf_eq0 oppr_eq0 (negPf F0) /=.
by move/eqP.
Qed.

End Orientations.
