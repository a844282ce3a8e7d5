(* The matrices themselves: M = -S1 is positive definite, det A = 0 and rank A = n, det B in closed form and when it
   vanishes; energies as forms; the energy factor (39). Theorems "Notation" (N), "Two zeros" (rank), "Closed form"
   (det B), "Energy factor" of theorems.md. *)
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp Require Import ring.
Require Import chain determinant recursion forces.

Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Import Order.TTheory GRing.Theory Num.Theory.
Local Open Scope ring_scope.

Section Factor.

Variables (R : fieldType) (n : nat) (L k : nat -> R).
Implicit Types q : 'cV[R]_n.

(* theta = T q *)
Definition T : 'M[R]_n := \matrix_(l, i) (i <= l)%N%:R.

Lemma distance_ord i : distance n L i = \sum_(l < n) L l *+ (i <= l)%N.
Proof. by rewrite /distance big_geq_mkord big_mkcond; apply: eq_bigr => l _; case: (i <= l)%N. Qed.

Lemma M_factor : M n L = T^T *m diag_mx (\row_l L l) *m T.
Proof.
apply/matrixP=> i j; rewrite !mxE opprK distance_ord; apply: eq_bigr => l _.
rewrite mul_mx_diag !mxE geq_max.
by case: (i <= l)%N; case: (j <= l)%N; rewrite ?mulr1n ?mulr0n ?mulr1 ?mul1r ?mulr0 ?mul0r.
Qed.

Lemma T_theta q l : (T *m q) l 0 = theta q l.
Proof.
rewrite /theta mxE [RHS]big_mkcond; apply: eq_bigr => i _; rewrite mxE.
by case: (i <= l)%N; rewrite ?mul1r ?mul0r.
Qed.

(* (N) of theorems.md *)
Theorem moment_form q : (q^T *m M n L *m q) 0 0 = shortening L q.
Proof.
rewrite M_factor !mulmxA -trmx_mul -mulmxA mxE; apply: eq_bigr => l _.
by rewrite T_theta mul_mx_diag [X in X * _]mxE [X in X * _ * _]mxE [X in _ * X * _]mxE T_theta; ring.
Qed.

Theorem stiffness_form q : (q^T *m Kq n k *m q) 0 0 = strain k q.
Proof.
rewrite mxE; apply: eq_bigr => i _; rewrite mxE (bigD1 i) //= big1 ?addr0 => [|j /negPf j_i].
  by rewrite !mxE eqxx mulr1n; ring.
by rewrite !mxE j_i mulr0n mulr0.
Qed.

Lemma det_T : \det T = 1.
Proof.
rewrite det_trig; first by rewrite big1 // => i _; rewrite mxE leqnn.
by apply/is_trig_mxP=> i j i_j; rewrite mxE leqNgt i_j.
Qed.

Lemma T_unit : T \in unitmx. Proof. by rewrite unitmxE det_T unitr1. Qed.

Theorem det_M : \det (M n L) = \prod_(i < n) L i.
Proof.
by rewrite M_factor !det_mulmx det_tr det_T det_diag mul1r mulr1; apply: eq_bigr => i _; rewrite mxE.
Qed.

Theorem det_A : \det (A n L) = 0.
Proof. by rewrite /A det_ublock det_mx11 mxE mulr0. Qed.

Lemma S1_sym : (S1 n L)^T = S1 n L.
Proof. by apply/matrixP=> i j; rewrite !mxE maxnC. Qed.

Lemma Kq_sym : (Kq n k)^T = Kq n k.
Proof. by apply/matrixP=> i j; rewrite !mxE eq_sym; case: eqP => // ->. Qed.

Lemma A_sym : (A n L)^T = A n L.
Proof. by rewrite tr_block_mx S1_sym !trmx0. Qed.

Lemma B_sym : (B n L k)^T = B n L k.
Proof. by rewrite tr_block_mx Kq_sym trmxK trmx0. Qed.

(* A rank needs no more than lengths that are not zero. *)
Lemma S1_unit : (forall i, (i < n)%N -> L i != 0) -> S1 n L \in unitmx.
Proof.
move=> nz; rewrite -[S1 n L]opprK -/(M n L) -scaleN1r unitmxZ ?unitrN1 // unitmxE det_M unitfE.
by apply/prodf_neq0 => i _; apply: nz.
Qed.

Theorem rank_A : (forall i, (i < n)%N -> L i != 0) -> \rank (A n L) = n.
Proof. by move=> nz; rewrite /A rank_diag_block_mx mxrank0 addn0 mxrank_unit // S1_unit. Qed.

(* det B = -(z_1^2 k_2 ... k_n + ... + k_1 ... k_(n-1) z_n^2) *)
Lemma recursion_at_0 z j : (H z k j).[0] = \sum_(i < j.+1) z i ^+ 2 * \prod_(l < j.+1 | l != i) k l.
Proof.
elim: j => [|j IH].
  by rewrite hornerC big_ord1 big1 ?mulr1 // => l; rewrite !ord1 eqxx.
rewrite H_at; have -> : (G z k j.+1).[0] = \prod_(l < j.+1) k l.
  elim: (j.+1) => [|i IHi]; first by rewrite big_ord0 hornerC.
  by rewrite big_ord_recr /= G_at IHi !mul0r subr0 mulrC.
rewrite [RHS]big_ord_recr /= IH mulr_sumr; congr (_ + _ * _).
  apply: eq_bigr => i _; rewrite [in RHS]big_mkcond big_ord_recr /= -big_mkcond /=.
  have -> : (ord_max != widen_ord (leqnSn j.+1) i) = true by rewrite -val_eqE /= gtn_eqF.
  by rewrite mulrCA; congr (_ * _); rewrite mulrC; congr (_ * _); apply: eq_bigl => l; rewrite -!val_eqE.
rewrite [RHS]big_mkcond [RHS]big_ord_recr /= eqxx mulr1.
by apply: eq_bigr => l _; rewrite -val_eqE /= ltn_eqF.
Qed.

Theorem det_B : (forall i, (i < n)%N -> distance n L i != 0) ->
  \det (B n L k) = - \sum_(i < n) distance n L i ^+ 2 * \prod_(l < n | l != i) k l.
Proof.
move=> nz; have -> : B n L k = pencil n L k 0 by rewrite /pencil scale0r add0r.
rewrite pencil_bordered; case: n nz => [|m] nz.
  by rewrite big_ord0 oppr0 (_ : bordered _ _ _ _ _ = 0) ?det0 //; apply/matrixP=> i j; rewrite !ord1 !mxE.
by rewrite recursion_det // -hornerH recursion_at_0.
Qed.

End Factor.

Section Definite.

Variables (R : realFieldType) (n : nat) (L k : nat -> R).
Implicit Types q : 'cV[R]_n.

Lemma shortening_ge0 q : (forall i, (i < n)%N -> 0 < L i) -> 0 <= shortening L q.
Proof. by move=> pos; apply: sumr_ge0 => j _; rewrite mulr_ge0 ?sqr_ge0 // ltW // pos. Qed.

Theorem M_definite q : (forall i, (i < n)%N -> 0 < L i) -> q != 0 -> 0 < (q^T *m M n L *m q) 0 0.
Proof.
move=> pos; rewrite moment_form lt0r shortening_ge0 // andbT; apply: contra => /eqP h.
have zero (l : 'I_n) : theta q l = 0.
  have /psumr_eq0P/(_ l isT)/eqP := h.
    by rewrite mulf_eq0 gt_eqF ?pos //= sqrf_eq0 => h'; apply/eqP/h' => i _; rewrite mulr_ge0 ?sqr_ge0 // ltW // pos.
have : T R n *m q = 0 by apply/colP => l; rewrite T_theta zero mxE.
by move/(canRL (mulKmx (T_unit R n))); rewrite mulmx0 => ->.
Qed.

Theorem det_B_zero : (forall i, (i < n)%N -> 0 < L i) -> (forall i, (i < n)%N -> 0 <= k i) -> (0 < n)%N ->
  at_most_one_passive n k <-> \det (B n L k) != 0.
Proof.
move=> pos k0 n0.
have zp i : (i < n)%N -> 0 < distance n L i.
  move=> i_n; rewrite /distance big_ltn // ltr_paddr ?pos // big_nat.
  by apply: sumr_ge0 => j /andP [_ ?]; rewrite ltW // pos.
rewrite det_B => [|i i_n]; last by rewrite gt_eqF // zp.
rewrite oppr_eq0.
have ge i : 0 <= distance n L (i : 'I_n) ^+ 2 * \prod_(l < n | l != i) k l.
  by rewrite mulr_ge0 ?sqr_ge0 // prodr_ge0 // => l _; apply: k0.
split=> [one|].
  apply/eqP => /psumr_eq0P h; have {}h i : \prod_(l < n | l != i) k l = 0.
    have /eqP := h (fun j _ => ge j) i isT; rewrite mulf_eq0 sqrf_eq0 gt_eqF ?zp //=.
    by move/eqP.
  have /eqP/prodf_eq0 [i _ /eqP ki] := h (Ordinal n0).
  have /eqP/prodf_eq0 [j j_i /eqP kj] := h i.
  by move: j_i; rewrite (val_inj (one _ _ (ltn_ord j) (ltn_ord i) kj ki)) eqxx.
move=> nz i j i_n j_n ki kj; apply/eqP; apply: contraNT nz => i_j.
rewrite big1 // => l _; apply/eqP; rewrite mulf_eq0; apply/orP; right; apply/prodf_eq0.
case: (altP (val l =P i)) => [l_i|l_i].
  by exists (Ordinal j_n); rewrite ?kj // -val_eqE /= l_i eq_sym.
by exists (Ordinal i_n); rewrite ?ki // -val_eqE /= eq_sym.
Qed.

(* (39): the energy factor of a mode is its force. *)
Theorem energy_factor F q Fy : (forall i, (i < n)%N -> 0 < L i) -> mode L k F q Fy ->
  F = strain k q / shortening L q.
Proof.
move=> pos [q0 eq1 eq2]; have dq := M_definite pos q0; rewrite moment_form in dq.
have : (q^T *m (Kq n k *m q + F *: (S1 n L *m q) + Fy *: S0 n L)) 0 0 = 0 by rewrite eq1 mulmx0 mxE.
rewrite !mulmxDr -!scalemxAr [q^T *m S0 n L](_ : _ = 0) ?scaler0 ?addr0; last first.
  by rewrite -[q^T *m _]trmxK trmx_mul trmxK eq2 trmx0.
rewrite mxE [X in _ + X]mxE !mulmxA stiffness_form -[S1 n L]opprK -/(M n L) mulmxN mulNmx.
rewrite [X in F * X]mxE moment_form mulrN => /eqP; rewrite subr_eq0 => /eqP ->.
by rewrite mulfK // gt_eqF.
Qed.

End Definite.
