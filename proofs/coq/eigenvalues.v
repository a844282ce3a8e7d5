(* The eigenvalues of B^-1 A (35): a double zero with a single eigenvector, and the n - 1 negative numbers -1/F_m,
   semisimple. Theorems "Two zeros", "Definiteness", "Closed form" of theorems.md. *)
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp Require Import polyrcf.
From mathcomp Require Import ring.
Require Import chain determinant string recursion forces definite modes.

Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Import Order.TTheory GRing.Theory Num.Theory.
Local Open Scope ring_scope.

Section Ordered.

Variables (R : realFieldType) (n : nat) (L k : nat -> R).
Hypotheses (two : (1 < n)%N) (links : chain_of_links n L k) (one : at_most_one_passive n k).

Definition BinvA : 'M[R]_(n + 1) := invmx (B n L k) *m A n L.

Let pos i : (i < n)%N -> 0 < L i. Proof. by have [+ _] := links; apply. Qed.
Let n0 : (0 < n)%N. Proof. exact: ltnW. Qed.

Lemma B_unit : B n L k \in unitmx.
Proof.
rewrite unitmxE unitfE; have [h _] := @det_B_zero R n L k pos (proj2 links) n0.
exact: h.
Qed.

(* The paper has n - 1. *)
Theorem rank_BinvA : \rank BinvA = n.
Proof.
rewrite -mxrank_tr trmx_mul mxrankMfree; last by rewrite row_free_unit unitmx_tr unitmx_inv B_unit.
by rewrite mxrank_tr rank_A // => i i_n; rewrite gt_eqF // pos.
Qed.

Theorem rank_B : \rank (B n L k) = (n + 1)%N.
Proof. by rewrite mxrank_unit // B_unit. Qed.

Definition e_last : 'cV[R]_(n + 1) := col_mx 0 1.
Definition e_first : 'cV[R]_(n + 1) := col_mx (delta_mx (Ordinal n0) 0) 0.

Theorem jordan_chain : BinvA *m e_last = 0 /\ BinvA *m (- e_first) = e_last.
Proof.
split; first by rewrite /BinvA -mulmxA /A /e_last mul_block_col !mul0mx !mulmx0 !addr0 col_mx0 mulmx0.
suff AB : A n L *m (- e_first) = B n L k *m e_last by rewrite /BinvA -mulmxA AB mulKmx // B_unit.
rewrite mulmxN /A /B /e_first /e_last !mul_block_col !mul0mx !mulmx0 !addr0 !add0r mulmx1 ?mulmx0.
rewrite opp_col_mx oppr0; congr (col_mx _ _); apply/colP=> i; rewrite mxE -colE !mxE opprK.
by rewrite /= maxn0.
Qed.

(* Geometric multiplicity 1. *)
Theorem kernel_of_BinvA v : BinvA *m v = 0 <-> exists c, v = c *: e_last.
Proof.
split=> [h|[c ->]]; last by rewrite -scalemxAr; have [-> _] := jordan_chain; rewrite scaler0.
have : A n L *m v = 0 by rewrite -[A n L *m v](mulKVmx B_unit) [invmx _ *m _]mulmxA -/BinvA h mulmx0.
rewrite -[v]vsubmxK /A mul_block_col !mul0mx !addr0 -[X in _ = X](@col_mx0 _ n 1 1) => /eq_col_mx [S1v _].
have u : S1 n L \in unitmx by apply: S1_unit => i i_n; rewrite gt_eqF // pos.
exists (dsubmx v 0 0); rewrite /e_last scale_col_mx scaler0 scalemx1 -mx11_scalar.
by rewrite -[usubmx v](mulKmx u) S1v mulmx0.
Qed.

(* No Jordan block at any eigenvalue but zero. *)
Theorem semisimple a (v : 'cV[R]_(n + 1)) : a != 0 ->
  (BinvA - a%:M) *m ((BinvA - a%:M) *m v) = 0 -> (BinvA - a%:M) *m v = 0.
Proof.
move=> a0; set w := _ *m v => hw.
have Aw : A n L *m w = a *: (B n L k *m w).
  move: hw; rewrite mulmxBl mul_scalar_mx => /eqP; rewrite subr_eq0 => /eqP hw.
  by rewrite scalemxAr -hw /BinvA -mulmxA mulKVmx // B_unit.
have Av : A n L *m v = a *: (B n L k *m v) + B n L k *m w.
  rewrite /w mulmxBl mul_scalar_mx mulmxBr -scalemxAr /BinvA -mulmxA mulKVmx ?B_unit //.
  by rewrite addrCA subrr addr0.
clearbody w.
have wB : w^T *m (B n L k *m w) = 0.
  have : w^T *m (A n L *m v) = (A n L *m w)^T *m v by rewrite trmx_mul A_sym mulmxA.
  rewrite Av Aw mulmxDr -scalemxAr linearZ /= trmx_mul B_sym -scalemxAl -mulmxA.
  by move/(canRL (addKr _)); rewrite addNr.
have wA : w^T *m (A n L *m w) = 0 by rewrite Aw -scalemxAr wB scaler0.
have q0 : usubmx w = 0.
  apply/eqP/negP => /negP q0; have := M_definite pos q0.
  move: wA; rewrite -{1 2}[w]vsubmxK /A tr_col_mx mul_block_col !mul0mx !addr0 mul_row_col mulmx0 addr0.
  by rewrite /M mulmxN mulNmx -mulmxA [in X in _ -> X]mxE => ->; rewrite mxE oppr0 ltxx.
have : B n L k *m w = 0.
  apply: (scalerI a0); rewrite scaler0 -Aw -[w]vsubmxK q0 /A mul_block_col !mul0mx !mulmx0 !addr0.
  exact: col_mx0.
by move/(canRL (mulKmx B_unit)); rewrite mulmx0.
Qed.

End Ordered.

Section Real.

Variables (R : rcfType) (n : nat) (L k : nat -> R).
Hypotheses (two : (1 < n)%N) (links : chain_of_links n L k) (one : at_most_one_passive n k).

Lemma horner_char_poly m (X : 'M[R]_m) x : (char_poly X).[x] = \det (x%:M - X).
Proof.
rewrite /char_poly /char_poly_mx -scalemx1 -[x%:M]scalemx1 -(map_mx1 [rmorphism of polyC]) -map_mxN.
exact: horner_det.
Qed.

Lemma reciprocal (fs : seq R) x : x != 0 -> all (fun f => f != 0) fs ->
  x ^+ size fs * \prod_(f <- fs) (- x^-1 - f) = (\prod_(f <- fs) (0 - f)) * \prod_(f <- fs) (x + f^-1).
Proof.
move=> x0; elim: fs => [|f fs IH] /=; first by rewrite !big_nil !mulr1.
case/andP => f0 /IH {}IH; rewrite !big_cons exprS.
rewrite mulrACA IH; move: (\prod_(j <- fs) (0 - j)) (\prod_(j <- fs) (x + _)) => P Q.
by field; rewrite x0 f0.
Qed.

Lemma horner_roots (p : {poly R}) c (fs : seq R) x :
  p = c *: \prod_(f <- fs) ('X - f%:P) -> p.[x] = c * \prod_(f <- fs) (x - f).
Proof. by move=> ->; rewrite hornerZ horner_prod; congr (_ * _); apply: eq_bigr => f _; rewrite !hornerE. Qed.

Theorem characteristic_polynomial fs : roots_of (D n L k) fs ->
  char_poly (BinvA n L k) = 'X^2 * \prod_(f <- fs) ('X - (- f^-1)%:P).
Proof.
move=> rfs; have [gs [rgs sz pfs _]] := critical_forces two links one.
rewrite -(roots_of_inj rfs rgs) {gs rgs} in sz pfs.
have [_ [c c0 Dc]] := rfs.
apply: (mulfI (negbT (polyX_eq0 R))); apply: poly_ext => x; rewrite !hornerM hornerX.
case: (altP (x =P 0)) => [->|x0]; first by rewrite !mul0r.
congr (_ * _); rewrite horner_char_poly horner_prod.
rewrite (eq_bigr (fun f => x + f^-1)); last by move=> f _; rewrite !hornerE opprK.
have uB := B_unit two links one.
have -> : x%:M - BinvA n L k = invmx (B n L k) *m (x *: pencil n L k (- x^-1)).
  rewrite /pencil scalerDr scalerA mulrN mulfV // scaleN1r mulmxDr mulmxN -scalemxAr mulVmx //.
  by rewrite scalemx1 addrC.
rewrite det_mulmx detZ det_inv -horner_D (horner_roots _ Dc).
have -> : \det (B n L k) = c * \prod_(f <- fs) (0 - f).
  by rewrite -(horner_roots _ Dc) horner_D /pencil scale0r add0r.
have f0 : all (fun f => f != 0) fs by apply/allP => f /(allP pfs); apply: lt0r_neq0.
have P0 : \prod_(f <- fs) (0 - f) != 0.
  by rewrite prodf_seq_neq0; apply/allP => f /(allP f0) /=; rewrite sub0r oppr_eq0.
have -> : (n + 1 = 2 + size fs)%N by rewrite sz addn1 add2n prednK // ltnW.
have := reciprocal x0 f0; rewrite exprD; move: P0.
move: (x ^+ size fs) (\prod_(f <- fs) (_ - f)) (\prod_(f <- fs) (0 - f)) (\prod_(f <- fs) (x + f^-1)).
move=> X W P Q P0 rec; transitivity ((c * P)^-1 * c * x ^+ 2 * (X * W)); first by field; rewrite c0 P0.
by rewrite rec; field; rewrite c0 P0.
Qed.

(* Algebraic multiplicity exactly 2. *)
Theorem zero_twice fs : roots_of (D n L k) fs ->
  char_poly (BinvA n L k) = 'X^2 * \prod_(f <- fs) ('X - (- f^-1)%:P) /\
  ~~ root (\prod_(f <- fs) ('X - (- f^-1)%:P)) 0.
Proof.
move=> rfs; split; first exact: characteristic_polynomial.
have [gs [rgs _ pfs _]] := critical_forces two links one; rewrite (roots_of_inj rfs rgs).
rewrite -(big_map (fun f => - f^-1) predT (fun a => 'X - a%:P)) root_prod_XsubC.
apply/mapP => -[f /(allP pfs) f0 /esym/eqP]; rewrite oppr_eq0 invr_eq0.
by rewrite (gt_eqF f0).
Qed.

(* The others are real and negative, the -1/F_m. *)
Theorem eigenvalues a : eigenvalue (BinvA n L k) a = (a == 0) || (a < 0) && (root (D n L k) (- a^-1)).
Proof.
have [fs [rfs _ pfs _]] := critical_forces two links one.
rewrite eigenvalue_root_char (characteristic_polynomial rfs) rootM {1}/root hornerXn sqrf_eq0.
congr (_ || _); rewrite -(big_map (fun f => - f^-1) predT (fun a => 'X - a%:P)) root_prod_XsubC.
rewrite (roots_of_root _ rfs); apply/mapP/andP => [[f f_fs ->]|[a0 f_fs]].
  have f0 := allP pfs _ f_fs; split; first by rewrite oppr_lt0 invr_gt0.
  by rewrite invrN opprK invrK.
by exists (- a^-1) => //; rewrite invrN opprK invrK.
Qed.

Theorem eigenvalues_distinct fs : no_interior_passive n k -> roots_of (D n L k) fs ->
  uniq [seq - f^-1 | f <- fs].
Proof.
move=> el rfs; rewrite map_inj_uniq ?(simple_forces two links one el rfs) //.
by move=> a b /oppr_inj/invr_inj.
Qed.

End Real.
