(* A force is critical exactly where D vanishes; the modes along the string. *)
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp Require Import ring.
Require Import chain determinant string recursion forces definite.

Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Import Order.TTheory GRing.Theory Num.Theory.
Local Open Scope ring_scope.

Section Critical.

Variables (R : realFieldType) (n : nat) (L k : nat -> R).
Hypotheses (n0 : (0 < n)%N) (pos : forall i, (i < n)%N -> 0 < L i).

Lemma distance_pos i : (i < n)%N -> 0 < distance n L i.
Proof.
move=> i_n; rewrite /distance big_ltn // ltr_paddr ?pos // big_nat.
by apply: sumr_ge0 => j /andP [_ ?]; rewrite ltW // pos.
Qed.

Lemma S0_neq0 : S0 n L != 0.
Proof.
apply/eqP => /matrixP /(_ (Ordinal n0) 0); rewrite !mxE /= => h.
by have := distance_pos n0; rewrite h ltxx.
Qed.

Lemma kernel_vector m (X : 'M[R]_m) : \det X = 0 <-> exists2 v : 'cV_m, v != 0 & X *m v = 0.
Proof.
split=> [d0|[v v0 Xv]].
  have : X^T \notin unitmx by rewrite unitmxE det_tr d0 unitr0.
  rewrite -row_free_unit -kermx_eq0 => /rowV0Pn [u /sub_kermxP uX u0].
  exists u^T; first by apply: contra u0 => /eqP h; rewrite -[u]trmxK h trmx0.
  by rewrite -[LHS]trmxK trmx_mul trmxK uX trmx0.
apply/eqP; rewrite -[_ == 0]negbK -unitfE -unitmxE; apply/negP => u.
by move: v0; rewrite -[v](mulKmx u) Xv mulmx0 eqxx.
Qed.

(* (29) and (30) are the rows of (33). *)
Lemma pencil_col F (q : 'cV[R]_n) (Fy : 'cV[R]_1) :
  pencil n L k F *m col_mx q Fy = col_mx (Kq n k *m q + F *: (S1 n L *m q) + Fy 0 0 *: S0 n L) ((S0 n L)^T *m q).
Proof.
rewrite /pencil /A /B mulmxDl -scalemxAl !mul_block_col !mul0mx !addr0 scale_col_mx scaler0 add_col_mx add0r.
congr (col_mx _ _); rewrite addrCA addrA; congr (_ + _ + _).
by rewrite {1}[Fy]mx11_scalar mul_mx_scalar.
Qed.

Theorem critical_det F : critical n L k F <-> \det (pencil n L k F) = 0.
Proof.
rewrite kernel_vector; split=> [[q [Fy [q0 e1 e2]]]|[v v0]].
  exists (col_mx q Fy%:M); last by rewrite pencil_col [_%:M _ _]mxE eqxx mulr1n e1 e2 col_mx0.
  by apply: contra q0 => /eqP /(congr1 usubmx); rewrite col_mxKu linear0 => ->.
rewrite -[v]vsubmxK pencil_col -[X in _ = X](@col_mx0 _ n 1 1) => /eq_col_mx [e1 e2].
exists (usubmx v), (dsubmx v 0 0); split=> //.
apply: contra v0 => /eqP q0; move: e1; rewrite q0 !mulmx0 scaler0 !add0r => /eqP.
rewrite scaler_eq0 (negPf S0_neq0) orbF => /eqP f0.
by rewrite -[v]vsubmxK q0 [dsubmx v]mx11_scalar f0 raddf0 col_mx0.
Qed.

Theorem critical_root F : critical n L k F <-> root (D n L k) F.
Proof. by rewrite critical_det /root horner_D; split=> /eqP. Qed.

End Critical.

(* Row by row: the moments k_i q_i = z_i g_i fall by F m_i s_i from joint to joint. *)
Section Row.

Variables (R : realFieldType) (n : nat) (L k : nat -> R).
Hypotheses (pos : forall i, (i < n)%N -> 0 < L i).
Variables (F : R) (q s g : nat -> R).
Let z := distance n L.

(* s_i = z_1 q_1 + ... + z_i q_i with s_i in place i + 1 *)
Hypotheses (s0 : s 0%N = 0) (sS : forall i, (i < n)%N -> s i.+1 = s i + z i * q i).
Hypotheses (gz : forall i, (i < n)%N -> k i * q i = z i * g i).
Hypotheses (gS : forall i, (i.+1 < n)%N -> g i.+1 = g i - F * bead z i * s i.+1).
Hypotheses (sn : s n = 0).

Let v : 'cV[R]_n := \col_i q i.

Lemma sum_s j : (j <= n)%N -> \sum_(0 <= i < j) z i * q i = s j.
Proof.
elim: j => [|j IH] j_n; first by rewrite big_geq.
by rewrite big_nat_recr //= IH ?sS // ltnW.
Qed.

Lemma sum_tail j : (j <= n)%N -> \sum_(j <= i < n) z i * q i = - s j.
Proof.
move=> j_n; have := sum_s (leqnn n); rewrite sn (@big_cat_nat _ _ _ j) //= sum_s //.
by move/eqP; rewrite addrC addr_eq0 => /eqP.
Qed.

Lemma row_S1 i : (i < n)%N -> \sum_(0 <= j < n) z (maxn i j) * q j = z i * (\sum_(0 <= j < i.+1) q j) - s i.+1.
Proof.
move=> i_n; rewrite (@big_cat_nat _ _ _ i.+1) //=; congr (_ + _).
  rewrite mulr_sumr; apply: eq_big_nat => j /andP [_ j_i].
  by rewrite (maxn_idPl _).
rewrite -sum_tail //; apply: eq_big_nat => j /andP [i_j _].
by rewrite (maxn_idPr _) // ltnW.
Qed.

(* k_i q_i - F (M q)_i = z_i g_1 *)
Lemma row_balance i : (i < n)%N -> z i * g i - F * (z i * (\sum_(0 <= j < i.+1) q j) - s i.+1) = z i * g 0%N.
Proof.
have zp j : (j < n)%N -> z j != 0 by move=> j_n; rewrite gt_eqF // /z distance_pos.
elim: i => [|i IH] i_n.
  by rewrite big_nat1 sS // s0 add0r subrr mulr0 subr0.
have {IH} := IH (ltnW i_n); rewrite (@big_nat_recr _ _ _ i.+1) //= gS // [s i.+2]sS // /bead.
set t := \sum_(_ <= _ < _) _ => h.
have -> : g 0%N = (z i * g i - F * (z i * t - s i.+1)) / z i by rewrite h mulrAC divff ?mul1r // zp // ltnW.
by field; rewrite !zp // ltnW.
Qed.

Theorem string_mode : (exists2 i, (i < n)%N & q i != 0) -> mode L k F v (- g 0%N).
Proof.
move=> [i0 i0_n qi0]; split.
- by apply: contra qi0 => /eqP/colP/(_ (Ordinal i0_n)); rewrite !mxE => ->.
- apply/colP=> i; rewrite !mxE (bigD1 i) //= big1 ?addr0 => [|j /negPf j_i]; last first.
    by rewrite !mxE eq_sym j_i mulr0n mul0r.
  rewrite !mxE eqxx mulr1n gz //.
  rewrite (eq_bigr (fun j : 'I_n => - (z (maxn i j) * q j))); last by move=> j _; rewrite !mxE mulNr.
  have := row_S1 (ltn_ord i); rewrite big_mkord sumrN => ->.
  by rewrite mulrN (row_balance (ltn_ord i)) mulNr mulrC addrN.
apply/colP=> i; rewrite !mxE ord1; have := sum_s (leqnn n); rewrite sn big_mkord => h.
by rewrite -[RHS]h; apply: eq_bigr => j _; rewrite !mxE.
Qed.

End Row.
