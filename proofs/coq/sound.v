(* What the checker accepts is true of the real chain, over any real closed field. *)
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp Require Import polyrcf.
From mathcomp Require Import zify ssrZ ring.
From Coq Require Import ZArith.
Delimit Scope nat_scope with N.
Require Import chain determinant string recursion forces definite modes eigenvalues integers.
Require checker.

Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Import Order.TTheory GRing.Theory Num.Theory.
Local Open Scope ring_scope.

Lemma below_to_nat (a : nat) (b m : Z) : Z.of_nat a = b -> (b <? m)%Z -> (a < Z.to_nat m)%N.
Proof. by lia. Qed.
Lemma to_nat_below (a : nat) (b m : Z) : Z.of_nat a = b -> (m <=? b)%Z -> (Z.to_nat m <= a)%N.
Proof. by lia. Qed.
Lemma opp_ge0 e : (0 <=? e)%Z = false -> (0 <= - e)%Z.
Proof. by lia. Qed.

(* A certificate whose numbers are in order, and its chain. *)
Section Certificate.

Variables (R : rcfType) (c : checker.certificate).
Local Notation zr := (integers.zr R).
Let x0 := checker.Joint 0 0 0.

Definition length_of (i : nat) : R := value R (nth (checker.Rational 0 1) (checker.lengths c) i).
Definition stiffness_of (i : nat) : R := value R (nth (checker.Rational 0 1) (checker.stiffness c) i).
Definition links : nat := size (checker.lengths c).

Let dL := checker.common (checker.lengths c).
Let dk := checker.common (checker.stiffness c).
Let ls := checker.cleared dL (checker.lengths c).
Let ks := checker.cleared dk (checker.stiffness c).
Let js := checker.joints ls ks.

Hypotheses (cL : checker.clears dL (checker.lengths c) ls) (ck : checker.clears dk (checker.stiffness c) ks).
Hypotheses (dL0 : (0 <? dL)%Z) (dk0 : (0 <? dk)%Z).
Hypotheses (same : Nat.eqb (length (checker.lengths c)) (length (checker.stiffness c))).
Hypotheses (law : checker.lawful js).

Let n := links.
Let L := length_of.
Let k := stiffness_of.
Let z := distance n L.

Lemma clearsP d xs ys : checker.clears d xs ys -> size ys = size xs /\
  forall i, (i < size xs)%N -> checker.proper (nth (checker.Rational 0 1) xs i) /\
                               zr (nth 0%Z ys i) = zr d * value R (nth (checker.Rational 0 1) xs i).
Proof.
elim: xs ys => [|x xs IH] [|y ys] //= /andP [/andP [dx e] /IH [-> h]]; split=> // -[|i] i_x; last exact: h.
split=> //=; move: e; rewrite (zr_eq R) !zrM => /eqP e.
have d0 : 0 < zr (checker.den x) by apply: zr_gt0.
by apply: (mulIf (negbT (gt_eqF d0))); rewrite e /value; field; rewrite gt_eqF.
Qed.

Lemma dL_gt0 : 0 < zr dL. Proof. exact: zr_gt0. Qed.
Lemma dk_gt0 : 0 < zr dk. Proof. exact: zr_gt0. Qed.

Lemma sizes : size ls = n /\ size ks = n.
Proof.
have [-> _] := clearsP cL; have [-> _] := clearsP ck; split=> //.
by move: same; rewrite !lengthE /n /links => /PeanoNat.Nat.eqb_eq.
Qed.

Lemma size_js : size js = n.
Proof. by have [a b] := sizes; rewrite /js size_joints a ?b. Qed.

Lemma joints_stand i : (i < n)%N -> stands (zr dL) (zr dk) L z k (nth x0 js i) i.
Proof.
have [a b] := sizes => i_n; have sz : size ls = size ks by rewrite a b.
have [hl hs hd] := @nth_joints R ls ks i sz (eq_ind_r (fun m => (i < m)%N) i_n a).
have [_ cl] := clearsP cL; have [sk ck'] := clearsP ck.
split; rewrite ?hl ?hs ?hd; first by have [] := cl i i_n.
  rewrite /z /distance a mulr_sumr; apply: eq_big_nat => j /andP [_ j_n].
  by have [] := cl j j_n.
by have [] := ck' i; rewrite -?sk ?b.
Qed.

Lemma lawfulP : (1 < n)%N /\ forall i, (i < n)%N -> 0 < L i /\ 0 <= k i.
Proof.
move: law; rewrite /checker.lawful forallbE lengthE size_js => /andP [/andP [h1 /PeanoNat.Nat.leb_le h2] _].
split=> [|i i_n]; first by apply/ssrnat.leP.
move/(all_nthP x0): h1 => /(_ i); rewrite size_js => /(_ i_n) /andP [].
have [lE _ kE] := joints_stand i_n; rewrite (zr_lt R) (zr_le R) lE kE.
by rewrite pmulr_rgt0 ?dL_gt0 // pmulr_rge0 ?dk_gt0.
Qed.

Lemma two_links : (1 < n)%N. Proof. by have [] := lawfulP. Qed.

Lemma chain_lawful : chain_of_links n L k.
Proof. by have [_ h] := lawfulP; split=> i /h []. Qed.

Lemma passive_js i : (i < n)%N -> (checker.stiff (nth x0 js i) =? 0)%Z = (k i == 0).
Proof.
move=> i_n; have [_ _ st] := joints_stand i_n.
by rewrite (zr_eq R) st mulf_eq0 gt_eqF ?dk_gt0.
Qed.

Lemma one_passive : at_most_one_passive n k.
Proof.
move=> i j; wlog i_j : i j / (i < j)%N => [th i_n j_n ki kj|i_n j_n ki kj].
  by case: (ltngtP i j) => // h; [apply: th | symmetry; apply: th].
move: law => /andP [_ /PeanoNat.Nat.leb_le/ssrnat.leP]; rewrite filterE lengthE size_filter.
rewrite -(cat_take_drop j js) count_cat => h; exfalso.
have : (0 < count (fun x => (checker.stiff x =? 0)%Z) (take j js))%N.
  rewrite -has_count; apply/(has_nthP x0); exists i; first by rewrite size_take size_js j_n.
  by rewrite nth_take // passive_js // ki.
have : (0 < count (fun x => (checker.stiff x =? 0)%Z) (drop j js))%N.
  rewrite -has_count; apply/(has_nthP x0); exists 0%N; first by rewrite size_drop size_js subn_gt0.
  by rewrite nth_drop addn0 passive_js // kj.
by move: h; case: (count _ _) => //; case: (count _ _) => // a b; rewrite addSn addnS.
Qed.

Lemma cutE : checker.cut js = cut n k.
Proof.
have sz := size_js; have two := two_links.
rewrite /checker.cut -[List.tl js]/(behead js).
have sb : size (behead js) = n.-1 by rewrite size_behead sz.
rewrite cut_inE; last by rewrite sb -subn1 subn_gt0.
rewrite /cut sb -(map_nth_iota0 x0); last by rewrite sb leq_pred.
rewrite find_map; congr _.+1; apply: eq_in_find => i; rewrite mem_iota /= add0n => i_n.
rewrite /= nth_behead passive_js //.
by move: i_n; case: (n) two => [|[|m]] //= _ h; rewrite !ltnS ltnW.
Qed.

Lemma chain_beads l : (l < n)%N -> z l - z l.+1 = L l.
Proof. by move=> l_n; rewrite /z (distance_step L l_n) addrK. Qed.

Lemma cut_lt : (cut n k < n)%N.
Proof. by have two := two_links; apply: leq_ltn_trans (@cut_le R n k two) _; rewrite ltn_predL ltnW. Qed.

Lemma first_size : size (checker.first_part js) = (cut n k).+1.
Proof. by rewrite /checker.first_part firstnE cutE size_takel // size_js cut_lt. Qed.
Lemma first_stand l : (l < (cut n k).+1)%N -> stands (zr dL) (zr dk) L z k (nth x0 (checker.first_part js) l) l.
Proof.
by move=> l_c; rewrite /checker.first_part firstnE cutE nth_take //; apply: joints_stand; apply: leq_trans l_c cut_lt.
Qed.
Lemma second_size : size (checker.second_part js) = (n - cut n k)%N.
Proof. by rewrite /checker.second_part skipnE cutE size_drop size_js. Qed.
Lemma second_stand l : (l < n - cut n k)%N -> stands (zr dL) (zr dk) (from (cut n k) L) (from (cut n k) z)
  (from (cut n k) k) (nth x0 (checker.second_part js) l) l.
Proof.
by move=> l_c; rewrite /checker.second_part skipnE cutE nth_drop; apply: joints_stand; rewrite -ltn_subRL.
Qed.
Lemma second_last : (n - cut n k).-1 = (n.-1 - cut n k)%N.
Proof. by rewrite -subnS -add1n subnDA subn1. Qed.

Section Changes.

Variables (x : checker.rational) (dx : checker.proper x).

Let D0 : 0 < zr (checker.den x * dL).
Proof. by rewrite zrM mulr_gt0 ?dL_gt0 //; apply: zr_gt0. Qed.
Let PD : zr (checker.num x * dk) * zr dL = value R x * zr (checker.den x * dL) * zr dk.
Proof. by rewrite !zrM /value; field; rewrite gt_eqF //; apply: zr_gt0. Qed.

Lemma first_changes :
  checker.changes (checker.num x * dk) (checker.den x * dL) (checker.first_part js) = changes z k (value R x) (cut n k).
Proof.
rewrite (changes_stands (x0 := x0) (L := L) (z := z) (k := k) dL_gt0 dk_gt0 D0 PD) ?first_size //.
- exact: first_stand.
- by move=> l l_c; apply: (distance_gt0 chain_lawful); apply: leq_trans l_c cut_lt.
by move=> l l_c; apply: chain_beads; apply: leq_trans (ltnW l_c) cut_lt.
Qed.

Lemma second_changes :
  checker.changes (checker.num x * dk) (checker.den x * dL) (checker.second_part js) =
  changes (from (cut n k) z) (from (cut n k) k) (value R x) (n.-1 - cut n k).
Proof.
rewrite (changes_stands (x0 := x0) (L := from (cut n k) L) (z := from (cut n k) z) (k := from (cut n k) k)
         dL_gt0 dk_gt0 D0 PD) ?second_size ?second_last ?subn_gt0 ?cut_lt //.
- exact: second_stand.
- by move=> l l_c; apply: (distance_gt0 chain_lawful); rewrite -ltn_subRL.
by move=> l l_c; rewrite /from addnS; apply: chain_beads; rewrite -ltn_subRL ltnW.
Qed.

Lemma count_atE : checker.count_at dL dk js x = Z.of_nat (count_below n L k (value R x)).
Proof. by rewrite /checker.count_at /checker.both_changes first_changes second_changes. Qed.

End Changes.

(* 10^e *)
Definition ten (e : Z) : R := if (0 <=? e)%Z then zr (10 ^ e) else (zr (10 ^ - e))^-1.

Lemma nth_count (s : seq R) i x : sorted <=%R s -> (i < size s)%N ->
  (nth 0 s i < x) = (i < count (fun F => (F < x)%R) s)%N.
Proof.
elim: s i => // a s IH i; rewrite /= => pa.
have := order_path_min le_trans pa => /allP amin.
case: (ltP a x) => ax.
  by case: i => [|i] //=; rewrite ltnS => i_s; rewrite IH // (path_sorted pa).
have -> : count (fun F => F < x) s = 0%N.
  apply/eqP; rewrite -leqn0 leqNgt -has_count; apply/hasPn => y /amin; rewrite -leNgt.
  exact: le_trans.
case: i => [|i] /=; first by rewrite ltNge ax.
by rewrite ltnS => i_s; apply/negbTE; rewrite -leNgt; apply: le_trans ax _; apply/amin/mem_nth.
Qed.

Lemma ten_gt0 e : (0 <=? e)%Z -> 0 < zr (10 ^ e).
Proof. by move=> h; apply: zr_gt0; apply/Z.ltb_lt/Z.pow_pos_nonneg => //; apply/Z.leb_le. Qed.

Lemma ten_proper e : checker.proper (checker.power_of_ten e).
Proof.
rewrite /checker.power_of_ten; case: ifP => // h; rewrite /checker.proper /=.
by apply/Z.ltb_lt/Z.pow_pos_nonneg => //; apply: opp_ge0.
Qed.

Lemma ten_power e : value R (checker.power_of_ten e) = ten e.
Proof.
by rewrite /checker.power_of_ten /ten /value; case: ifP => _ /=; rewrite ?zr1 ?divr1 // mul1r.
Qed.

(* What is said of one force. *)
Lemma bounds_sound (fs : seq R) f : roots_of (D n L k) fs -> checker.bounds dL dk js f ->
  let: m := Z.to_nat (checker.number f) in
  [/\ (0 < m <= n.-1)%N, 0 < value R (checker.low f),
      value R (checker.low f) <= nth 0 fs m.-1 < value R (checker.high f),
      checker.below_low f = Z.of_nat (count (fun F => F < value R (checker.low f)) fs) &
      checker.below_high f = Z.of_nat (count (fun F => F < value R (checker.high f)) fs)].
Proof.
move=> rfs; rewrite /checker.bounds => /andP [/andP [/andP [/andP [/andP [/andP [/andP [pl ph] l0] lh] cl] ch] ml] mh].
have [gs [rgs sz pfs cfs]] := critical_forces two_links chain_lawful one_passive.
have fg : fs = gs by apply: roots_of_inj rfs rgs.
rewrite -{gs rgs}fg in sz pfs cfs.
move: cl ch; rewrite !count_atE // !cfs => /Z.eqb_eq cl /Z.eqb_eq ch.
have p1 : checker.proper (checker.Rational 0 1) by [].
rewrite (lessP R p1 pl) {1}/value /= mul0r in l0.
pose below x := count (fun F : R => F < x) fs.
rewrite -/(below (value R (checker.low f))) in cl *; rewrite -/(below (value R (checker.high f))) in ch *.
set m := Z.to_nat _; have m_low : (below (value R (checker.low f)) < m)%N by apply: below_to_nat cl ml.
have m_high : (m <= below (value R (checker.high f)))%N by apply: to_nat_below ch mh.
have m_n : (0 < m <= n.-1)%N.
  rewrite (leq_ltn_trans (leq0n _) m_low) /= -sz; apply: leq_trans m_high _; exact: count_size.
split=> //; have [sorted_fs _] := rfs.
have m1 : (m.-1 < size fs)%N by rewrite sz; case/andP: m_n; case: (m) => // m' _.
rewrite leNgt !nth_count // -leqNgt; case/andP: m_n => m0 _; move: m_low m_high; rewrite /below.
by case: (m) m0 => // m' _ /=; rewrite ltnS => -> ->.
Qed.

(* high - low is less than half a unit in the last of the stated digits of low. *)
Lemma precise_sound f : checker.bounds dL dk js f -> checker.precise f ->
  exists e, ten (e - 1) <= value R (checker.low f) < ten e /\
    2%:R * (value R (checker.high f) - value R (checker.low f)) < ten (e - checker.digits f).
Proof.
move=> bf; rewrite /checker.precise => /andP [/andP [/andP [sd de] _] lt]; exists (checker.exponent f).
move: bf; rewrite /checker.bounds => /andP [/andP [/andP [/andP [/andP [/andP [/andP [pl ph] l0] _] _] _] _] _].
have dl : 0 < zr (checker.den (checker.low f)) by apply: zr_gt0.
have dh : 0 < zr (checker.den (checker.high f)) by apply: zr_gt0.
split.
  move: de; rewrite /checker.in_decade; set a := checker.Rational _ _ => /andP [h1 h2].
  have pa : checker.proper a by [].
  have va : value R a = value R (checker.low f).
    rewrite /value /=; congr (zr _ / _); apply: Z.abs_eq.
    by move: l0; rewrite /checker.less /= Z.mul_1_r => /Z.ltb_lt/Z.lt_le_incl.
  by rewrite -!ten_power -va -lessP ?ten_proper // h2 andbT leNgt -lessP ?ten_proper.
move: lt; set w := checker.Rational _ _; rewrite -ten_power.
have pw : checker.proper w by rewrite /checker.proper (zr_lt R) /w /= zrM mulr_gt0.
have -> : 2%:R * (value R (checker.high f) - value R (checker.low f)) = value R w.
  rewrite /w /value; cbn [checker.num checker.den]; rewrite !(zrM, zrB) (_ : zr 2 = 2%:R) //.
  by field; rewrite !gt_eqF.
by rewrite (lessP R pw) ?ten_proper.
Qed.

End Certificate.

(* The whole certificate: its chain is one that the theorems are about, and every force lies where it is said to. *)
Theorem forces_sound (R : rcfType) (c : checker.certificate) : checker.holds c ->
  let n := links c in let L := length_of R c in let k := stiffness_of R c in
  [/\ (1 < n)%N, chain_of_links n L k, at_most_one_passive n k &
  forall fs f, roots_of (D n L k) fs -> List.In f (checker.forces c) ->
    let m := Z.to_nat (checker.number f) in
    let low := value R (checker.low f) in let high := value R (checker.high f) in
    [/\ (0 < m <= n.-1)%N, 0 < low, low <= nth 0 fs m.-1 < high,
        checker.below_low f = Z.of_nat (count (fun F => F < low) fs) &
        checker.below_high f = Z.of_nat (count (fun F => F < high) fs)] /\
    exists e, ten R (e - 1) <= low < ten R e /\ 2%:R * (high - low) < ten R (e - checker.digits f)].
Proof.
rewrite /checker.holds.
case/andP=> [/andP [/andP [/andP [/andP [/andP [/andP [/andP [/andP [/andP [cL ck] dL0] dk0] same] law] _] fsP] _] _] _].
split.
- by apply (two_links R).
- by apply chain_lawful.
- by apply one_passive.
move=> fs f rfs f_in; have {fsP} := proj1 (List.forallb_forall _ _) fsP f f_in => /andP [bf pf].
split; first by apply bounds_sound.
by apply: precise_sound bf pf.
Qed.
