(* The roots of the recursion along a string of beads, and its sign changes: theorem "Recursion" (a), (b) of
   theorems.md without any matrix. *)
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp Require Import polyrcf.
From mathcomp Require Import ring.
Require Import chain determinant.

Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Import Order.TTheory GRing.Theory Num.Theory.
Local Open Scope ring_scope.

Section Roots.

Variable R : rcfType.
Implicit Types (p q : {poly R}) (x y : nat -> R) (F : R) (m : nat).

(* How many of x 0 ... x (m-1) lie below F. *)
Definition below m x F : nat := (\sum_(i < m) (x i < F)%R)%N.

Definition increasing m x : Prop := forall i j, (i < j)%N -> (j < m)%N -> x i < x j.

(* p has the m roots x 0 < x 1 < ..., all positive, no others, and is positive before the first. *)
Definition splits p m x : Prop :=
  [/\ forall i, (i < m)%N -> 0 < x i, increasing m x &
      exists2 c, 0 < c & p = c *: \prod_(i < m) ((x i)%:P - 'X)].

Definition interlaced m x y : Prop := forall i, (i < m)%N -> x i < y i /\ y i < x i.+1.

Lemma sum_below m i : (\sum_(l < m) (l < i) = minn m i)%N.
Proof.
elim: m => [|m IH]; first by rewrite big_ord0 min0n.
rewrite big_ord_recr /= IH; case: (leqP m.+1 i) => h.
  by rewrite (minn_idPl (ltnW h)) addn1.
by rewrite (minn_idPr _) ?addn0 // -ltnS.
Qed.

Lemma below_from m x F i : (i <= m)%N -> (forall l, (l < m)%N -> (x l < F) = (l < i)%N) -> below m x F = i.
Proof.
move=> i_m h; rewrite -[RHS](minn_idPr i_m) -sum_below; apply: eq_bigr => l _.
by rewrite h.
Qed.

Lemma below_at m x i : increasing m x -> (i < m)%N -> below m x (x i) = i.
Proof.
move=> inc i_m; apply: below_from; first exact: ltnW.
move=> l l_m; case: (ltngtP l i) => [h|h|->]; last by rewrite ltxx.
  exact: inc.
by apply/negbTE; rewrite -leNgt ltW // inc.
Qed.

Lemma horner_splits p m x c F : p = c *: \prod_(i < m) ((x i)%:P - 'X) -> p.[F] = c * \prod_(i < m) (x i - F).
Proof. by move=> ->; rewrite hornerE horner_prod; congr (_ * _); apply: eq_bigr => i _; rewrite !hornerE. Qed.

Lemma splits_sign p m x F : splits p m x -> (forall i, (i < m)%N -> x i != F) -> 0 < (-1) ^+ below m x F * p.[F].
Proof.
move=> [_ _ [c c0 /horner_splits ->]] off; rewrite mulrCA pmulr_rgt0 // /below -prodrXr -big_split /=.
apply: prodr_gt0 => i _; have := off i (ltn_ord i); case: (ltgtP (x i) F) => // h _.
  by rewrite expr1 mulN1r oppr_gt0 subr_lt0.
by rewrite expr0 mul1r subr_gt0.
Qed.

Lemma splits_root p m x F : splits p m x -> root p F = [exists i : 'I_m, x i == F].
Proof.
move=> [_ _ [c c0 /horner_splits h]]; rewrite /root h mulf_eq0 (gt_eqF c0) /=.
apply/prodf_eq0/existsP => [[i _]|[i /eqP <-]]; last by exists i; rewrite // subrr.
by rewrite subr_eq0 => h'; exists i.
Qed.

(* Alternating signs at m + 1 points are m roots between them. *)
Lemma alternation q m (Y : nat -> R) :
  (forall j, (j < m)%N -> Y j < Y j.+1) -> (forall j, (j <= m)%N -> 0 < (-1) ^+ j * q.[Y j]) -> (size q <= m.+1)%N ->
  exists x, [/\ forall j, (j < m)%N -> Y j < x j /\ x j < Y j.+1, increasing m x &
                exists2 c, 0 < c & q = c *: \prod_(i < m) ((x i)%:P - 'X)].
Proof.
move=> inc alt sz.
have between (j : 'I_m) : exists r, [/\ Y j < r, r < Y j.+1 & root q r].
  have h1 := alt j (ltnW (ltn_ord j)); have h2 := alt j.+1 (ltn_ord j).
  have : Num.sg q.[Y j] * Num.sg q.[Y j.+1] = -1.
    move: h1 h2; rewrite exprS mulN1r mulNr oppr_gt0 -signr_odd; case: (odd j).
      by rewrite expr1 !mulN1r oppr_gt0 oppr_lt0 => /ltr0_sg -> /gtr0_sg ->; rewrite mulr1.
    by rewrite expr0 !mul1r => /gtr0_sg -> /ltr0_sg ->; rewrite mul1r.
  case/(ivt_sign (ltW (inc j (ltn_ord j)))) => r; rewrite inE /= => /andP [a b] rt.
  by exists r; split.
have [f fP] := fin_all_exists between.
pose x i := oapp f 0 (insub i).
have xE (i : 'I_m) : x i = f i by rewrite /x valK.
have xP j : (j < m)%N -> [/\ Y j < x j, x j < Y j.+1 & root q (x j)].
  by move=> j_m; have := fP (Ordinal j_m); rewrite -xE.
have Yinc i j : (i <= j)%N -> (j <= m)%N -> Y i <= Y j.
  elim: j => [|j IH]; first by rewrite leqn0 => /eqP ->.
  rewrite leq_eqVlt => /orP [/eqP ->//|]; rewrite ltnS => i_j j_m.
  by apply: le_trans (IH i_j (ltnW j_m)) (ltW (inc _ j_m)).
have incx : increasing m x.
  move=> i j i_j j_m; have [_ a _] := xP i (ltn_trans i_j j_m); have [b _ _] := xP j j_m.
  by apply: lt_trans a (le_lt_trans (Yinc _ _ i_j (ltnW j_m)) b).
exists x; split=> //; first by move=> j /xP [].
pose rs := [seq x i | i <- index_iota 0 m].
have urs : uniq rs.
  rewrite map_inj_in_uniq ?iota_uniq // => i j; rewrite !mem_index_iota /= => i_m j_m xij.
  by case: (ltngtP i j) => // h; [have := incx _ _ h j_m | have := incx _ _ h i_m]; rewrite xij ltxx.
have rrs : all (root q) rs.
  by apply/allP => r /mapP [i]; rewrite mem_index_iota /= => /xP [_ _ ?] ->.
have q0 : q != 0.
  by apply/eqP => q0; have := alt 0%N isT; rewrite q0 horner0 mulr0 ltxx.
have szrs : size rs = m by rewrite size_map size_iota subn0.
have szq : size q = (size rs).+1.
  by apply/eqP; rewrite szrs eqn_leq sz -{1}szrs max_poly_roots.
have := all_roots_prod_XsubC szq rrs; rewrite uniq_rootsE => /(_ urs) qE.
have prodE : \prod_(z <- rs) ('X - z%:P) = (-1) ^+ m *: \prod_(i < m) ((x i)%:P - 'X) :> {poly R}.
  rewrite big_map big_mkord (eq_bigr (fun i : 'I_m => - ((x i)%:P - 'X))); last by move=> i _; rewrite opprB.
  by rewrite prodrN card_ord -[in LHS]signr_odd -[in RHS]signr_odd; case: (odd m); rewrite ?expr1 ?scaleN1r ?mulN1r // !expr0 scale1r mul1r.
rewrite prodE scalerA in qE; exists (lead_coef q * (-1) ^+ m) => //.
have := alt 0%N isT; rewrite expr0 mul1r (horner_splits _ qE) pmulr_lgt0 //.
apply: prodr_gt0 => i _; rewrite subr_gt0; have [h _ _] := xP i (ltn_ord i).
by apply: le_lt_trans h; apply: Yinc => //; apply: ltnW.
Qed.

Lemma sign_at_infinity q m a : (size q <= m.+1)%N -> 0 < (-1) ^+ m * q`_m -> exists2 b, a < b & 0 < (-1) ^+ m * q.[b].
Proof.
move=> sz lc; pose p := (-1) ^+ m *: q.
have pm : p`_m = (-1) ^+ m * q`_m by rewrite coefZ.
have szp : size p = m.+1.
  apply/eqP; rewrite eqn_leq (leq_trans (size_scale_leq _ _) sz) /= ltnNge; apply/negP => h.
  by move: lc; rewrite -pm nth_default // ltxx.
have lcp : 0 < lead_coef p by rewrite lead_coefE szp pm.
have [b bP] := poly_pinfty_gt_lc lcp; exists (Num.max (a + 1) b).
  by rewrite lt_maxr ltr_addl ltr01.
have := bP (Num.max (a + 1) b); rewrite le_maxr lexx orbT => /(_ isT) /(lt_le_trans lcp).
by rewrite hornerZ.
Qed.

(* One step: roots of the next polynomial in the gaps between those of this one. *)
Lemma next_roots p q m y :
  splits p m y -> 0 < q.[0] -> (forall j, (j < m)%N -> 0 < (-1) ^+ j.+1 * q.[y j]) ->
  (size q <= m.+2)%N -> 0 < (-1) ^+ m.+1 * q`_m.+1 -> exists2 x, splits q m.+1 x & interlaced m x y.
Proof.
move=> [pos inc _] q0 alt sz lc.
pose last := if m is m'.+1 then y m' else 0.
have [b last_b qb] := sign_at_infinity last sz lc.
pose Y j := if j is j'.+1 then (if (j' < m)%N then y j' else b) else 0.
have Yb : Y m.+1 = b by rewrite /Y ltnn.
have Ym : Y m = last by rewrite /Y /last; case: (m) => // m'; rewrite ltnSn.
have Yinc j : (j < m.+1)%N -> Y j < Y j.+1.
  rewrite ltnS leq_eqVlt => /orP [/eqP ->|j_m]; first by rewrite Yb Ym.
  rewrite /Y j_m; case: j j_m => [|j] j_m; first exact: pos.
  by rewrite (ltn_trans (ltnSn j) j_m) inc.
have Yalt j : (j <= m.+1)%N -> 0 < (-1) ^+ j * q.[Y j].
  rewrite leq_eqVlt => /orP [/eqP ->|]; first by rewrite Yb.
  by case: j => [|j]; rewrite ?expr0 ?mul1r // ltnS => j_m; rewrite /Y j_m; apply: alt.
have [x [xY incx xq]] := alternation Yinc Yalt sz.
exists x; first split=> //.
  elim=> [|i IH] i_m; first by have [] := xY 0%N i_m.
  by apply: lt_trans (IH (ltnW i_m)) (incx _ _ (ltnSn i) i_m).
move=> i i_m; have [_] := xY i (ltnW i_m); have [h _] := xY i.+1 i_m; move: h.
by rewrite /Y i_m => -> ->.
Qed.

Lemma interlaced_below m x y F : interlaced m x y ->
  (below m y F <= below m.+1 x F)%N && (below m.+1 x F <= (below m y F).+1)%N.
Proof.
move=> il; apply/andP; split.
  rewrite /below big_ord_recr /=; apply: leq_trans (leq_addr _ _); apply: leq_sum => i _.
  by case: ltP => // h; rewrite (lt_trans _ h) //; have [] := il i (ltn_ord i).
rewrite /below big_ord_recl /= -add1n; apply: leq_add; first exact: leq_b1.
apply: leq_sum => i _; rewrite /bump leq0n add1n; case: ltP => // h.
by rewrite (lt_trans _ h) //; have [] := il i (ltn_ord i).
Qed.

Lemma interlaced_at m x y i : increasing m.+1 x -> interlaced m x y -> (i <= m)%N -> below m y (x i) = i.
Proof.
move=> inc il i_m; apply: below_from => // l l_m; have [a b] := il l l_m.
case: (ltnP l i) => h.
  apply: lt_le_trans b _; move: h; rewrite leq_eqVlt => /orP [/eqP ->//|h].
  by apply: ltW; apply: inc.
apply/negbTE; rewrite -leNgt ltW //; apply: le_lt_trans a.
move: h; rewrite leq_eqVlt => /orP [/eqP ->//|h]; apply: ltW; apply: inc => //.
exact: ltnW.
Qed.

End Roots.
