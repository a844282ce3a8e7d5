(* Mode m changes sign m times: theorem "Nodes" of theorems.md. *)
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp Require Import polyrcf.
From mathcomp Require Import ring.
Require Import chain determinant string recursion forces definite modes stability signs.

Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Import Order.TTheory GRing.Theory Num.Theory.
Local Open Scope ring_scope.

(* The count of the recursion is the number of sign changes, zeros dropped. *)
Lemma sweep_signs (R : rcfType) (z k : nat -> R) F j : 0 < z 0%N ->
  let hs := [seq (H z k i).[F] | i <- iota 0 j.+1] in
  last_of 0 hs != 0 /\ sweep z k F j = (sign_changes hs, last_of 0 hs < 0).
Proof.
move=> z0 hs; rewrite {}/hs; elim: j => [|j [nz e]].
  have p : 0 < z 0%N ^+ 2 by apply: exprn_gt0.
  by rewrite /= hornerC /sign_changes /= (gt_eqF p) mul0r ltxx (gt_eqF p) ltNge (ltW p).
have -> : iota 0 j.+2 = rcons (iota 0 j.+1) j.+1 by rewrite -[j.+2]addn1 iotaD cats1.
rewrite map_rcons /sign_changes changes_after_rcons last_of_rcons.
move: [seq _ | i <- iota 0 j.+1] nz e => hs nz e; set v := (H z k j.+1).[F].
have -> : sweep z k F j.+1 = (let: (count, negative) := sweep z k F j in
    let now := if v == 0 then negative else v < 0 in ((count + (now != negative))%N, now)) by [].
rewrite e /=; case: (eqVneq v 0) => [_|v0]; first by rewrite eqxx addn0.
by rewrite mulr_lt0 nz v0 /=; split=> //; congr ((_ + nat_of_bool _)%N, _); case: (_ < 0); case: (_ < 0).
Qed.

Section Shape.

Variables (R : rcfType) (n : nat) (L k f : nat -> R) (F Fy : R).
Hypotheses (two : (1 < n)%N) (links : chain_of_links n L k) (inner : no_interior_passive n k).
Hypothesis shape : mode L k F (\col_(i < n) f i) Fy.
Let z := distance n L.
Let s := deflection n L f.

Let pos i : (i < n)%N -> 0 < L i. Proof. by have [h _] := links; apply: h. Qed.
Let zp i : (i < n)%N -> 0 < z i. Proof. by move=> i_n; apply: distance_pos. Qed.
Let z_neq0 i : (i < n)%N -> z i != 0. Proof. by move=> /zp /gt_eqF ->. Qed.
Let n0 : (0 < n)%N. Proof. exact: ltnW. Qed.
Let sS i : s i.+1 = s i + z i * f i. Proof. exact: deflectionS. Qed.
Let s0 : s 0%N = 0. Proof. exact: deflection0. Qed.
Let sn : s n = 0. Proof. by have [_ _] := shape => /on_axis. Qed.
Let nE : n.-2.+2 = n. Proof. by case: n two => [|[]]. Qed.

(* The slopes of the string, from the moments at the joints. *)
Let slope i : R := F * ((\sum_(0 <= j < i.+1) f j) - s i.+1 / z i) - Fy.

Let slope_at i : (i < n)%N -> k i * f i = z i * slope i.
Proof.
move=> i_n; have [_ e _] := shape; move/colP: e => /(_ (Ordinal i_n)).
rewrite !mxE (bigD1 (Ordinal i_n)) //= big1 ?addr0 => [|j /negPf j_i]; last first.
  by rewrite !mxE eq_sym j_i mulr0n mul0r.
rewrite !mxE eqxx mulr1n (eq_bigr (fun j : 'I_n => - (z (maxn i j) * f j))); last by move=> j _; rewrite !mxE mulNr.
have := row_S1 s0 (fun i _ => sS i) sn i_n; rewrite big_mkord sumrN => ->.
rewrite -/(z i) => e; have -> : k i * f i = F * (z i * (\sum_(0 <= j < i.+1) f j) - s i.+1) - Fy * z i +
    (k i * f i + F * - (z i * (\sum_(0 <= j < i.+1) f j) - s i.+1) + Fy * z i) by ring.
by rewrite e addr0 /slope; field; rewrite z_neq0.
Qed.

Let slopeS i : (i.+1 < n)%N -> slope i.+1 = slope i - F * bead z i * s i.+1.
Proof.
move=> i_n; rewrite /slope big_nat_recr //= [s i.+2]sS /bead.
move: (\sum_(_ <= _ < _) _) (s i.+1) => t d; field.
by rewrite !z_neq0 // ltnW.
Qed.

Let K i : R := \prod_(l < i) k l.+1.

Let K_gt0 i : (i < n.-1)%N -> 0 < K i.
Proof.
move=> i_n; apply: prodr_gt0 => l _; have l_n : (l.+2 < n)%N.
  by rewrite -[X in (_ < X)%N](prednK n0) ltnS (leq_trans _ i_n) // ltnS.
by rewrite lt0r inner //=; have [_] := links; apply; apply: ltnW.
Qed.

(* Deflections and slopes are those of the recursion. *)
Let along i : (i < n)%N -> s i.+1 * (z 0%N * K i) = f 0%N * (H z k i).[F] /\
  ((i.+1 < n)%N -> slope i.+1 * (z 0%N * K i) = f 0%N * (G z k i.+1).[F]).
Proof.
elim: i => [|i IH] i_n.
  rewrite /K big_ord0 sS s0 /= hornerC; split=> [|i1]; first by ring.
  rewrite G_at !hornerC slopeS // [s 1%N]sS s0.
  transitivity (z 0%N * slope 0 - F * bead z 0 * (z 0%N * f 0%N) * z 0%N); first by ring.
  by rewrite -slope_at //; ring.
have [eH /(_ i_n) eG] := IH (ltnW i_n); have KS : K i.+1 = K i * k i.+1 by rewrite /K big_ord_recr.
have eH' : s i.+2 * (z 0%N * K i.+1) = f 0%N * (H z k i.+1).[F].
  rewrite sS KS; transitivity (k i.+1 * (s i.+1 * (z 0%N * K i)) + z i.+1 * (k i.+1 * f i.+1) * (z 0%N * K i)).
    by ring.
  rewrite eH slope_at //; transitivity (k i.+1 * (f 0%N * (H z k i).[F]) +
    z i.+1 ^+ 2 * (slope i.+1 * (z 0%N * K i))); first by ring.
  by rewrite eG H_at; ring.
split=> // i2; rewrite slopeS // KS.
transitivity (k i.+1 * (slope i.+1 * (z 0%N * K i)) - F * bead z i.+1 * (s i.+2 * (z 0%N * K i.+1))).
  by rewrite KS; ring.
by rewrite eG eH' [(G z k i.+2).[F]]G_at; ring.
Qed.

Let some_deflection : exists2 i, (i <= n)%N & s i != 0.
Proof.
have [q0 _ _] := shape; case: (boolP [forall i : 'I_n.+1, s i == 0]) => [/forallP all0|].
  case/eqP: q0; apply/colP => i; rewrite !mxE; have := sS i.
  have := all0 (Ordinal (ltn_ord i : (i.+1 < n.+1)%N)); have := all0 (Ordinal (leqW (ltn_ord i))).
  move=> /= /eqP -> /eqP ->; rewrite add0r => /esym/eqP.
  by rewrite mulf_eq0 (negPf (z_neq0 (ltn_ord i))) => /eqP.
by rewrite negb_forall => /existsP [i si]; exists i => //; rewrite -ltnS.
Qed.

Let first_turns : f 0%N != 0.
Proof.
apply/eqP => f0; have [i i_n /eqP []] := some_deflection.
case: i i_n => [|i] i_n; first exact: s0.
case: (ltnP i n.-1) => [i_lt|]; last by rewrite -ltnS prednK // => h; rewrite (_ : i.+1 = n) ?sn //; apply/eqP; rewrite eqn_leq i_n.
have [+ _] := along i_n; rewrite f0 mul0r => /eqP; rewrite !mulf_eq0 (negPf (z_neq0 n0)) (gt_eqF (K_gt0 i_lt)) !orbF.
by move/eqP.
Qed.

(* As many changes as there are forces below. *)
Let inner_changes : (H z k n.-1).[F] = 0 ->
  sign_changes [seq s i | i <- iota 1 n.-1] = changes z k F n.-1.
Proof.
move=> rt; have n1 : n.-1 = n.-2.+1 by rewrite -[in LHS]nE.
have -> : changes z k F n.-1 = changes z k F n.-2.
  rewrite /changes n1 /=; case: (sweep _ _ _ _) => c b /=.
  by rewrite -n1 rt eqxx eqxx addn0.
have [_ /(congr1 fst)] := sweep_signs k F n.-2 (zp n0); rewrite -n1 -/(changes _ _ _ _) /= => ->.
have -> : [seq s i | i <- iota 1 n.-1] = [seq s i.+1 | i <- iota 0 n.-1].
  by rewrite -[1%N]addn0 iotaDl -map_comp; apply: eq_map.
apply: (sign_changes_scaled (a := f 0%N) (w := fun i => f 0%N / (z 0%N * K i))) => i /andP [_ i_n].
rewrite add0n in i_n; have i_n' : (i < n)%N by apply: leq_trans i_n (leq_pred _).
have zK : 0 < z 0%N * K i by rewrite mulr_gt0 ?zp ?K_gt0.
split; last by rewrite mulrA -expr2 divr_gt0 // lt0r sqrf_eq0 first_turns sqr_ge0.
have [e _] := along i_n'; apply: (mulIf (negbT (gt_eqF zK))); rewrite e mulrAC divfK ?gt_eqF //.
Qed.

Lemma at_least : (H z k n.-1).[F] = 0 -> (changes z k F n.-1 < sign_changes [seq f i | i <- iota 0 n])%N.
Proof.
move=> rt; have := rolle some_deflection; rewrite s0 sn eqxx.
have -> : [seq s i | i <- iota 0 n.+1] = 0 :: rcons [seq s i | i <- iota 1 n.-1] 0.
  have io : iota 1 n = rcons (iota 1 n.-1) n.
    by rewrite -{1}(prednK n0) -[n.-1.+1]addn1 iotaD cats1 add1n prednK.
  have -> : iota 0 n.+1 = 0%N :: iota 1 n by [].
  by rewrite io map_cons map_rcons s0 sn.
rewrite sign_changes_zero sign_changes_rcons0 inner_changes // !addn1 ltnS.
have -> : sign_changes [seq s j.+1 - s j | j <- iota 0 n] = sign_changes [seq f i | i <- iota 0 n].
  apply: (sign_changes_scaled (a := 1) (w := z)) => i /andP [_ i_n]; rewrite mul1r sS addrAC subrr add0r.
  by rewrite zp.
by [].
Qed.

Let slope_changes : F != 0 -> 0 < F -> (H z k n.-1).[F] = 0 ->
  (sign_changes [seq slope i | i <- iota 0 n] + (slope 0 == 0)%R + (slope n.-1 == 0)%R <= (changes z k F n.-1).+1)%N.
Proof.
move=> F0 Fp rt; have e : sign_changes [seq slope j.+1 - slope j | j <- iota 0 n.-1] = changes z k F n.-1.
  rewrite -inner_changes // -[iota 1 _]/(iota (1 + 0) _) iotaDl -map_comp.
  apply: (sign_changes_scaled (a := -1) (w := fun i => - (F * bead z i))) => i /andP [_ i_n].
  have i1 : (i.+1 < n)%N by rewrite -[X in (_ < X)%N](prednK n0) ltnS.
  split; first by rewrite slopeS // addrAC subrr add0r mulNr.
  rewrite mulN1r opprK mulr_gt0 //; apply: (bead_gt0 (chain_distances two links)).
  exact: i_n.
rewrite -e -[X in iota 0 X](prednK n0); apply: rolle.
case: (boolP [forall i : 'I_n, slope i == 0]) => [/forallP all0|]; last first.
  by rewrite negb_forall => /existsP [i si]; exists i => //; rewrite -ltnS prednK.
have [[|i] i_n /eqP []] := some_deflection; first exact: s0.
case: (ltnP i.+1 n) => [i1|h]; last first.
  by have -> : i.+1 = n; [apply/eqP; rewrite eqn_leq i_n h | exact: sn].
have := slopeS i1; have /eqP -> := all0 (Ordinal i1); have /eqP /= -> := all0 (Ordinal (ltnW i1)).
have bp : 0 < bead z i by apply: (bead_gt0 (chain_distances two links)); rewrite -ltnS prednK.
by rewrite sub0r => /esym/eqP; rewrite oppr_eq0 2!mulf_eq0 (negPf F0) (gt_eqF bp) => /eqP.
Qed.

Let scaled_part i m : (forall j, (i <= j < i + m)%N -> (j < n)%N /\ 0 < k j) ->
  sign_changes [seq slope j | j <- iota i m] = sign_changes [seq f j | j <- iota i m].
Proof.
move=> h; apply: (sign_changes_scaled (a := 1) (w := fun j => k j / z j)) => j /h [j_n kj].
by rewrite mul1r divr_gt0 ?zp // mulrAC slope_at // mulrC mulKf ?z_neq0.
Qed.

Lemma at_most : at_most_one_passive n k -> 0 < F -> (H z k n.-1).[F] = 0 ->
  (sign_changes [seq f i | i <- iota 0 n] <= (changes z k F n.-1).+1)%N.
Proof.
move=> one Fp rt; have := slope_changes (negbT (gt_eqF Fp)) Fp rt; have [_ k_ge0] := links.
have last_n : (n.-1 < n)%N by rewrite prednK.
have kp j : (j < n)%N -> k j != 0 -> 0 < k j by move=> j_n kj; rewrite lt0r kj k_ge0.
have slope0 j : (j < n)%N -> k j = 0 -> slope j = 0.
  move=> j_n kj; have /esym/eqP := slope_at j_n; rewrite kj mul0r mulf_eq0 (negPf (z_neq0 j_n)) /=.
  by move/eqP.
have nE1 : iota 0 n = 0%N :: iota 1 n.-1 by rewrite -{1}(prednK n0).
have nE2 : iota 0 n = rcons (iota 0 n.-1) n.-1 by rewrite -{1}(prednK n0) -[n.-1.+1]addn1 iotaD cats1.
case: (eqVneq (k 0%N) 0) => [k0|k0].
  rewrite slope0 // eqxx nE1 /= slope0 // sign_changes_zero scaled_part => [h|j /andP [j1 j_n]].
    apply: leq_trans (sign_changes_cons _ _) _; rewrite ltnS.
    by have := leq_trans (leq_addr _ _) h; rewrite addn1 ltnS.
  rewrite add1n prednK // in j_n; split=> //; apply: kp => //; apply/eqP => kj.
  by have := one _ _ j_n n0 kj k0 => j0; rewrite j0 in j1.
case: (eqVneq (k n.-1) 0) => [kn|kn].
  rewrite [slope n.-1]slope0 // eqxx nE2 !map_rcons slope0 // sign_changes_rcons0 scaled_part => [h|j /andP [_ j_n]].
    apply: leq_trans (sign_changes_rcons _ _) _; apply: leq_trans h.
    by rewrite addn1 ltnS leq_addr.
  rewrite add0n in j_n; have j_n' := leq_trans j_n (leq_pred n); split=> //; apply: kp => //; apply/eqP => kj.
  by have := one _ _ j_n' last_n kj kn => je; rewrite je ltnn in j_n.
rewrite scaled_part => [h|j /andP [_ j_n]]; first by apply: leq_trans h; rewrite -addnA leq_addr.
rewrite add0n in j_n; split=> //; apply: kp => //; case: (posnP j) => [->//|j0].
case: (eqVneq j n.-1) => [->//|j_last]; apply: inner => //.
by rewrite -[X in (_ < X)%N](prednK n0) ltnS ltn_neqAle j_last -ltnS prednK.
Qed.

End Shape.

Section Nodes.

Variables (R : rcfType) (n : nat) (L k : nat -> R).
Hypotheses (two : (1 < n)%N) (links : chain_of_links n L k) (one : at_most_one_passive n k).

(* Counted from 0: mode m changes sign m + 1 times. *)
Theorem nodes fs m (f : nat -> R) Fy : no_interior_passive n k -> roots_of (D n L k) fs -> (m < n.-1)%N ->
  mode L k fs`_m (\col_(i < n) f i) Fy -> sign_changes [seq f i | i <- iota 0 n] = m.+1.
Proof.
move=> inner rfs m_n shape; set F := fs`_m in shape *.
have [gs [rgs sz pgs cgs]] := critical_forces two links one; rewrite -{gs rgs}(roots_of_inj rfs rgs) in sz pgs cgs.
have F_fs : F \in fs by rewrite mem_nth ?sz.
have Fp : 0 < F := allP pgs _ F_fs.
have c_n : cut n k = n.-1.
  case: (ltngtP (cut n k) n.-1) (cut_le k two) => // h _.
  have /eqP := cut_passive two h; rewrite (negPf (inner _ _ _)) //.
  by rewrite -(prednK (ltnW two)) ltnS.
have rt : (H (distance n L) k n.-1).[F] = 0.
  have : root (D n L k) F by rewrite (roots_of_root F rfs).
  by rewrite (D_recursion two links) rootN => /eqP.
have cm : changes (distance n L) k F n.-1 = m.
  have [sfs _] := rfs; have := cgs F; rewrite /count_below c_n subnn addn0 => ->.
  have ss : sorted <%R fs by rewrite lt_sorted_uniq_le (simple_forces two links one inner rfs).
  by rewrite -[RHS](@count_lt_nth _ _ 0 _ _ ss) ?sz.
apply/eqP; rewrite eqn_leq -cm (at_least two links inner shape rt) andbT.
exact: (at_most two links inner shape one Fp rt).
Qed.

End Nodes.
