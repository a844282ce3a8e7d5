(* The recursion as polynomials in the force: real positive simple roots, interlaced from link to link, and counted by
   sign changes. Theorem "Recursion" of theorems.md for one string of beads. *)
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp Require Import polyrcf.
From mathcomp Require Import ring.
Require Import chain determinant string.

Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Import Order.TTheory GRing.Theory Num.Theory.
Local Open Scope ring_scope.

Section Polynomials.

Variable R : fieldType.
Implicit Types (z k : nat -> R) (F : R) (j : nat).

(* [link] and [state] of determinant.v with the force as the variable of polynomials. *)
Definition poly_link z k (s : {poly R} * {poly R}) j :=
  let g := k j *: s.2 - bead z j *: ('X * s.1) in (k j.+1 *: s.1 + z j.+1 ^+ 2 *: g, g).
Fixpoint poly_state z k j : {poly R} * {poly R} :=
  if j is i.+1 then poly_link z k (poly_state z k i) i else ((z 0%N ^+ 2)%:P, 1).
Definition H z k j := (poly_state z k j).1.
Definition G z k j := (poly_state z k j).2.

Lemma G_S z k j : G z k j.+1 = k j *: G z k j - bead z j *: ('X * H z k j). Proof. by []. Qed.
Lemma H_S z k j : H z k j.+1 = k j.+1 *: H z k j + z j.+1 ^+ 2 *: G z k j.+1. Proof. by []. Qed.

Lemma G_at z k j F : (G z k j.+1).[F] = k j * (G z k j).[F] - F * bead z j * (H z k j).[F].
Proof. by rewrite G_S !(hornerD, hornerN, hornerZ, hornerM, hornerX) mulrA [bead z j * F]mulrC. Qed.
Lemma H_at z k j F : (H z k j.+1).[F] = k j.+1 * (H z k j).[F] + z j.+1 ^+ 2 * (G z k j.+1).[F].
Proof. by rewrite H_S !(hornerD, hornerZ). Qed.

Lemma horner_state z k j F : ((H z k j).[F], (G z k j).[F]) = state z k F (start z) j.
Proof.
elim: j => [|j]; first by rewrite /H /G /= !hornerC.
by rewrite H_at G_at /= /link => <- /=.
Qed.

Lemma hornerH z k j F : (H z k j).[F] = (state z k F (start z) j).1.
Proof. by rewrite -horner_state. Qed.

Lemma size_state z k j : (size (H z k j) <= j.+1)%N /\ (size (G z k j) <= j.+1)%N.
Proof.
elim: j => [|j [sH sG]]; first by rewrite size_polyC size_poly1; split=> //; case: eqP.
have scale c (p : {poly R}) l : (size p <= l)%N -> (size (c *: p) <= l)%N.
  exact: leq_trans (size_scale_leq _ _).
have add (p q : {poly R}) l : (size p <= l)%N -> (size q <= l)%N -> (size (p + q)%R <= l)%N.
  by move=> p_l q_l; apply: leq_trans (size_add _ _) _; rewrite geq_max p_l.
have sG' : (size (G z k j.+1) <= j.+2)%N.
  rewrite G_S; apply: add; first exact/scale/leqW.
  rewrite size_opp; apply: scale; apply: leq_trans (size_mul_leq _ _) _.
  by rewrite size_polyX.
by split=> //; rewrite H_S; apply: add; apply: scale => //; apply: leqW.
Qed.

Lemma coef_H z k j : (H z k j.+1)`_j.+1 = - (z j.+1 ^+ 2 * bead z j) * (H z k j)`_j.
Proof.
have [sH sG] := size_state z k j.
rewrite H_S G_S !coefD !coefZ coefB !coefZ coefXM /= (nth_default _ sG) nth_default ?(leq_trans sH) //.
by rewrite mulr0 mulr0 !add0r mulrN mulrA mulNr.
Qed.

End Polynomials.

Section Count.

Variable R : rcfType.
Implicit Types (z k : nat -> R) (F : R) (j m : nat).

(* The algorithm: sign changes in H_0 ... H_j at F, where a zero takes the sign before it (string_sweep.hpp,
   count_below; exact_count.cpp), and whether the last sign is negative. *)
Fixpoint sweep z k F j : nat * bool :=
  if j is i.+1 then
    let: (count, negative) := sweep z k F i in
    let v := (H z k j).[F] in
    let now := if v == 0 then negative else v < 0 in ((count + (now != negative))%N, now)
  else (0%N, false).
Definition changes z k F j := (sweep z k F j).1.

(* Distances that fall towards the end point. *)
Definition distances m z : Prop := (forall i, (i <= m)%N -> 0 < z i) /\ (forall i, (i < m)%N -> z i.+1 < z i).

Lemma bead_gt0 m z j : distances m z -> (j < m)%N -> 0 < bead z j.
Proof.
by move=> [pos dec] j_m; rewrite /bead divr_gt0 ?subr_gt0 ?dec ?mulr_gt0 ?pos // ltnW.
Qed.

Lemma coef_sign m z k j : distances m z -> (j <= m)%N -> 0 < (-1) ^+ j * (H z k j)`_j.
Proof.
move=> dz; elim: j => [|j IH] j_m.
  by rewrite expr0 mul1r coefC exprn_gt0 //; have [->] := dz.
rewrite coef_H exprS mulN1r mulNr mulNr mulrN opprK mulrCA pmulr_rgt0 ?IH 1?ltnW //.
by rewrite mulr_gt0 ?exprn_gt0 ?(bead_gt0 dz) //; have [->] := dz.
Qed.

(* At no force at all. *)
Lemma G0 z k j : (G z k j).[0] = \prod_(i < j) k i.
Proof.
elim: j => [|j IH]; first by rewrite big_ord0 hornerC.
by rewrite big_ord_recr /= G_at IH !mul0r subr0 mulrC.
Qed.

Lemma H0_gt0 m z k j : distances m z -> (j <= m)%N -> (forall i, (i <= j)%N -> 0 <= k i) ->
  (forall i, (0 < i <= j)%N -> 0 < k i) -> 0 < (H z k j).[0].
Proof.
move=> dz; elim: j => [|j IH] j_m k0 kp.
  by rewrite hornerC exprn_gt0 //; have [->] := dz.
rewrite H_at G0 ltr_paddr ?mulr_gt0 ?kp ?ltnSn //=.
  by rewrite mulr_ge0 ?exprn_ge0 ?prodr_ge0 // => [|i _]; [have [/(_ _ j_m)/ltW] := dz | rewrite k0 // ltnW].
apply: IH => [|i i_j|i /andP [i0 i_j]]; [exact: ltnW|by rewrite k0 // ltnW|by rewrite kp // i0 ltnW].
Qed.

(* What holds after j links. *)
Record string_roots z k j (x : nat -> R) : Prop := StringRoots {
  roots_split : splits (H z k j) j x;
  roots_next : forall i, (i < j)%N -> 0 < (-1) ^+ i.+1 * (G z k j.+1).[x i];
  roots_count : forall F, sweep z k F j = (below j x F, odd (below j x F))
}.

Lemma count_step z k j x y :
  (forall F, sweep z k F j = (below j y F, odd (below j y F))) ->
  splits (H z k j.+1) j.+1 x -> interlaced j x y ->
  forall F, sweep z k F j.+1 = (below j.+1 x F, odd (below j.+1 x F)).
Proof.
move=> IH sx il F; rewrite /= IH.
have [pos inc _] := sx; have := interlaced_below F il.
have := splits_root F sx; rewrite /root; case: eqP => [_ /esym/existsP [i /eqP <-] _|hF rt].
  by rewrite below_at // (interlaced_at inc il (ltn_ord i)) eqxx addn0.
have off i : (i < j.+1)%N -> x i != F.
  by move=> i_j; apply: contraFN (esym rt) => h; apply/existsP; exists (Ordinal i_j).
have := splits_sign sx off; move: (below j.+1 x F) (below j y F) => a b s /andP [].
have -> : ((H z k j.+1).[F] < 0) = odd a.
  move: s; rewrite -signr_odd; case: (odd a); first by rewrite expr1 mulN1r oppr_gt0.
  by rewrite expr0 mul1r => /ltW; rewrite leNgt => /negbTE.
rewrite leq_eqVlt => /orP [/eqP <- _|h1 h2]; first by rewrite eqxx addn0.
have -> : a = b.+1 by apply/eqP; rewrite eqn_leq h2 h1.
by rewrite /=; case: (odd b); rewrite addn1.
Qed.

(* The roots of the next one; its stiffness may be zero. *)
Lemma roots_step m z k j y : distances m z -> (j < m)%N -> string_roots z k j y -> 0 <= k j.+1 ->
  0 < (H z k j.+1).[0] ->
  exists x, [/\ splits (H z k j.+1) j.+1 x, interlaced j x y &
                forall F, sweep z k F j.+1 = (below j.+1 x F, odd (below j.+1 x F))].
Proof.
move=> dz j_m [sy ny cy] k0 h0.
have zj : 0 < z j.+1 by have [->] := dz.
have alt i : (i < j)%N -> 0 < (-1) ^+ i.+1 * (H z k j.+1).[y i].
  move=> i_j; have r : (H z k j).[y i] = 0.
    by apply/eqP; rewrite -/(root _ _) (splits_root _ sy); apply/existsP; exists (Ordinal i_j).
  rewrite H_at r mulr0 add0r mulrCA pmulr_rgt0 ?ny //.
  by rewrite exprn_gt0.
have [sz _] := size_state z k j.+1.
have [x sx il] := next_roots sy h0 alt sz (coef_sign k dz j_m).
by exists x; split=> //; apply: count_step il.
Qed.

Lemma next_sign m z k j x y : distances m z -> (j < m)%N -> 0 < k j.+1 ->
  splits (H z k j) j y -> splits (H z k j.+1) j.+1 x -> interlaced j x y ->
  forall i, (i < j.+1)%N -> 0 < (-1) ^+ i.+1 * (G z k j.+2).[x i].
Proof.
move=> dz j_m kp sy sx il i i_j.
have zj : 0 < z j.+1 by have [->] := dz.
have [pos inc _] := sx.
have r : (H z k j.+1).[x i] = 0.
  by apply/eqP; rewrite -/(root _ _) (splits_root _ sx); apply/existsP; exists (Ordinal i_j).
have := r; rewrite H_at => /(canRL (addKr _)); rewrite addr0 => Gx.
have off l : (l < j)%N -> y l != x i.
  move=> l_j; have [a b] := il l l_j; case: (leqP i l) => h.
    rewrite gt_eqF //; apply: le_lt_trans a.
    by move: h; rewrite leq_eqVlt => /orP [/eqP -> //|h]; rewrite ltW // inc // ltnW.
  rewrite lt_eqF //; apply: lt_le_trans b _.
  by move: h; rewrite leq_eqVlt => /orP [/eqP -> //|h]; rewrite ltW // inc.
have := splits_sign sy off; rewrite (interlaced_at inc il i_j) => sH.
have Gx' : (G z k j.+1).[x i] = - (k j.+1 / z j.+1 ^+ 2 * (H z k j).[x i]).
  apply: (@mulfI _ (z j.+1 ^+ 2)); first by rewrite expf_neq0 ?gt_eqF.
  by rewrite Gx; field; rewrite gt_eqF.
rewrite G_at r !mulr0 subr0 Gx' exprS.
rewrite mulN1r mulNr !mulrN opprK mulrCA pmulr_rgt0 // mulrCA pmulr_rgt0 //.
by rewrite divr_gt0 ?exprn_gt0.
Qed.

(* All stiffnesses behind the first are positive up to joint j. *)
Lemma elastic_roots m z k j : distances m z -> (j <= m)%N -> 0 <= k 0%N ->
  (forall i, (0 < i <= j)%N -> 0 < k i) -> exists x, string_roots z k j x.
Proof.
move=> dz; elim: j => [|j IH] j_m k0 kp.
  exists (fun=> 0); split=> //; last by move=> F; rewrite /below big_ord0.
  split=> //; exists (z 0%N ^+ 2); first by rewrite exprn_gt0 //; have [->] := dz.
  by rewrite big_ord0 alg_polyC.
have kp' i : (0 < i <= j)%N -> 0 < k i by case/andP=> i0 i_j; rewrite kp // i0 ltnW.
have [y sy] := IH (ltnW j_m) k0 kp'.
have kj : 0 < k j.+1 by rewrite kp ?ltnSn.
have h0 : 0 < (H z k j.+1).[0].
  by apply: (H0_gt0 dz) => // i i_j; case: i i_j => // i i_j; rewrite ltW // kp.
have [x [sx il cx]] := roots_step dz j_m sy (ltW kj) h0.
exists x; split=> //; apply: (next_sign dz) il => //.
by case: sy.
Qed.

(* The base may be passive, or the last joint, or neither. *)
Theorem string_theorem m z k : distances m.+1 z -> (forall i, (0 < i <= m)%N -> 0 < k i) ->
  0 <= k 0%N -> 0 <= k m.+1 -> 0 < k 0%N \/ 0 < k m.+1 ->
  exists x, [/\ splits (H z k m.+1) m.+1 x, (forall F, changes z k F m.+1 = below m.+1 x F) &
    exists2 y, splits (H z k m) m y & interlaced m x y].
Proof.
move=> dz kp k0 km some.
have [y sy] := elastic_roots dz (leqnSn m) k0 kp.
have h0 : 0 < (H z k m.+1).[0].
  have [d0 zm] : distances m z /\ 0 < z m.+1.
    by case: dz => a b; split; [split=> i i_m; [apply: a|apply: b]; exact: leqW | exact: a].
  have hm : 0 < (H z k m).[0].
    apply: (H0_gt0 d0) => // i i_m; case: i i_m => // i i_m.
    by rewrite ltW // kp.
  rewrite H_at G0; case: some => [k0p|kmp].
    rewrite ltr_paddl ?mulr_ge0 // 1?ltW // mulr_gt0 ?exprn_gt0 // prodr_gt0 // => i _.
    by case: i => [[|i] i_m] //=; rewrite kp.
  apply: ltr_paddr; last by rewrite mulr_gt0.
  apply: mulr_ge0; first by rewrite exprn_ge0 // ltW.
  apply: prodr_ge0 => i _.
  by case: i => [[|i] i_m] //=; rewrite ltW // kp.
have [x [sx il cx]] := roots_step dz (ltnSn m) sy km h0.
exists x; split=> //; first by move=> F; rewrite /changes cx.
by exists y => //; case: sy.
Qed.

End Count.
