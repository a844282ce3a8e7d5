(* Stability of the straight chain, "Spring and mass" and "Stable below the lowest force" of theorems.md: its quadratic
   energy along the string of beads as a sum of squares; under the constraint positive exactly below the lowest critical
   force. *)
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp Require Import polyrcf.
From mathcomp Require Import ring.
Require Import chain determinant string recursion forces definite modes.

Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Import Order.TTheory GRing.Theory Num.Theory.
Local Open Scope ring_scope.

(* The energy along the string: springs k_i q_i^2, beads -F m_i s_i^2. *)
Section Along.

Variables (R : rcfType) (z k q s : nat -> R) (F : R) (m : nat).
Hypotheses (dz : distances m z) (s0 : s 0%N = 0) (sS : forall i, (i <= m)%N -> s i.+1 = s i + z i * q i).

Definition energy j : R := \sum_(i < j.+1) k i * q i ^+ 2 - F * \sum_(i < j) bead z i * s i.+1 ^+ 2.

(* Springs in series: what is left of the energy when the deflection s_j is given. *)
Definition least j : R := k j * (G z k j).[F] / (H z k j).[F] * s j.+1 ^+ 2.

(* What is squared at the link from joint j on. *)
Definition part j : R := (G z k j.+1).[F] * s j.+1 - k j.+1 / z j.+1 * (H z k j).[F] * q j.+1.
Definition weight j : R := z j.+1 ^+ 2 / ((H z k j).[F] * (H z k j.+1).[F]).

Lemma energyS j : energy j.+1 = energy j + k j.+1 * q j.+1 ^+ 2 - F * bead z j * s j.+1 ^+ 2.
Proof. by rewrite /energy big_ord_recr [\sum_(i < j.+1) bead _ _ * _]big_ord_recr /=; ring. Qed.

Theorem energy_squares j : (j <= m)%N -> (forall i, (i <= j)%N -> (H z k i).[F] != 0) ->
  energy j = least j + \sum_(i < j) weight i * part i ^+ 2.
Proof.
elim: j => [|j IH] j_m nz.
  rewrite /energy /least !big_ord0 mulr0 subr0 addr0 big_ord1 /= !hornerC sS // s0 add0r mulr1.
  have z0 : 0 < z 0%N by have [->] := dz.
  by field; rewrite gt_eqF.
have zj : z j.+1 != 0 by rewrite gt_eqF //; have [->] := dz.
have hj := nz j (leqnSn j); have hj1 := nz j.+1 (leqnn _); have HE := H_at z k j F.
rewrite energyS IH ?(ltnW j_m) // => [|i i_j]; last by apply: nz; apply: leqW.
rewrite big_ord_recr /=; move: (\sum_(_ < j) _) => squares.
suff e : least j + k j.+1 * q j.+1 ^+ 2 - F * bead z j * s j.+1 ^+ 2 = least j.+1 + weight j * part j ^+ 2.
  by transitivity (squares + (least j + k j.+1 * q j.+1 ^+ 2 - F * bead z j * s j.+1 ^+ 2)); [ring | rewrite e; ring].
rewrite /least /weight /part [s j.+2]sS //.
set h := (H z k j).[F] in hj HE *; set h1 := (H z k j.+1).[F] in hj1 HE *.
set g1 := (G z k j.+1).[F] in HE *; set a := s j.+1; set b := q j.+1.
have -> : k j * (G z k j).[F] = g1 + F * bead z j * h by rewrite /g1 G_at /h; ring.
have h1E : h1 = k j.+1 * h + z j.+1 ^+ 2 * g1 by [].
move: hj1; rewrite h1E; move: (k j.+1) (z j.+1) zj hj => kk zz zj hj nz1; field.
by rewrite nz1 zj hj.
Qed.

Lemma energy_least j : (j <= m)%N -> (forall i, (i <= j)%N -> 0 < (H z k i).[F]) -> least j <= energy j.
Proof.
move=> j_m Hp; rewrite energy_squares // => [|i /Hp /gt_eqF -> //].
rewrite ler_addl; apply: sumr_ge0 => i _; rewrite mulr_ge0 ?sqr_ge0 // divr_ge0 ?sqr_ge0 // mulr_ge0 // ltW //.
  by rewrite Hp // ltnW.
by rewrite Hp.
Qed.

End Along.

(* The deflections of the recursion are positive below the lowest force. *)
Section Positive.

Variable R : rcfType.
Implicit Types (z k : nat -> R) (F a : R) (m : nat).

Lemma changes_mono z k F i j : (i <= j)%N -> (changes z k F i <= changes z k F j)%N.
Proof.
elim: j => [|j IH]; first by rewrite leqn0 => /eqP ->.
rewrite leq_eqVlt => /orP [/eqP -> //|]; rewrite ltnS => /IH {IH} h; apply: leq_trans h _.
by rewrite /changes /=; case: (sweep z k F j) => c b /=; apply: leq_addr.
Qed.

Lemma no_changes z k F j : changes z k F j = 0%N ->
  (sweep z k F j).2 = false /\ forall i, (i <= j)%N -> 0 <= (H z k i).[F].
Proof.
rewrite /changes; elim: j => [|j]; first by move=> _; split=> // i; rewrite leqn0 => /eqP ->; rewrite hornerC sqr_ge0.
rewrite /=; case: (sweep z k F j) => c b /= IH; set now := if _ then _ else _ => /eqP.
rewrite addn_eq0 eqb0 negbK => /andP [/eqP/IH [b0 h] /eqP]; rewrite {}b0 => nowE; split=> // i.
rewrite leq_eqVlt => /orP [/eqP ->|]; last by rewrite ltnS => /h.
by move: nowE; rewrite /now; case: eqP => [-> //|_ /negbT]; rewrite -leNgt.
Qed.

Lemma positive z k m xs F a : distances m z -> 0 <= k 0%N -> (forall i, (0 < i < m)%N -> 0 < k i) ->
  string_forces z k m xs -> F < a -> changes z k a m = 0%N -> forall i, (i <= m)%N -> 0 < (H z k i).[F].
Proof.
move=> dz k0 kp sf F_a ca.
have none f : f \in xs -> a <= f.
  move=> f_xs; move: ca; rewrite (string_changes sf) => /eqP; rewrite -leqn0 leqNgt -has_count => /hasPn /(_ f f_xs).
  by rewrite -leNgt.
have cF : changes z k F m = 0%N.
  rewrite (string_changes sf); apply/eqP; rewrite -leqn0 leqNgt -has_count; apply/hasPn => f /none a_f.
  by rewrite -leNgt ltW // (lt_le_trans F_a).
have [_ ge0] := no_changes cF.
move=> i i_m; rewrite lt0r ge0 // andbT; apply/negP => root0.
move: i_m; rewrite leq_eqVlt => /orP [/eqP im|i_m].
  have : F \in xs by rewrite -(roots_of_root F (string_roots_of sf)) -im.
  by move/none; rewrite leNgt F_a.
have [|x sx] := elastic_roots (z := z) (k := k) dz (ltnW i_m) k0.
  by move=> l /andP [l0 l_i]; rewrite kp // l0 (leq_ltn_trans l_i).
have : root (H z k i) F by [].
rewrite (splits_root _ (roots_split sx)) => /existsP [l /eqP xl].
have := changes_mono z k a (ltnW i_m); rewrite ca leqn0 /changes (roots_count sx) /= /below => /eqP/eqP.
by rewrite sum_nat_eq0 => /forallP /(_ l); rewrite xl F_a.
Qed.

End Positive.

(* Angles of a chain as a function, deflections s_i before joint i. *)
Section Energies.

Variables (R : realFieldType) (n : nat) (L k f : nat -> R).
Hypotheses (pos : forall i, (i < n)%N -> 0 < L i).
Let z := distance n L.
Let v : 'cV[R]_n := \col_i f i.

Definition deflection (i : nat) : R := \sum_(0 <= j < i) z j * f j.

Lemma deflection0 : deflection 0 = 0. Proof. by rewrite /deflection big_geq. Qed.
Lemma deflectionS i : deflection i.+1 = deflection i + z i * f i.
Proof. by rewrite /deflection big_nat_recr. Qed.

Lemma on_axis : (S0 n L)^T *m v = 0 <-> deflection n = 0.
Proof.
have e : ((S0 n L)^T *m v) 0 0 = deflection n.
  by rewrite mxE /deflection big_mkord; apply: eq_bigr => i _; rewrite !mxE.
by split=> [h|h]; [rewrite -e h mxE | apply/matrixP=> i j; rewrite !ord1 e h mxE].
Qed.

Lemma strain_sum : strain k v = \sum_(0 <= i < n) k i * f i ^+ 2.
Proof. by rewrite big_mkord; apply: eq_bigr => i _; rewrite mxE. Qed.

Lemma theta_sum j : (j < n)%N -> theta v j = \sum_(0 <= i < j.+1) f i.
Proof.
move=> j_n; rewrite /theta [RHS](big_nat_widen _ _ n) // big_mkord.
by apply: eq_big => [i|i _]; rewrite ?mxE // ltnS.
Qed.

Let zE i : (i < n)%N -> L i = z i - z i.+1.
Proof. by move=> i_n; rewrite /z /distance [X in X - _]big_ltn // addrK. Qed.
Let z_neq0 i : (i < n)%N -> z i != 0.
Proof. by move=> i_n; rewrite gt_eqF // /z distance_pos. Qed.

Lemma beads_and_links j : (j < n)%N ->
  \sum_(0 <= i < j) bead z i * deflection i.+1 ^+ 2 - \sum_(0 <= i < j) L i * (\sum_(0 <= l < i.+1) f l) ^+ 2 =
  (deflection j - z j * \sum_(0 <= l < j) f l) ^+ 2 / z j.
Proof.
elim: j => [|j IH] j_n.
  by rewrite !big_geq // deflection0 mulr0 subr0 expr0n mul0r.
rewrite !(big_nat_recr j) //= opprD addrACA IH 1?ltnW // deflectionS zE 1?ltnW // /bead.
move: (deflection j) (\sum_(_ <= _ < j) _) => d t.
by field; rewrite !z_neq0 // ltnW.
Qed.

(* The chain's shortening is that of beads at the joints. *)
Theorem spring_and_mass : (0 < n)%N -> deflection n = 0 ->
  shortening L v = \sum_(0 <= i < n.-1) bead z i * deflection i.+1 ^+ 2.
Proof.
move=> n0 dn; have m_n : (n.-1 < n)%N by rewrite ltn_predL.
have := beads_and_links m_n; move/eqP; rewrite subr_eq => /eqP ->.
have -> : shortening L v = \sum_(0 <= i < n) L i * (\sum_(0 <= l < i.+1) f l) ^+ 2.
  by rewrite big_mkord; apply: eq_bigr => j _; rewrite theta_sum.
rewrite -[X in \sum_(0 <= _ < X) _](prednK n0) big_nat_recr //= addrC; congr (_ + _).
have zn : z n.-1.+1 = 0 by rewrite prednK // /z /distance big_geq.
have := dn; rewrite -{1}(prednK n0) deflectionS => /eqP; rewrite addr_eq0 => /eqP ->.
rewrite zE // zn big_nat_recr //=; move: (\sum_(_ <= _ < _) _) => t.
by field; rewrite z_neq0.
Qed.

End Energies.

(* Stable exactly below the lowest critical force. *)
Section Stability.

Variables (R : rcfType) (n : nat) (L k : nat -> R).
Hypotheses (two : (1 < n)%N) (links : chain_of_links n L k) (one : at_most_one_passive n k).
Let z := distance n L.

Let pos i : (i < n)%N -> 0 < L i. Proof. by have [h _] := links; apply: h. Qed.
Let n0 : (0 < n)%N. Proof. exact: ltnW. Qed.

(* Both strings: the second begins behind the first interior passive joint, and is empty where there is none. *)
Let c := cut n k.
Let m := (n.-1 - c)%N.
Definition angles_behind (f : nat -> R) i := if i is i'.+1 then f (c + i'.+1)%N else deflection n L f c.+1 / z c.
Definition deflections_behind (f : nat -> R) i := if i is i'.+1 then deflection n L f (c + i'.+1)%N else 0.

Let c_le : (c <= n.-1)%N. Proof. exact: (@cut_le R n k two). Qed.
Let cm : (c + m)%N = n.-1. Proof. exact: subnKC. Qed.
Let nE : n.-1.+1 = n. Proof. exact: prednK. Qed.
Let zc : z c != 0. Proof. by rewrite gt_eqF // /z distance_pos // -[X in (_ < X)%N]nE ltnS. Qed.

Lemma deflections_behindS f i : (i <= m)%N ->
  deflections_behind f i.+1 = deflections_behind f i + from c z i * angles_behind f i.
Proof.
case: i => [|i] _; rewrite /deflections_behind /angles_behind /from; first by rewrite addn0 addn1 add0r mulrC divfK.
by rewrite [(c + i.+2)%N]addnS deflectionS.
Qed.

(* The first string ends at a passive joint, or at the end point. *)
Lemma at_cut f : deflection n L f n = 0 -> k c * deflection n L f c.+1 = 0.
Proof.
move=> fn; case: (ltngtP c n.-1) c_le => // [h _|-> _]; last by rewrite nE fn mulr0.
by rewrite /c cut_passive // mul0r.
Qed.

Lemma energy_of_strings f F : deflection n L f n = 0 ->
  \sum_(0 <= i < n) k i * f i ^+ 2 - F * (\sum_(0 <= i < n.-1) bead z i * deflection n L f i.+1 ^+ 2) =
  energy z k f (deflection n L f) F c + energy (from c z) (from c k) (angles_behind f) (deflections_behind f) F m.
Proof.
move=> fn; set s := deflection n L f.
have A : \sum_(c.+1 <= i < n) k i * f i ^+ 2 = \sum_(i < m.+1) from c k i * angles_behind f i ^+ 2.
  rewrite big_ord_recl {1}/from addn0 /angles_behind expr_div_n expr2 !mulrA at_cut // !mul0r add0r.
  rewrite -{1}[c.+1]add0n big_addn.
  have -> : (n - c.+1)%N = m by rewrite /m -subn1 -subnDA add1n.
  by rewrite big_mkord; apply: eq_bigr => i _; rewrite lift0 /from /= addnC addSnnS.
have B : \sum_(c <= i < n.-1) bead z i * s i.+1 ^+ 2 = \sum_(i < m) bead (from c z) i * deflections_behind f i.+1 ^+ 2.
  rewrite -{1}[c]add0n big_addn -/m big_mkord; apply: eq_bigr => i _.
  by rewrite /bead /from /deflections_behind addnS [(i + c)%N]addnC.
have c_n : (c.+1 <= n)%N by rewrite -[X in (_ < X)%N]nE ltnS.
rewrite /energy -A -B (@big_cat_nat _ _ _ c.+1 0 n) //= (@big_cat_nat _ _ _ c 0 n.-1) //= !big_mkord.
by move: (\sum_(i < c.+1) _) (\sum_(c.+1 <= i < n) _) (\sum_(i < c) _) (\sum_(c <= i < n.-1) _) => *; ring.
Qed.

(* Nothing is left of the energy at the ends of the strings. *)
Lemma least_first f F : deflection n L f n = 0 -> least z k (deflection n L f) F c = 0.
Proof.
move=> /at_cut; rewrite /least; move: (deflection n L f c.+1) ((G z k c).[F]) ((H z k c).[F]) => s g h ks.
by transitivity (k c * s * (g / h * s)); [ring | rewrite ks mul0r].
Qed.

Lemma least_second f F : deflection n L f n = 0 -> least (from c z) (from c k) (deflections_behind f) F m = 0.
Proof. by move=> fn; rewrite /least /= addnS cm nE fn expr0n mulr0. Qed.

Lemma first_distances : distances c z.
Proof. by have [a b] := chain_distances two links; split=> i h; [apply: a|apply: b]; apply: leq_trans h c_le. Qed.

Lemma second_distances : distances m (from c z).
Proof. by apply: distances_from => //; rewrite cm. Qed.

Lemma second_elastic i : (0 < i <= m)%N -> 0 < from c k i.
Proof.
move=> i_m; apply: (elastic_behind two links one) => //.
by rewrite -subn_gt0; case/andP: i_m; apply: leq_trans.
Qed.

Lemma energy_ge0 (f : nat -> R) (F a : R) : deflection n L f n = 0 -> F < a -> count_below n L k a = 0%N ->
  F * (\sum_(0 <= i < n.-1) bead z i * deflection n L f i.+1 ^+ 2) <= \sum_(0 <= i < n) k i * f i ^+ 2.
Proof.
move=> fn F_a; rewrite /count_below => /eqP; rewrite addn_eq0 => /andP [/eqP c1 /eqP c2].
rewrite -subr_ge0 energy_of_strings //; apply: addr_ge0.
  have [xs sx] := first_string two links one.
  have Hp := positive first_distances (stiffness_ge0 links n0) (elastic_before two links) sx F_a c1.
  by rewrite -(least_first F fn); apply: (energy_least first_distances (deflection0 _ _ _) (fun i _ => deflectionS _ _ _ i)).
have [ys sy] := second_string two links one.
have k0 : 0 <= from c k 0 by rewrite /from addn0 (stiffness_ge0 links) // -[X in (_ < X)%N]nE ltnS.
have kp i : (0 < i < m)%N -> 0 < from c k i by case/andP=> i0 i_m; rewrite second_elastic // i0 ltnW.
have Hp := positive second_distances k0 kp sy F_a c2.
by rewrite -(least_second F fn); apply: (energy_least second_distances (erefl _) (deflections_behindS f)).
Qed.

Lemma as_function (q : 'cV[R]_n) : exists f : nat -> R, q = \col_(i < n) f i.
Proof. by exists (fun i => oapp (fun o : 'I_n => q o 0) 0 (insub i)); apply/colP => i; rewrite mxE valK. Qed.

Lemma constrained_ge0 (F a : R) q : (S0 n L)^T *m q = 0 -> F < a -> count_below n L k a = 0%N ->
  F * shortening L q <= strain k q.
Proof.
have [f ->] := as_function q; move/on_axis => fn F_a ca.
by rewrite spring_and_mass // strain_sum; apply: energy_ge0 ca.
Qed.

(* The second variation of the potential at the straight chain, the quadratic energy. *)
Definition second_variation F (q : 'cV[R]_n) : R := (q^T *m (Kq n k - F *: M n L) *m q) 0 0.

Lemma second_variationE F q : second_variation F q = strain k q - F * shortening L q.
Proof.
rewrite /second_variation mulmxBr mulmxBl -scalemxAr -scalemxAl mxE stiffness_form.
by rewrite [X in _ + X]mxE [X in _ - X]mxE moment_form.
Qed.

Lemma shortening_gt0 (q : 'cV[R]_n) : q != 0 -> 0 < shortening L q.
Proof. by move=> q0; rewrite -moment_form; apply: M_definite. Qed.

(* Below the lowest force there is room: a larger force that is below it too. *)
Lemma room_below fs F : roots_of (D n L k) fs -> all (fun f => F < f) fs ->
  exists2 F' : R, F < F' & forall q, (S0 n L)^T *m q = 0 -> F' * shortening L q <= strain k q.
Proof.
move=> rfs below; have [gs [rgs sz pgs cgs]] := critical_forces two links one.
have fg := roots_of_inj rfs rgs; rewrite -{gs rgs pgs}fg in sz cgs.
have [sorted_fs _] := rfs; case: fs sz sorted_fs below cgs {rfs} => [|a fs] sz sorted_fs below cgs.
  by move: two; rewrite -subn_gt0 subn1 -sz.
move: below => /= /andP [F_a _].
have ca : count_below n L k a = 0%N.
  rewrite cgs; apply/eqP; rewrite -leqn0 leqNgt -has_count; apply/hasPn => f; rewrite -leNgt inE.
  by case/orP => [/eqP -> //|]; move: f; apply/allP; apply: order_path_min sorted_fs; apply: le_trans.
have [h1 h2] := midf_lt F_a.
by exists ((F + a) / 2%:R) => // q axis; apply: constrained_ge0 axis h2 ca.
Qed.

Theorem stable_below fs F q : roots_of (D n L k) fs -> all (fun f => F < f) fs ->
  q != 0 -> (S0 n L)^T *m q = 0 -> 0 < second_variation F q.
Proof.
move=> rfs below q0 axis; have [F' F_F' room] := room_below rfs below.
rewrite second_variationE subr_gt0; apply: lt_le_trans (room q axis).
by rewrite ltr_pmul2r // shortening_gt0.
Qed.

(* Along the mode of a critical force f the energy falls by f - F. *)
Lemma along_mode fs f F : roots_of (D n L k) fs -> f \in fs -> exists q,
  [/\ q != 0, (S0 n L)^T *m q = 0 & second_variation F q = (f - F) * shortening L q].
Proof.
move=> rfs f_fs; have : critical n L k f by apply/(critical_root _ n0 pos); rewrite (roots_of_root f rfs).
case=> q [Fy mq]; exists q; have [q0 _ axis] := mq; split=> //.
rewrite second_variationE mulrBl; congr (_ - _).
by rewrite {1}(energy_factor pos mq) divfK // gt_eqF // shortening_gt0.
Qed.

Theorem unstable_above fs f F : roots_of (D n L k) fs -> f \in fs -> f < F -> exists q,
  [/\ q != 0, (S0 n L)^T *m q = 0 & second_variation F q < 0].
Proof.
move=> rfs f_fs f_F; have [q [q0 axis e]] := along_mode F rfs f_fs; exists q; split=> //.
by rewrite e nmulr_rlt0 ?subr_lt0 // shortening_gt0.
Qed.

(* A strict minimum under the constraint exactly below the lowest force: not at it either. *)
Theorem stable_exactly_below fs F : roots_of (D n L k) fs ->
  (forall q, q != 0 -> (S0 n L)^T *m q = 0 -> 0 < second_variation F q) <-> all (fun f => F < f) fs.
Proof.
move=> rfs; split=> [h|below q]; last exact: stable_below below.
apply/allP => f f_fs; have [q [q0 axis e]] := along_mode F rfs f_fs.
by have := h q q0 axis; rewrite e pmulr_lgt0 ?subr_gt0 // shortening_gt0.
Qed.

End Stability.
