(* How many directions the energy falls along: the inertia of the quadratic energy under the constraint is the count of
   critical forces below the force. From it, two chains compared. *)
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp Require Import polyrcf.
From mathcomp Require Import ring.
Require Import chain determinant string recursion forces definite modes stability inertia.

Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Import Order.TTheory GRing.Theory Num.Theory.
Local Open Scope ring_scope.

Section String.

Variables (R : rcfType) (z k : nat -> R) (F : R) (j : nat).
Hypotheses (dz : distances j z) (off : forall i, (i <= j)%N -> (H z k i).[F] != 0).

(* Negative weights are the sign changes. *)
Lemma changes_weights : changes z k F j = count (fun i => weight z k F i < 0) (iota 0 j).
Proof.
suff [_ ->] : (sweep z k F j).2 = ((H z k j).[F] < 0) /\ changes z k F j = count (fun i => weight z k F i < 0) (iota 0 j).
  by [].
have := off; have := dz; elim: j => [|i IH] [zp zd] nz.
  by split=> //; rewrite hornerC ltNge sqr_ge0.
have [||e c] := IH; first by split=> l h; [apply: zp | apply: zd]; apply: leqW.
  by move=> l h; apply: nz; apply: leqW.
rewrite -[in iota _ _]addn1 iotaD count_cat -c /= addn0 add0n /changes /=.
move: e; case: (sweep z k F i) => b neg /= ->; rewrite (negPf (nz i.+1 _)) //; split=> //; congr (_ + _)%N.
have z0 : 0 < z i.+1 ^+ 2 by rewrite exprn_gt0 ?zp.
congr nat_of_bool; rewrite /weight pmulr_rlt0 // invr_lt0.
case: (ltrgtP (H z k i).[F] 0) (nz i (leqnSn i)) => // hi _; case: (ltrgtP (H z k i.+1).[F] 0) (nz i.+1 (leqnn _)) => // hj _.
- by rewrite ltNge nmulr_rge0 // ltW.
- by rewrite nmulr_rlt0.
- by rewrite pmulr_rlt0.
by rewrite ltNge pmulr_rge0 // ltW.
Qed.

(* From the end of the string backwards nothing deflects where no square is left. *)
Lemma parts_zero (q s : nat -> R) : (forall i, (i <= j)%N -> s i.+1 = s i + z i * q i) -> s j.+1 = 0 ->
  (forall i, (i < j)%N -> part z k q s F i = 0) -> forall i, (i <= j)%N -> s i.+1 = 0.
Proof.
move=> sS; elim: j dz off sS => [|i IH] [zp zd] nz sS end0 parts l; first by rewrite leqn0 => /eqP ->.
rewrite leq_eqVlt => /orP [/eqP -> //|]; rewrite ltnS; apply: IH => {l}.
- by split=> l h; [apply: zp | apply: zd]; apply: leqW.
- by move=> l h; apply: nz; apply: leqW.
- by move=> l h; apply: sS; apply: leqW.
- have zi : z i.+1 != 0 by rewrite gt_eqF ?zp.
  have := parts i (ltnSn i); rewrite /part.
  have -> : q i.+1 = - s i.+1 / z i.+1 by have := sS i.+1 (leqnn _); rewrite end0 => /eqP; rewrite eq_sym addrC addr_eq0 => /eqP <-; field.
  have -> : (G z k i.+1).[F] * s i.+1 - k i.+1 / z i.+1 * (H z k i).[F] * (- s i.+1 / z i.+1) =
      (H z k i.+1).[F] * s i.+1 / z i.+1 ^+ 2 by rewrite H_at; field.
  move/eqP; rewrite mulf_eq0 invr_eq0 expf_eq0 (negPf zi) /= orbF mulf_eq0 (negPf (nz _ (leqnn _))) /=.
  by move/eqP.
by move=> l h; apply: parts; apply: leqW.
Qed.

End String.

Section Chain.

Variables (R : rcfType) (n : nat) (L k : nat -> R).
Hypotheses (two : (1 < n)%N) (links : chain_of_links n L k).
Let z := distance n L.
Let c := cut n k.
Let m := (n.-1 - c)%N.

Let c_le : (c <= n.-1)%N. Proof. exact: (@cut_le R n k two). Qed.
Let cm : (c + m)%N = n.-1. Proof. exact: subnKC. Qed.
Let nE : n.-1.+1 = n. Proof. by rewrite prednK // ltnW. Qed.
Let pos i : (i < n)%N -> 0 < L i. Proof. by have [h _] := links; apply: h. Qed.

(* At all forces but finitely many. *)
Definition regular F : Prop :=
  (forall i, (i <= c)%N -> (H z k i).[F] != 0) /\ (forall i, (i <= m)%N -> (H (from c z) (from c k) i).[F] != 0).

Lemma regular_but : exists2 p : {poly R}, p != 0 & forall F, p.[F] != 0 -> regular F.
Proof.
have nz (z' k' : nat -> R) j i : distances j z' -> (i <= j)%N -> H z' k' i != 0.
  move=> dz i_j; apply/eqP => h; have := coef_sign k' dz i_j.
  by rewrite h coef0 mulr0 ltxx.
exists ((\prod_(i < c.+1) H z k i) * \prod_(i < m.+1) H (from c z) (from c k) i).
  rewrite mulf_neq0 //; apply/prodf_neq0 => i _.
    by apply: (nz _ _ c) (leq_ord i); apply: first_distances.
  by apply: (nz _ _ m) (leq_ord i); apply: second_distances.
move=> F; rewrite hornerM mulf_eq0 negb_or !horner_prod => /andP [/prodf_neq0 a /prodf_neq0 b].
split=> i i_le; first exact: (a (Ordinal (i_le : (i < c.+1)%N)) isT).
exact: (b (Ordinal (i_le : (i < m.+1)%N)) isT).
Qed.

(* g s_(i+1) - h q_(i+1) as a row. *)
Definition row_at (g h : R) i : 'rV[R]_n := \row_j (g * (z j *+ (j <= i)) - h *+ (val j == i.+1)).

Lemma row_atE g h i (f : nat -> R) : (i.+1 < n)%N ->
  (row_at g h i *m (\col_j f j : 'cV[R]_n)) 0 0 = g * deflection n L f i.+1 - h * f i.+1.
Proof.
move=> i_n; rewrite mxE.
rewrite (eq_bigr (fun j : 'I_n => g * ((z j * f j) *+ (j <= i)) - h * (f j *+ (val j == i.+1)))); last first.
  by move=> j _; rewrite !mxE; case: (j <= i)%N; case: (_ == _); rewrite ?mulr1n ?mulr0n; ring.
rewrite sumrB -!mulr_sumr; congr (g * _ - h * _).
  rewrite /deflection [RHS](big_nat_widen _ _ n) ?(ltnW i_n) // big_mkord [RHS]big_mkcond.
  by apply: eq_bigr => j _; rewrite ltnS; case: (j <= i)%N.
by rewrite (bigD1 (Ordinal i_n)) //= eqxx mulr1n big1 ?addr0 // => j; rewrite -val_eqE => /negPf ->.
Qed.

Definition first_row F i := row_at (G z k i.+1).[F] (k i.+1 / z i.+1 * (H z k i).[F]) i.
Definition second_row F i := row_at (G (from c z) (from c k) i.+1).[F]
  (from c k i.+1 / from c z i.+1 * (H (from c z) (from c k) i).[F]) (c + i).

Lemma first_rowE F i (f : nat -> R) : (i < c)%N ->
  (first_row F i *m (\col_j f j : 'cV[R]_n)) 0 0 = part z k f (deflection n L f) F i.
Proof. by move=> i_c; rewrite row_atE // -[X in (_ < X)%N]nE ltnS (leq_trans i_c). Qed.

Lemma second_rowE F i (f : nat -> R) : (i < m)%N ->
  (second_row F i *m (\col_j f j : 'cV[R]_n)) 0 0 =
  part (from c z) (from c k) (angles_behind n L k f) (deflections_behind n L k f) F i.
Proof.
move=> i_m; have h : (c + i < n.-1)%N by rewrite -[X in (_ < X)%N]cm ltn_add2l.
have h' : ((c + i).+1 < n)%N by rewrite -[X in (_ < X)%N]nE ltnS.
by rewrite row_atE // /part /deflections_behind /angles_behind addnS.
Qed.

Lemma axisP (q : 'cV[R]_n) : vanish [:: (S0 n L)^T] q <-> (S0 n L)^T *m q = 0.
Proof. by split=> [h|h r]; [apply: h; rewrite inE | rewrite inE => /eqP ->]. Qed.

(* As many squares are negative as there are sign changes. *)
Theorem energy_inertia F : regular F -> inertia (second_variation L k F) [:: (S0 n L)^T] (count_below n L k F).
Proof.
move=> [nz nz']; have d1 := first_distances two links; have d2 := second_distances two links.
exists ([seq (weight z k F i, first_row F i) | i <- iota 0 c] ++
        [seq (weight (from c z) (from c k) F i, second_row F i) | i <- iota 0 m]); split.
- by rewrite size_cat !size_map !size_iota cm add1n nE.
- by rewrite count_cat !count_map /count_below !changes_weights.
- move=> q /axisP; have [f ->] := as_function q; move/on_axis => fn.
  rewrite second_variationE spring_and_mass // ?(ltnW two) // strain_sum energy_of_strings //.
  rewrite (energy_squares d1 (deflection0 _ _ _) (fun i _ => deflectionS _ _ _ i) (leqnn _) nz) least_first // add0r.
  rewrite (energy_squares d2 (erefl _) (deflections_behindS two links f) (leqnn _) nz') least_second // add0r.
  have over N (g : nat -> R) : \sum_(i <- iota 0 N) g i = \sum_(i < N) g i.
    by rewrite -[in LHS](subn0 N) -/(index_iota 0 N) big_mkord.
  rewrite /squares big_cat !big_map !over /=.
  by congr (_ + _); apply: eq_bigr => i _; [rewrite first_rowE | rewrite second_rowE].
move=> q /axisP; have [f ->] := as_function q; move/on_axis => fn zero.
have at_first i : (i < c)%N -> part z k f (deflection n L f) F i = 0.
  move=> i_c; rewrite -first_rowE // zero ?mxE // map_cat mem_cat -!map_comp; apply/orP; left.
  by apply/mapP; exists i => //; rewrite mem_iota.
have at_second i : (i < m)%N ->
    part (from c z) (from c k) (angles_behind n L k f) (deflections_behind n L k f) F i = 0.
  move=> i_c; rewrite -second_rowE // zero ?mxE // map_cat mem_cat -!map_comp; apply/orP; right.
  by apply/mapP; exists i => //; rewrite mem_iota.
have end2 : deflections_behind n L k f m.+1 = 0 by rewrite /= addnS cm nE.
have s2 := parts_zero d2 nz' (deflections_behindS two links f) end2 at_second.
have end1 : deflection n L f c.+1 = 0 by have := s2 0%N (leq0n _); rewrite /= addn1.
have s1 := parts_zero d1 nz (fun i _ => deflectionS _ _ _ i) end1 at_first.
have s0 i : (i <= n)%N -> deflection n L f i = 0.
  case: i => [|i] i_n; first exact: deflection0.
  case: (leqP i c) => [/s1 //|c_i]; have := s2 (i - c)%N; rewrite /= addnS subnKC ?(ltnW c_i) //; apply.
  by rewrite /m leq_sub2r // -ltnS nE.
apply/colP => i; rewrite !mxE; have := deflectionS n L f i; rewrite !s0 ?(ltnW (ltn_ord i)) // add0r => /esym/eqP.
by rewrite mulf_eq0 gt_eqF ?distance_pos //= => /eqP.
Qed.

End Chain.

(* Where X takes the shapes of one chain to shapes of another whose energy is no greater, the other's forces are no greater:
   d places down, where X does so under d further conditions. *)
Section Compared.

Variables (R : rcfType) (n n' : nat) (L k L' k' : nat -> R).
Hypotheses (two : (1 < n)%N) (links : chain_of_links n L k) (one : at_most_one_passive n k).
Hypotheses (two' : (1 < n')%N) (links' : chain_of_links n' L' k') (one' : at_most_one_passive n' k').

Lemma forces_compared fs fs' (X : 'M[R]_(n, n')) Z m : roots_of (D n L k) fs -> roots_of (D n' L' k') fs' ->
  (forall F q, 0 < F -> (S0 n' L')^T *m q = 0 -> vanish Z q ->
     (S0 n L)^T *m (X *m q) = 0 /\ second_variation L k F (X *m q) <= second_variation L' k' F q) ->
  (m < n.-1)%N -> (m + size Z < n'.-1)%N -> fs`_m <= fs'`_(m + size Z).
Proof.
move=> rfs rfs' h m_n m_n'.
have [gs [rgs sz _ cgs]] := critical_forces two links one.
have [gs' [rgs' sz' pos' cgs']] := critical_forces two' links' one'.
rewrite -{gs rgs}(roots_of_inj rfs rgs) in sz cgs; rewrite -{gs' rgs'}(roots_of_inj rfs' rgs') in sz' pos' cgs'.
have [p p0 regp] := regular_but two links; have [p' p'0 regp'] := regular_but two' links'.
have [sfs _] := rfs; have [sfs' _] := rfs'.
apply: (forces_le sfs sfs' (mulf_neq0 p0 p'0)); rewrite ?sz ?sz' // => F F_gt.
rewrite hornerM mulf_eq0 negb_or => /andP [/regp r /regp' r']; rewrite -cgs -cgs'.
apply: (inertia_le (X := X) (energy_inertia two links r) (energy_inertia two' links' r')) => q.
move=> /axisP axis Zq _; have [|VX le] := h F q _ axis Zq; last by split=> //; apply/axisP.
by apply: lt_trans F_gt; apply: (allP pos'); rewrite mem_nth // sz'.
Qed.

End Compared.
