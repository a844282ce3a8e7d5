(* One stiffness raised, one joint frozen, the last link cut off: theorem "Interlacing" of theorems.md. *)
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp Require Import polyrcf.
From mathcomp Require Import ring.
Require Import chain determinant string recursion forces definite modes stability inertia directions monotone.

Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Import Order.TTheory GRing.Theory Num.Theory.
Local Open Scope ring_scope.

(* (a) *)
Section Raised.

Variables (R : rcfType) (n : nat) (L k k' : nat -> R) (i : nat).
Hypotheses (two : (1 < n)%N) (links : chain_of_links n L k) (one : at_most_one_passive n k).
Hypotheses (links' : chain_of_links n L k') (one' : at_most_one_passive n k').
Hypotheses (i_n : (i < n)%N) (stiffer : k i <= k' i) (others : forall j, (j < n)%N -> j != i -> k' j = k j).

Theorem raised_interlaced fs xs m : roots_of (D n L k) fs -> roots_of (D n L k') xs -> (m < n.-1)%N ->
  fs`_m <= xs`_m /\ ((m.+1 < n.-1)%N -> xs`_m <= fs`_m.+1).
Proof.
move=> rfs rxs m_n; split=> [|m_n1].
  apply: (forces_monotone two links one links' one' _ rfs rxs) => // j j_n.
  by case: (eqVneq j i) => [->|/others ->].
rewrite -addn1; apply: (forces_compared two links' one' two links one (X := 1%:M) (Z := [:: delta_mx 0 (Ordinal i_n)])) => //.
  move=> F q _ axis still; rewrite mul1mx; split=> //.
  have qi : q (Ordinal i_n) 0 = 0.
    have /matrixP/(_ 0 0) := still _ (mem_head _ _).
    by rewrite -rowE !mxE.
  rewrite !second_variationE ler_add2r; apply: ler_sum => j _.
  case: (eqVneq j (Ordinal i_n)) => [->|]; first by rewrite qi expr0n !mulr0.
  by rewrite -val_eqE => /(others (ltn_ord j)) ->.
by rewrite addn1.
Qed.

End Raised.

(* (b) Joint i frozen: links i - 1 and i become one, or link 0 a part of the base. *)
Section Frozen.

Variables (R : rcfType) (p : nat) (L k : nat -> R) (i : 'I_p.+1).
Let n := p.+1.

Definition frozen_length (j : nat) : R := L (bump i j) + (if j.+1 == i then L i else 0).
Definition frozen_stiffness (j : nat) : R := k (bump i j).

Lemma frozen_distance j : (j <= p)%N -> distance p frozen_length j = distance n L (bump i j).
Proof.
move=> j_p; rewrite -(subKn j_p); move: (p - j)%N (leq_subr j p) => l {j j_p}; elim: l => [|l IH] l_p.
  by rewrite subn0 /bump -ltnS ltn_ord /distance !big_geq.
have lt : (p - l.+1 < p)%N by rewrite ltn_subrL (leq_trans _ l_p).
have IH' := IH (ltnW l_p); move: lt; have e : (p - l)%N = (p - l.+1).+1 by rewrite -subSn.
rewrite e in IH'; move: (p - l.+1)%N IH' => j IH' lt {e IH l l_p}.
rewrite {1}/distance big_ltn // -/(distance p frozen_length j.+1) IH' /frozen_length.
have split_ a : (a < n)%N -> distance n L a = L a + distance n L a.+1 by move=> a_n; rewrite /distance big_ltn.
have i_p : (i <= p)%N by rewrite -ltnS ltn_ord.
rewrite /bump; case: (ltngtP j.+1 i) => h.
- by rewrite (leqNgt i j) (ltn_trans (ltnSn j) h) /= !add0n addr0 [RHS]split_ // ltnS ltnW.
- by rewrite -[(i <= j)%N]ltnS h /= addr0 !add1n [RHS]split_.
rewrite -h ltnn /= add0n add1n [RHS]split_ ?ltnS ?(ltnW lt) //.
by rewrite [distance n L j.+1]split_ ?addrA ?ltnS.
Qed.

Definition still : 'M[R]_(n, p) := \matrix_(a, b) (a == lift i b)%:R.

Lemma still_sandwich (X : 'M[R]_n) : still^T *m X *m still = \matrix_(a, b) X (lift i a) (lift i b).
Proof.
have right r (Y : 'M[R]_(r, n)) a b : (Y *m still) a b = Y a (lift i b).
  rewrite mxE (bigD1 (lift i b)) //= mxE eqxx mulr1 big1 ?addr0 // => j /negPf j_b.
  by rewrite mxE j_b mulr0.
apply/matrixP=> a b; rewrite [RHS]mxE right mxE (bigD1 (lift i a)) //= !mxE eqxx mul1r big1 ?addr0 // => j /negPf j_a.
by rewrite !mxE j_a mul0r.
Qed.

Lemma frozen_energy F (q : 'cV[R]_p) : second_variation L k F (still *m q) = second_variation frozen_length frozen_stiffness F q.
Proof.
have e : still^T *m (Kq n k - F *: M n L) *m still = Kq p frozen_stiffness - F *: M p frozen_length.
  rewrite still_sandwich; apply/matrixP=> a b; rewrite !mxE !opprK frozen_distance ?geq_max ?(ltnW (ltn_ord _)) //.
  rewrite (inj_eq (@lift_inj _ i)); congr (_ - F * distance _ _ _).
  by rewrite /=; case: (leqP a b) => [ab|/ltnW ab]; [apply/maxn_idPr|apply/maxn_idPl]; rewrite leq_bump2.
by rewrite /second_variation trmx_mul -e !mulmxA.
Qed.

Lemma frozen_axis : (S0 p frozen_length)^T = (S0 n L)^T *m still.
Proof.
apply/rowP=> a; rewrite !mxE frozen_distance ?(ltnW (ltn_ord a)) // (bigD1 (lift i a)) //= !mxE eqxx mulr1 big1 ?addr0 //.
by move=> j /negPf j_a; rewrite !mxE j_a mulr0.
Qed.

Lemma still_back (q : 'cV[R]_n) : q i 0 = 0 -> still *m (still^T *m q) = q.
Proof.
move=> qi; apply/colP=> a; rewrite mxE.
have at_ b : (still^T *m q) b 0 = q (lift i b) 0.
  by rewrite mxE (bigD1 (lift i b)) //= !mxE eqxx mul1r big1 ?addr0 // => j /negPf j_b; rewrite !mxE j_b mul0r.
case: (unliftP i a) => [b ->|->]; last first.
  by rewrite qi big1 // => b _; rewrite mxE (negPf (neq_lift i b)) mul0r.
rewrite (bigD1 b) //= at_ mxE eqxx mul1r big1 ?addr0 // => j j_b.
by rewrite mxE (inj_eq (@lift_inj _ i)) eq_sym (negPf j_b) mul0r.
Qed.

Hypotheses (three : (1 < p)%N) (links : chain_of_links n L k) (one : at_most_one_passive n k).

Let bump_lt j : (j < p)%N -> (bump i j < n)%N.
Proof. by move=> j_p; apply: (ltn_ord (lift i (Ordinal j_p))). Qed.

Lemma frozen_links : chain_of_links p frozen_length frozen_stiffness.
Proof.
have [pos k0] := links; split=> j j_p; last by apply/k0/bump_lt.
rewrite /frozen_length ltr_paddr ?pos ?bump_lt //; case: ifP => // _.
by rewrite ltW ?pos ?ltn_ord.
Qed.

Lemma frozen_one : at_most_one_passive p frozen_stiffness.
Proof.
move=> a b a_p b_p ka kb; have := one (bump_lt a_p) (bump_lt b_p) ka kb.
exact: (can_inj (@bumpK i)).
Qed.

Theorem frozen_interlaced fs ys m : roots_of (D n L k) fs -> roots_of (D p frozen_length frozen_stiffness) ys ->
  (m < p.-1)%N -> fs`_m <= ys`_m <= fs`_m.+1.
Proof.
move=> rfs rys m_p; have two : (1 < n)%N by apply: ltnW.
have p0 : (0 < p)%N by apply: ltnW.
apply/andP; split.
  rewrite -[X in _ <= ys`_X]addn0.
  apply: (forces_compared two links one three frozen_links frozen_one (X := still) (Z := [::])) => //.
  - by move=> F q _ axis _; rewrite mulmxA -frozen_axis axis frozen_energy.
  - by rewrite /= (leq_trans m_p) // leq_pred.
  by rewrite addn0.
rewrite -addn1.
apply: (forces_compared three frozen_links frozen_one two links one (X := still^T) (Z := [:: delta_mx 0 i])) => //.
  move=> F q _ axis zero; have qi : q i 0 = 0.
    have /matrixP/(_ 0 0) := zero _ (mem_head _ _).
    by rewrite -rowE !mxE.
  by rewrite -frozen_energy still_back // frozen_axis -mulmxA still_back // axis.
by rewrite addn1 /= -[m.+1]add1n -ltn_subRL subn1.
Qed.

End Frozen.
(* (c) The last link cut off, with its joint. *)
Section CutOff.

Variables (R : rcfType) (p : nat) (L k : nat -> R).
Let n := p.+1.
Hypotheses (three : (1 < p)%N) (links : chain_of_links n L k) (one : at_most_one_passive n k).

Let two : (1 < n)%N. Proof. exact: ltnW. Qed.
Let p0 : (0 < p)%N. Proof. exact: ltnW. Qed.

Lemma short_links : chain_of_links p L k.
Proof. by have [a b] := links; split=> j /leqW; [apply: a | apply: b]. Qed.
Lemma short_one : at_most_one_passive p k.
Proof. by move=> a b /leqW a_n /leqW; apply: one. Qed.

(* The chain's orientations, and both forms by them. *)
Let turned (f : nat -> R) j := \sum_(0 <= l < j.+1) f l.
Let turnedS f j : turned f j.+1 = turned f j + f j.+1. Proof. by rewrite /turned big_nat_recr. Qed.
Let col r (f : nat -> R) : 'cV[R]_r := \col_i f i.

Let axis_sum r f : (S0 r L)^T *m col r f = (\sum_(0 <= j < r) L j * turned f j)%:M.
Proof.
rewrite [LHS]mx11_scalar; congr (_%:M); rewrite mxE.
have -> : \sum_j (S0 r L)^T 0 j * col r f j 0 = \sum_(i < r) \sum_(j < r) L j * f i *+ (i <= j)%N.
  apply: eq_bigr => i _; rewrite !mxE distance_ord mulr_suml.
  by apply: eq_bigr => j _; rewrite mulrnAl.
rewrite exchange_big big_mkord; apply: eq_bigr => j _.
rewrite /turned (big_nat_widen _ _ r) ?ltn_ord // big_mkord mulr_sumr [RHS]big_mkcond.
by apply: eq_bigr => i _; rewrite ltnS; case: (i <= j)%N.
Qed.

Let energy_sum r F f : second_variation L k F (col r f) =
  \sum_(0 <= j < r) k j * f j ^+ 2 - F * \sum_(0 <= j < r) L j * turned f j ^+ 2.
Proof.
rewrite second_variationE strain_sum; congr (_ - F * _).
by rewrite big_mkord; apply: eq_bigr => j _; rewrite theta_sum.
Qed.

Let scalar0 (x : R) : x = 0 <-> x%:M = 0 :> 'M_1.
Proof. by split=> [->|/matrixP/(_ 0 0)]; [rewrite raddf0 | rewrite !mxE eqxx mulr1n]. Qed.

(* The last link in line with the chain; the chain without it. *)
Let append : 'M[R]_(n, p) := \matrix_(i, j) (val i == val j)%:R.
Let drop : 'M[R]_(p, n) := \matrix_(i, j) (val i == val j)%:R.
Let row_last r : 'rV[R]_r := const_mx 1.

Let appended f j := if (j < p)%N then f j else 0 : R.

Let appendE f : append *m col p f = col n (appended f).
Proof.
apply/colP=> i; rewrite !mxE /appended; case: ltnP => i_p.
  rewrite (bigD1 (Ordinal i_p)) //= !mxE eqxx mul1r big1 ?addr0 // => j; rewrite -val_eqE /= eq_sym => /negPf h.
  by rewrite !mxE h mul0r.
by rewrite big1 // => j _; rewrite !mxE gtn_eqF ?mul0r // (leq_trans (ltn_ord j)).
Qed.

Let dropE f : drop *m col n f = col p f.
Proof.
apply/colP=> i; have i_n : (i < n)%N by apply: leqW.
rewrite !mxE (bigD1 (Ordinal i_n)) //= !mxE eqxx mul1r big1 ?addr0 // => j; rewrite -val_eqE /= eq_sym => /negPf h.
by rewrite !mxE h mul0r.
Qed.

Let row_lastE r f : (0 < r)%N -> row_last r *m col r f = (turned f r.-1)%:M.
Proof.
move=> r0; rewrite [LHS]mx11_scalar /turned prednK // big_mkord; congr (_%:M); rewrite mxE.
by apply: eq_bigr => i _; rewrite !mxE mul1r.
Qed.

Let turned_appended f j : (j < p)%N -> turned (appended f) j = turned f j.
Proof.
move=> j_p; apply: eq_big_nat => l /andP [_ l_j]; rewrite /appended (leq_trans l_j) //.
Qed.

Let pE : p.-1.+1 = p. Proof. exact: prednK. Qed.

(* C_m <= F_(m+1) and F_m <= C_(m+1), on any base. *)
Theorem cut_interlaced fs cs m : roots_of (D n L k) fs -> roots_of (D p L k) cs -> (m < p.-1)%N ->
  cs`_m <= fs`_m.+1 /\ ((m.+1 < p.-1)%N -> fs`_m <= cs`_m.+1).
Proof.
move=> rfs rcs m_p; split=> [|m_p1]; rewrite -addn1.
  apply: (forces_compared three short_links short_one two links one (X := drop) (Z := [:: row_last n])) => //.
    move=> F q _; have [f ->] := as_function q; rewrite -/(col n f) axis_sum => /scalar0 axis line.
    have tp : turned f p = 0 by apply/scalar0; rewrite -(@row_lastE n) //; apply: line; rewrite inE.
    move: axis; rewrite dropE axis_sum !energy_sum /n !(big_nat_recr p) //= tp expr0n !mulr0 !addr0 => axis.
    split; first exact/scalar0.
    rewrite ler_add2r ler_addl mulr_ge0 ?sqr_ge0 //; have [_] := links; apply.
    exact: ltnSn.
  by rewrite addn1 /= -[m.+1]add1n -ltn_subRL subn1.
apply: (forces_compared two links one three short_links short_one (X := append) (Z := [:: row_last p])) => //.
- move=> F q _; have [f ->] := as_function q; rewrite -/(col p f) axis_sum => /scalar0 axis line.
  have tp : turned f p.-1 = 0 by apply/scalar0; rewrite -row_lastE //; apply: line; rewrite inE.
  have last_ : turned (appended f) p = 0.
    by rewrite -pE turnedS pE turned_appended ?tp ?add0r ?/appended ?ltnn // -[X in (_ < X)%N]pE.
  rewrite appendE axis_sum !energy_sum /n !(big_nat_recr p) //= last_ expr0n !mulr0 !addr0.
  split.
    apply/scalar0; rewrite -[RHS]axis; apply: eq_big_nat => j /andP [_ j_p].
    by rewrite turned_appended.
  rewrite /appended ltnn expr0n mulr0 addr0 le_eqVlt; apply/orP; left; apply/eqP; congr (_ - F * _).
    by apply: eq_big_nat => j /andP [_ ->].
  by apply: eq_big_nat => j /andP [_ j_p]; rewrite turned_appended.
- exact: leq_trans m_p (leq_pred _).
by rewrite addn1.
Qed.

(* On a passive base even F_m <= C_m. *)
Theorem cut_passive_base fs cs m : k 0%N = 0 -> roots_of (D n L k) fs -> roots_of (D p L k) cs -> (m < p.-1)%N ->
  fs`_m <= cs`_m.
Proof.
move=> k0 rfs rcs m_p; rewrite -[X in _ <= cs`_X]addn0.
pose Lz := L p / distance n L 0.
have z0 : 0 < distance n L 0 by apply: (distance_gt0 links).
pose X := append - Lz *: delta_mx ord0 0 *m row_last p.
apply: (forces_compared two links one three short_links short_one (X := X) (Z := [::])) => //.
- move=> F q F0; have [f ->] := as_function q; rewrite -/(col p f) axis_sum => /scalar0 axis _.
  have sum_q := row_lastE f p0.
  pose d := Lz * turned f p.-1; pose g j := if j is 0 then f 0%N - d else appended f j.
  have Xq : X *m col p f = col n g.
    rewrite mulmxBl appendE -mulmxA sum_q mul_mx_scalar scalerA mulrC.
    by apply/colP=> -[[|i] h]; rewrite !mxE /= ?p0 ?mulr1 ?mulr0 ?subr0 // /appended p0.
  have tg j : (j < p)%N -> turned g j = turned f j - d.
    elim: j => [|j IH] j_p; first by rewrite /turned !big_nat1.
    by rewrite !turnedS IH ?(ltnW j_p) //= /appended j_p addrAC.
  have gp : g p = 0 by rewrite -pE /= /appended pE ltnn.
  have tgp : turned g p = turned f p.-1 - d.
    have p_p : (p.-1 < p)%N by rewrite ltn_predL.
    by have := turnedS g p.-1; rewrite pE gp addr0 [turned g p.-1]tg.
  have zE : distance n L 0 = \sum_(0 <= j < p) L j + L p by rewrite /distance big_nat_recr.
  have dE : distance n L 0 * d = L p * turned f p.-1.
    by rewrite /d /Lz mulrA [_ * (L p / _)]mulrCA mulfV ?mulr1 // gt_eqF.
  have dt : d = Lz * turned f p.-1 by [].
  rewrite Xq axis_sum !energy_sum /n !(big_nat_recr p) //= tgp; clearbody d.
  rewrite (eq_big_nat _ _ (F2 := fun j => L j * turned f j - L j * d)); last first.
    by move=> j /andP [_ j_p]; rewrite tg // mulrBr.
  rewrite sumrB axis sub0r -mulr_suml; split.
    by apply/scalar0; rewrite mulrBr -dE zE mulrDl addrK addNr.
  rewrite (eq_big_nat _ _ (F1 := fun j => L j * turned g j ^+ 2)
    (F2 := fun j => L j * turned f j ^+ 2 - (2%:R * d * (L j * turned f j) - d ^+ 2 * L j))); last first.
    by move=> j /andP [_ j_p]; rewrite tg //; ring.
  rewrite sumrB sumrB -!mulr_sumr axis mulr0 sub0r opprK.
  rewrite gp expr0n mulr0 addr0.
  have -> : \sum_(0 <= i < p) k i * g i ^+ 2 = \sum_(0 <= i < p) k i * f i ^+ 2.
    apply: eq_big_nat => -[|i] /andP [_ i_p] /=; first by rewrite k0 !mul0r.
    by rewrite /appended i_p.
  rewrite ler_add2l ler_opp2 ler_pmul2l // -addrA ler_addl.
  have Lp : 0 < L p by have [+ _] := links; apply.
  have -> : d ^+ 2 * (\sum_(0 <= i < p) L i) + L p * (turned f p.-1 - d) ^+ 2 =
      d * (distance n L 0 * d) - 2%:R * d * (L p * turned f p.-1) + L p * turned f p.-1 ^+ 2 by rewrite zE; ring.
  rewrite dE (_ : _ + _ = turned f p.-1 * (L p * turned f p.-1 - L p * d)); last by ring.
  rewrite -dE -mulrBl dt zE addrK mulrCA mulr_ge0 //.
    by rewrite big_nat; apply: sumr_ge0 => j /andP [_ j_p]; apply: ltW; have [+ _] := links; apply; apply: leqW.
  by rewrite mulrCA mulr_ge0 -?expr2 ?sqr_ge0 // divr_ge0 // -?zE ltW.
- exact: leq_trans m_p (leq_pred _).
by rewrite addn0.
Qed.

End CutOff.
