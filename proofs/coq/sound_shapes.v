(* What the checker accepts of mode shapes is true of the real chain. *)
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp Require Import polyrcf.
From mathcomp Require Import zify ssrZ.
From Coq Require Import ZArith.
From mathcomp Require Import ring.
Delimit Scope nat_scope with N.
Require Import chain determinant string recursion forces definite modes integers shapes sound sound_algebra.
Require checker.

Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Import Order.TTheory GRing.Theory Num.Theory.
Local Open Scope ring_scope.

Let no_span := checker.Span 0 0 1.

Lemma one_between (u v w : nat) (a b : Z) : a = Z.of_nat u -> b = Z.of_nat v -> b = (a + 1)%Z -> v = (u + w)%N -> w = 1%N.
Proof. by lia. Qed.
Lemma two_between (u v w : nat) (a b : Z) : a = Z.of_nat u -> b = Z.of_nat v -> b = (a + 2)%Z -> v = (u + w)%N -> w = 2%N.
Proof. by lia. Qed.
Lemma tie_place (u : nat) (a t : Z) : a = Z.of_nat u -> t = (a + 1)%Z -> Z.to_nat t = u.+1.
Proof. by lia. Qed.
Lemma inside_first (i p : nat) : (i <= p)%N -> ((1 <=? Z.of_nat i + 1) && (Z.of_nat i + 1 <=? Z.of_nat p + 1))%Z.
Proof. by lia. Qed.
Lemma inside_second (i p n : nat) : (p <= i)%N -> (i < n)%N ->
  ((Z.of_nat p + 1 <=? Z.of_nat i + 1) && (Z.of_nat i + 1 <=? Z.of_nat n))%Z.
Proof. by lia. Qed.
Lemma appE X (s t : seq X) : List.app s t = s ++ t. Proof. by elim: s => //= x s ->. Qed.
Lemma rises (u w : nat) : Z.of_nat (u + w) = (Z.of_nat u + 1)%Z -> (0 < w)%N.
Proof. by lia. Qed.

(* Intervals divided by the one of the angle that is one. *)
Lemma zr_abs (R : rcfType) a : `|integers.zr R a| = integers.zr R (Z.abs a).
Proof.
case: (lerP 0 (integers.zr R a)) => h.
  rewrite ger0_norm //; congr (integers.zr R _); symmetry; apply: Z.abs_eq.
  by apply/Z.leb_le; rewrite (zr_le R) zr0.
rewrite ltr0_norm // -zrN; congr (integers.zr R _); symmetry; apply: Z.abs_neq.
by apply/Z.leb_le; rewrite (zr_le R) zr0 ltW.
Qed.

Section Normalised.

Variable R : rcfType.
Local Notation zr := (integers.zr R).
Let angle0 := (checker.Rational 0 1, 0%Z).

Lemma nothing : contains no_span (0 : R).
Proof. by rewrite /contains /= zr0 zr1 mul0r; split=> //; exact: ltr01. Qed.

Lemma contains_negated s (x : R) : contains s x -> contains (checker.negated s) (- x).
Proof. by case=> o l u; split; rewrite //= zrN mulNr ler_opp2. Qed.

Lemma place_of_oneP qs vs one : checker.place_of_one qs vs = Some one -> exists p,
  [/\ (p < size vs)%N, nth no_span qs p = one &
      checker.num (nth angle0 vs p).1 = checker.den (nth angle0 vs p).1].
Proof.
elim: qs vs => [|q qs IH] [|v vs] //=; case: ifP => [/Z.eqb_eq e [<-]|_ /IH [p [a b c]]]; first by exists 0%N.
by exists p.+1.
Qed.

Lemma all_withinP one qs d vs : checker.all_within one qs d vs -> size qs = size vs /\
  forall i, (i < size vs)%N -> checker.angle_within one (nth no_span qs i) d (nth angle0 vs i).
Proof.
elim: qs vs => [|q qs IH] [|v vs] //= /andP [h /IH [-> hs]]; split=> // -[|i] //; exact: hs.
Qed.

Lemma linear_below (lo a b x y : R) : a <= x <= b -> lo * a <= y -> lo * b <= y -> lo * x <= y.
Proof.
case/andP=> ax xb ha hb; case: (lerP 0 lo) => l0; first by apply: le_trans hb; rewrite ler_wpmul2l.
by apply: le_trans ha; rewrite ler_wnmul2l // ltW.
Qed.

Lemma linear_above (hi a b x y : R) : a <= x <= b -> y <= hi * a -> y <= hi * b -> y <= hi * x.
Proof.
case/andP=> ax xb ha hb; case: (lerP 0 hi) => h0; first by apply: le_trans ha _; rewrite ler_wpmul2l.
by apply: le_trans hb _; rewrite ler_wnmul2l // ltW.
Qed.

(* lo / d <= x / y <= hi / d *)
Lemma withinP q one (x y : R) lo hi d : contains q x -> contains one y -> 0 < y -> 0 < zr d ->
  checker.within q one lo hi d -> zr lo / zr d <= x / y <= zr hi / zr d.
Proof.
move=> [oq lq uq] [o1 l1 u1] y0 d0.
rewrite /checker.within => /andP [/andP [/andP [h1 h2] h3] h4].
move: h1 h2 h3 h4; rewrite !(zr_le R) !zrM => h1 h2 h3 h4.
have yo : zr (checker.lower one) <= y * zr (checker.over one) <= zr (checker.upper one) by rewrite l1 u1.
have below : zr lo * zr (checker.over q) * (y * zr (checker.over one)) <= x * zr (checker.over q) * zr d * zr (checker.over one).
  apply: (linear_below yo); rewrite mulrAC.
    by apply: le_trans h1 _; rewrite ler_pmul2r // ler_pmul2r.
  by apply: le_trans h2 _; rewrite ler_pmul2r // ler_pmul2r.
have above : x * zr (checker.over q) * zr d * zr (checker.over one) <= zr hi * zr (checker.over q) * (y * zr (checker.over one)).
  apply: (linear_above yo); rewrite [X in _ <= X]mulrAC.
    by apply: le_trans _ h3; rewrite ler_pmul2r // ler_pmul2r.
  by apply: le_trans _ h4; rewrite ler_pmul2r // ler_pmul2r.
have e1 (a b p r : R) : a * b * (p * r) = a * p * (b * r) by ring.
have e2 (a b p r : R) : a * b * (p * r) = a * p * b * r by ring.
have oo : 0 < zr (checker.over q) * zr (checker.over one) by rewrite mulr_gt0.
rewrite ler_pdivr_mulr // mulrAC ler_pdivl_mulr // ler_pdivr_mulr // mulrAC ler_pdivl_mulr //; apply/andP; split.
  by rewrite -(ler_pmul2r oo) [X in X <= _]e1 [X in _ <= X]e2.
by rewrite -(ler_pmul2r oo) [X in X <= _]e2 [X in _ <= X]e1.
Qed.

(* What is stated of one angle x. *)
Definition angle_stands (digits : Z) (a : checker.rational * Z) (x : R) : Prop :=
  let v := value R a.1 in
  [/\ `|v| <= 1, `|x - v| <= ten R (a.2 - digits) &
      (if v == 0 then a.2 = 0%Z else ten R (a.2 - 1) <= `|v| < ten R a.2)].

Lemma angle_withinP one q d a (x y : R) : contains q x -> contains one y -> 0 < y ->
  checker.angle_within one q d a -> angle_stands d a (x / y).
Proof.
move=> cq c1 y0; case: a => v e; rewrite /checker.angle_within /angle_stands /=.
set u := checker.power_of_ten (e - d).
case/andP=> [/andP [/andP [/andP [pv dec] _] le1] w].
have dv : 0 < zr (checker.den v) by apply: zr_gt0.
have pu : checker.proper u by apply: ten_proper.
have du : 0 < zr (checker.den u) by apply: zr_gt0.
have absE : `|value R v| = value R (checker.Rational (Z.abs (checker.num v)) (checker.den v)).
  by rewrite /value /= normrM [X in _ * X]gtr0_norm ?invr_gt0 // zr_abs.
split.
- by rewrite absE /value /= ler_pdivr_mulr // mul1r -zr_le.
- have := withinP cq c1 y0 _ w; rewrite !(zrB, zrD, zrM) mulr_gt0 // => /(_ isT).
  have -> : (zr (checker.num v) * zr (checker.den u) - zr (checker.num u) * zr (checker.den v)) / (zr (checker.den v) * zr (checker.den u)) = value R v - value R u.
    by rewrite /value; field; rewrite !gt_eqF.
  have -> : (zr (checker.num v) * zr (checker.den u) + zr (checker.num u) * zr (checker.den v)) / (zr (checker.den v) * zr (checker.den u)) = value R v + value R u.
    by rewrite /value; field; rewrite !gt_eqF.
  by case/andP=> a b; rewrite -ten_power -/u ler_norml; apply/andP; split; [rewrite ler_subr_addl|rewrite ler_subl_addl].
have v0 : (value R v == 0) = (checker.num v =? 0)%Z.
  by rewrite /value mulf_eq0 invr_eq0 (gt_eqF dv) orbF (zr_eq R) zr0.
rewrite v0; case: ifP dec => _; first by move/Z.eqb_eq.
rewrite /checker.in_decade; set w' := checker.Rational _ _ => /andP [h1 h2].
have pw : checker.proper w' by [].
rewrite absE -!ten_power -lessP ?ten_proper // h2 andbT leNgt -lessP ?ten_proper //.
Qed.

End Normalised.

Section Lists.

Variable R : rcfType.

(* Where two of a list in order lie between bounds, and no third. *)
Lemma same_between (fs : seq R) (p : pred R) x y : x \in fs -> p x -> y \in fs -> p y ->
  (count p fs <= count_mem x fs)%N -> y = x.
Proof.
move=> x_fs px y_fs py h; apply/eqP/negPn/negP => y_x.
have : has (fun f => p f && (f != x)) fs by apply/hasP; exists y; rewrite // py.
by rewrite has_count; move: h; rewrite (split_count fs px) -[X in (_ <= X)%N]addn0 leq_add2l leqn0 => /eqP ->.
Qed.

Lemma twice_mem (fs : seq R) i : (i.+1 < size fs)%N -> nth 0 fs i = nth 0 fs i.+1 -> (1 < count_mem (nth 0%R fs i) fs)%N.
Proof.
move=> i_s e; rewrite -[X in count_mem _ X](cat_take_drop i.+1 fs) count_cat (_ : 2 = 1 + 1)%N // leq_add // -has_count has_pred1.
  by rewrite -(nth_take 0 (ltnSn i)) mem_nth // size_take i_s.
by rewrite e -[in nth 0 fs _](addn0 i.+1) -nth_drop mem_nth // size_drop subn_gt0.
Qed.

End Lists.

Section Certificate.

Variables (R : rcfType) (c : checker.certificate).
Local Notation zr := (integers.zr R).
Let x0 := checker.Joint 0 0 0.
Let angle0 := (checker.Rational 0 1, 0%Z).
Let dL := checker.common (checker.lengths c).
Let dk := checker.common (checker.stiffness c).
Let ls := checker.cleared dL (checker.lengths c).
Let ks := checker.cleared dk (checker.stiffness c).
Let js := checker.joints ls ks.

Hypotheses (cL : checker.clears dL (checker.lengths c) ls) (ck : checker.clears dk (checker.stiffness c) ks).
Hypotheses (dL0 : (0 <? dL)%Z) (dk0 : (0 <? dk)%Z).
Hypotheses (same : Nat.eqb (length (checker.lengths c)) (length (checker.stiffness c))).
Hypotheses (law : checker.lawful js).

Let n := links c.
Let L := length_of R c.
Let k := stiffness_of R c.
Let z := distance n L.

Let two : (1 < n)%N. Proof. exact: (two_links R cL ck dL0 dk0 same law). Qed.
Let lawful : chain_of_links n L k. Proof. exact: chain_lawful. Qed.
Let one : at_most_one_passive n k. Proof. exact: one_passive. Qed.
Let L0 : 0 < zr dL. Proof. exact: zr_gt0. Qed.
Let k0 : 0 < zr dk. Proof. exact: zr_gt0. Qed.
Let pos i : (i < n)%N -> 0 < L i. Proof. by have [h _] := lawful; apply: h. Qed.

(* The intervals of a part of the chain hold the angles of its mode. *)
Lemma part_contains (part : seq checker.joint) x y F (zp kp Lp : nat -> R) : (1 < size part)%N ->
  (forall l, (l < size part)%N -> stands (zr dL) (zr dk) Lp zp kp (nth x0 part l) l) ->
  (forall l, (l < size part)%N -> 0 < zp l) -> (forall l, (l < size part)%N -> 0 <= kp l) ->
  (forall l, (0 < l < (size part).-1)%N -> 0 < kp l) ->
  (forall l, (l.+1 < size part)%N -> zp l - zp l.+1 = Lp l) -> (forall l, (l < size part)%N -> 0 < Lp l) ->
  checker.proper x -> checker.proper y -> 0 < value R x -> value R x <= F <= value R y ->
  size (checker.part_shape dL dk part x y) = size part /\
  forall l, (l < size part)%N ->
    contains (nth no_span (checker.part_shape dL dk part x y) l) (turn zp kp F (size part).-1 l).
Proof.
case: part => // j rest; rewrite ltnS => sz st zpos kn kpos Ls Lpos px py vx /andP [xF Fy].
have dx : 0 < zr (checker.den x) by apply: zr_gt0.
have dy : 0 < zr (checker.den y) by apply: zr_gt0.
have D0 : 0 < zr (checker.den x * checker.den y * dL)%Z by rewrite !zrM !mulr_gt0.
have nx : 0 < zr (checker.num x) by move: vx; rewrite /value pmulr_lgt0 ?invr_gt0.
have P10 : 0 < zr (checker.num x * checker.den y * dk)%Z by rewrite !zrM !mulr_gt0.
have PF : zr (checker.num x * checker.den y * dk)%Z <=
    F * zr (checker.den x * checker.den y * dL)%Z * zr dk / zr dL <= zr (checker.num y * checker.den x * dk)%Z.
  have -> : F * zr (checker.den x * checker.den y * dL)%Z * zr dk / zr dL =
      F * (zr (checker.den x) * zr (checker.den y) * zr dk).
    by rewrite !zrM; field; rewrite gt_eqF.
  have -> : zr (checker.num x * checker.den y * dk)%Z = value R x * (zr (checker.den x) * zr (checker.den y) * zr dk).
    by rewrite !zrM /value; field; rewrite gt_eqF.
  have -> : zr (checker.num y * checker.den x * dk)%Z = value R y * (zr (checker.den x) * zr (checker.den y) * zr dk).
    by rewrite !zrM /value; field; rewrite gt_eqF.
  by rewrite !ler_pmul2r ?xF // !mulr_gt0.
have zz : 0 < zp 0%N by apply: (zpos 0%N).
have [_ d0 s0] : stands (zr dL) (zr dk) Lp zp kp j 0 by apply: (st 0%N).
have [] := @sweep_contains R (zr dL) (zr dk) Lp zp kp F (size rest) L0 k0 zpos kpos Ls (fun l h => Lpos l (leqW h)) kn
  _ _ _ D0 P10 PF rest j 0%N (checker.dist j) (checker.dist j) (checker.stiff j) (checker.stiff j) 1%Z (zr dL / zp 0%N) (erefl _).
- by move=> l l_r; rewrite (set_nth_default x0) //; apply: st.
- by rewrite d0 hornerC (_ : zr dL / zp 0%N * zp 0%N ^+ 2 = zr dL * zp 0%N) ?lexx //; field; rewrite gt_eqF.
- rewrite s0 hornerC (_ : zr dL / zp 0%N * (zr dk / zr dL) * (zp 0%N * kp 0%N * 1) = zr dk * kp 0%N) ?lexx //.
  by field; rewrite !gt_eqF.
- by rewrite divr_gt0.
- by move=> _; rewrite big_ord0 zr1; field; rewrite !gt_eqF.
move=> ssz inside; split; first by rewrite /= ssz.
case=> [|l] l_r; last by apply: inside.
by rewrite /contains /= zr1 mul1r lexx; split=> //; exact: ltr01.
Qed.

(* The shape of one part, zero elsewhere, is a mode of the chain. *)
Lemma first_mode F : (H z k (cut n k)).[F] = 0 -> exists Fy,
  mode L k F (\col_(i < n) (if (i <= cut n k)%N then turn z k F (cut n k) i else 0)) Fy.
Proof.
set p := cut n k => rest; have p_n : (p < n)%N by apply: (cut_lt R cL ck dL0 dk0 same law).
have zp i : (i <= p)%N -> 0 < z i by move=> h; apply: (distance_gt0 lawful); apply: leq_ltn_trans h p_n.
have kp i : (0 < i < p)%N -> 0 < k i by apply: (elastic_before two lawful).
have p0 : (0 < p)%N by [].
pose s i := if (i <= p.+1)%N then deflected z k F p i else 0.
pose g i := if (i <= p)%N then slope z k F i else 0.
pose q i := if (i <= p)%N then turn z k F p i else 0.
exists (- g 0%N); apply: (string_mode pos (q := q) (s := s) (g := g)).
- by [].
- move=> i i_n; rewrite /s /q ltnS; case: (leqP i p) => h; first by rewrite (leqW h) (deflectedS zp kp p0 rest h).
  rewrite mulr0 addr0; case: leqP => // h2; have -> : i = p.+1 by apply/eqP; rewrite eqn_leq h2 h.
  by rewrite /= eqxx.
- by move=> i i_n; rewrite /g /q; case: (leqP i p) => h; rewrite ?mulr0 // (slope_turn zp kp rest h).
- move=> i i_n; rewrite /g /s ltnS; case: (ltngtP i p) => h.
  + by rewrite (slopeS F zp kp h).
  + by rewrite mulr0 subr0.
  rewrite h /= eqxx mulr0 subr0.
  have p_lt : (p < n.-1)%N by rewrite -h -ltnS prednK // ltnW.
  have := slope_turn zp kp rest (leqnn p); rewrite (cut_passive two p_lt) mul0r => /esym/eqP.
  by rewrite mulf_eq0 gt_eqF ?zp //= => /eqP.
- rewrite /s; case: leqP => // n_p; have -> : n = p.+1 by apply/eqP; rewrite eqn_leq n_p p_n.
  by rewrite /= eqxx.
by exists 0%N; [exact: ltnW | rewrite /q leq0n oner_eq0].
Qed.

Lemma second_mode F : (cut n k < n.-1)%N -> (H (from (cut n k) z) (from (cut n k) k) (n.-1 - cut n k)).[F] = 0 ->
  exists Fy, mode L k F (\col_(i < n) (if (i < cut n k)%N then 0
                                       else turn (from (cut n k) z) (from (cut n k) k) F (n.-1 - cut n k) (i - cut n k))) Fy.
Proof.
set p := cut n k => p_lt; set z' := from p z; set k' := from p k; set m := (n.-1 - p)%N => rest.
have pm : (p + m)%N = n.-1 by rewrite subnKC // ltnW.
have nE : n.-1.+1 = n by rewrite prednK // ltnW.
have zp i : (i <= m)%N -> 0 < z' i.
  by move=> h; apply: (distance_gt0 lawful); rewrite -nE ltnS -pm leq_add2l.
have kp i : (0 < i < m)%N -> 0 < k' i.
  by case/andP=> i0 i_m; apply: (elastic_behind two lawful one p_lt); rewrite i0 ltnW.
have m0 : (0 < m)%N by rewrite subn_gt0.
have kc : k p = 0 by apply: (cut_passive two).
pose s i := if (i <= p)%N then 0 else deflected z' k' F m (i - p).
pose g i := if (i < p)%N then 0 else slope z' k' F (i - p).
have in_m i : (p <= i)%N -> (i < n)%N -> (i - p <= m)%N by move=> _ h; rewrite leq_sub2r // -ltnS nE.
pose q i := if (i < p)%N then 0 else turn z' k' F m (i - p).
exists (- g 0%N); apply: (string_mode pos (q := q) (s := s) (g := g)).
- by [].
- move=> i i_n; rewrite /s /q; case: (ltngtP i p) => h.
  + by rewrite mulr0 addr0.
  + have {h} h := ltnW h; rewrite subSn // (deflectedS zp kp m0 rest) ?in_m //.
    by rewrite /z' /from subnKC.
  by rewrite h subnn subSnn (deflectedS zp kp m0 rest (leq0n m)) /z' /from addn0.
- move=> i i_n; rewrite /g /q; case: (ltnP i p) => h; first by rewrite !mulr0.
  by have := slope_turn zp kp rest (in_m _ h i_n); rewrite /z' /k' /from subnKC.
- move=> i i_n; rewrite /g /s; case: (ltngtP i.+1 p) => h.
  + by rewrite mulr0 subr0.
  + have h' : (p <= i)%N by [].
    rewrite subSn // (slopeS F zp kp); first by rewrite /bead /z' /from addnS subnKC.
    by rewrite -(ltn_add2l p) subnKC // pm -ltnS nE.
  by rewrite h subnn mulr0 subr0 /slope /k' /from addn0 kc mul0r.
- by rewrite /s leqNgt (cut_lt R cL ck dL0 dk0 same law) /= -{1}nE subSn ?(ltnW p_lt) // -/m /= eqxx.
by exists p; [exact: (cut_lt R cL ck dL0 dk0 same law) | rewrite /q ltnn subnn oner_eq0].
Qed.

(* Which force it is. *)
Lemma the_force fs f ts x : roots_of (D n L k) fs -> checker.bounds dL dk js f ->
  (forall t, List.In t ts -> checker.tied dL dk js t) -> checker.single_or_tied f ts ->
  x \in fs -> value R (checker.low f) <= x < value R (checker.high f) ->
  nth 0 fs (Z.to_nat (checker.number f)).-1 = x.
Proof.
move=> rfs bf tts st x_fs xb; have [mn _ Fb bl bh] := bounds_sound cL ck dL0 dk0 same law rfs bf.
have [gs [rgs sz _ _]] := critical_forces two lawful one; rewrite -(roots_of_inj rfs rgs) {gs rgs} in sz.
set low := value R _ in xb Fb bl; set high := value R _ in xb Fb bh.
set F := nth 0 fs _ in Fb *; have sorted_fs : sorted <=%R fs by case: rfs.
have F_fs : F \in fs by rewrite mem_nth // sz; case/andP: mn; case: (Z.to_nat _).
have lh : low < high by case/andP: xb => a b; apply: le_lt_trans a b.
have := counts_differ fs lh; set p := fun g => low <= g < high.
set u := count (fun g => g < low) fs in bl *; set v := count (fun g => g < high) fs in bh * => uv.
case/orP: st => [/Z.eqb_eq h|/andP [/Z.eqb_eq h /List.existsb_exists [t [t_in /Z.eqb_eq tn]]]].
  have cp : count p fs = 1%N := one_between bl bh h uv.
  by apply: (same_between (p := p) x_fs xb F_fs Fb); rewrite cp -has_count has_pred1.
have cp : count p fs = 2%N := two_between bl bh h uv.
have [/andP [_ t_n] e _] := tie_true cL ck dL0 dk0 same law rfs (tts t t_in).
have tE : Z.to_nat (checker.tie_number t) = u.+1 := tie_place bl tn.
rewrite tE -sz in t_n; rewrite tE in e; have twice := twice_mem t_n e.
have y_fs : nth 0 fs u \in fs by rewrite mem_nth // ltnW.
have py : p (nth 0 fs u).
  by rewrite /p leNgt !nth_count // ?(ltnW t_n) // -/u -/v uv cp ltnn addn2 leqnSn.
have le2 : (count p fs <= count_mem (nth 0%R fs u) fs)%N by rewrite cp.
by rewrite (same_between (p := p) y_fs py F_fs Fb le2) (same_between (p := p) y_fs py x_fs xb le2).
Qed.

Lemma root_between (zz kk : nat -> R) m xs a b : a < b -> string_forces zz kk m xs ->
  (Z.of_nat (changes zz kk b m) =? Z.of_nat (changes zz kk a m) + 1)%Z -> exists2 x, x \in xs & a <= x < b.
Proof.
move=> ab sf; rewrite !(string_changes sf) (counts_differ xs ab) => /Z.eqb_eq h.
by apply/hasP; rewrite has_count; apply: rises h.
Qed.

Lemma mode_scaled F a (v : 'cV[R]_n) Fy : a != 0 -> mode L k F v Fy -> mode L k F (a *: v) (a * Fy).
Proof.
move=> a0 [v0 e1 e2]; split; first by rewrite scaler_eq0 negb_or a0.
  have := congr1 (fun x => a *: x) e1; rewrite scaler0 !scalerDr !scalerA => <-.
  by rewrite -!scalemxAr scalerA [F * a]mulrC.
by rewrite -scalemxAr e2 scaler0.
Qed.

Definition normal (vs : seq (checker.rational * Z)) d (Q : nat -> R) : Prop :=
  size vs = n /\ exists2 p, (p < n)%N &
    [/\ Q p != 0, value R (nth angle0 vs p).1 = 1 & forall i, (i < n)%N -> angle_stands d (nth angle0 vs i) (Q i / Q p)].

Lemma normal_positive qs o vs d (Q : nat -> R) p : (forall i, (i < n)%N -> contains (nth no_span qs i) (Q i)) ->
  size qs = n -> (p < size vs)%N -> nth no_span qs p = o ->
  checker.num (nth angle0 vs p).1 = checker.den (nth angle0 vs p).1 -> (0 <? checker.lower o)%Z ->
  checker.all_within o qs d vs -> normal vs d Q.
Proof.
move=> inside sz p_v po e lo /all_withinP [szv h]; have vn : size vs = n by rewrite -szv.
rewrite vn in p_v h; have := inside p p_v; rewrite po => co; have [oo l _] := co.
have Qp : 0 < Q p.
  by rewrite -(pmulr_lgt0 _ oo); apply: lt_le_trans l; apply: zr_gt0.
split=> //; exists p => //; split; first by rewrite gt_eqF.
- move: (h p p_v) e; case: (nth angle0 vs p) => v e; rewrite /checker.angle_within /= => /andP [/andP [/andP [/andP [pv _] _] _] _] e1.
  by rewrite /value e1 divff // gt_eqF //; apply: zr_gt0.
by move=> i i_n; apply: angle_withinP (inside i i_n) co Qp (h i i_n).
Qed.

Lemma normal_shape qs vs d (Q : nat -> R) : (forall i, (i < n)%N -> contains (nth no_span qs i) (Q i)) -> size qs = n ->
  match checker.place_of_one qs vs with
  | None => false
  | Some o => let flip := if (0 <? checker.lower o)%Z then fun x => x else checker.negated in
              (0 <? checker.lower (flip o))%Z && checker.all_within (flip o) (List.map flip qs) d vs
  end -> normal vs d Q.
Proof.
move=> inside sz; case E: (checker.place_of_one qs vs) => [o|] //=; have [p [p_v po e]] := place_of_oneP E.
case: ifP => _ /andP [lo w]; first by rewrite List.map_id in w; apply: normal_positive inside sz p_v po e lo w.
have mapE (s : seq checker.span) : List.map checker.negated s = map checker.negated s by elim: s => //= a s ->.
rewrite mapE in w; have [szv _] := all_withinP w; rewrite size_map sz in szv.
have i1 : forall i, (i < n)%N -> contains (nth no_span (map checker.negated qs) i) (- Q i).
  by move=> i i_n; rewrite (nth_map no_span) ?sz //; apply/contains_negated/inside.
have i2 : size (map checker.negated qs) = n by rewrite size_map.
have i3 : nth no_span (map checker.negated qs) p = checker.negated o by rewrite (nth_map no_span) ?po // sz szv.
have [vn [p' p_n [q0 v1 h]]] := normal_positive (Q := fun i => - Q i) i1 i2 p_v i3 e lo w.
split=> //; exists p' => //; split=> //; first by move: q0; rewrite /= oppr_eq0.
by move=> i i_n; have := h i i_n; rewrite /= invrN mulrNN.
Qed.

Lemma zerosE m i : nth no_span (List.repeat no_span m) i = no_span.
Proof. by elim: m i => [|m IH] [|i] //=. Qed.
Lemma size_zeros m : size (List.repeat no_span m) = m. Proof. by elim: m => //= m ->. Qed.

(* The shape of a force: a mode at that very force, zero outside of its part, one at one angle, and each angle within a
   unit of the last digit of what stands for it. *)
Lemma shape_true fs f ts s : roots_of (D n L k) fs -> checker.bounds dL dk js f ->
  (forall t, List.In t ts -> checker.tied dL dk js t) -> checker.shaped dL dk js f ts s ->
  exists w : nat -> R,
  [/\ exists Fy, mode L k (nth 0 fs (Z.to_nat (checker.number f)).-1) (\col_(i < n) w i) Fy,
      forall i, (i < n)%N -> ~~ ((checker.first s <=? Z.of_nat i + 1) && (Z.of_nat i + 1 <=? checker.last s))%Z -> w i = 0,
      size (checker.angles s) = n,
      exists2 p, (p < n)%N & w p = 1 /\ value R (nth angle0 (checker.angles s) p).1 = 1 &
      forall i, (i < n)%N -> angle_stands (checker.shape_digits s) (nth angle0 (checker.angles s) i) (w i)].
Proof.
move=> rfs bf tts; have [_ low0 Fb _ _] := bounds_sound cL ck dL0 dk0 same law rfs bf.
have lh : value R (checker.low f) < value R (checker.high f) by case/andP: Fb => a b; apply: le_lt_trans a b.
have [pl ph] : checker.proper (checker.low f) /\ checker.proper (checker.high f).
  by move: bf; rewrite /checker.bounds => /andP [/andP [/andP [/andP [/andP [/andP [/andP [? ?] _] _] _] _] _] _].
set F := nth 0 fs _; set p := cut n k; have p_n : (p < n)%N by apply: (cut_lt R cL ck dL0 dk0 same law).
have cE : checker.cut js = p by apply: cutE.
have finish (Q : nat -> R) Fy : mode L k F (\col_(i < n) Q i) Fy ->
    (forall i, (i < n)%N -> ~~ ((checker.first s <=? Z.of_nat i + 1) && (Z.of_nat i + 1 <=? checker.last s))%Z -> Q i = 0) ->
    normal (checker.angles s) (checker.shape_digits s) Q ->
  exists w : nat -> R,
  [/\ exists Fy, mode L k F (\col_(i < n) w i) Fy,
      forall i, (i < n)%N -> ~~ ((checker.first s <=? Z.of_nat i + 1) && (Z.of_nat i + 1 <=? checker.last s))%Z -> w i = 0,
      size (checker.angles s) = n,
      exists2 p, (p < n)%N & w p = 1 /\ value R (nth angle0 (checker.angles s) p).1 = 1 &
      forall i, (i < n)%N -> angle_stands (checker.shape_digits s) (nth angle0 (checker.angles s) i) (w i)].
  move=> mQ outside [szv [j j_n [q0 v1 h]]]; exists (fun i => Q i / Q j); split=> //.
  - exists ((Q j)^-1 * Fy); have -> : \col_(i < n) (Q i / Q j) = (Q j)^-1 *: (\col_(i < n) Q i).
      by apply/colP => i; rewrite !mxE mulrC.
    by apply: mode_scaled mQ; rewrite invr_eq0.
  - by move=> i i_n /(outside i i_n) ->; rewrite mul0r.
  by exists j; rewrite ?divff.
rewrite /checker.shaped; cbv zeta; rewrite cE lengthE (size_js R cL ck same) -/n.
case/andP=> [/andP [_ st]]; case: ifP => [/andP [/Z.eqb_eq f1 /Z.eqb_eq l1] | _].
  rewrite /checker.count_part !(first_changes R cL ck dL0 dk0 same law) // => /andP [cnt shape].
  have [xs fx] := first_string two lawful one; have [ys fy] := second_string two lawful one.
  have [x x_xs xb] := root_between lh fx cnt.
  have x_fs : x \in fs.
    by rewrite (roots_of_inj rfs (roots_of_strings two lawful fx fy)) mem_sort mem_cat x_xs.
  have FE : F = x by apply: (the_force rfs bf tts st x_fs xb).
  have rest : (H z k p).[F] = 0 by apply/eqP; rewrite FE -/(root _ _) (roots_of_root x (string_roots_of fx)).
  have [Fy mQ] := first_mode rest; pose Q i := if (i <= p)%N then turn z k F p i else 0.
  apply: (finish Q Fy mQ).
    by move=> i i_n; rewrite /Q; case: leqP => // ip; rewrite f1 l1 inside_first.
  have sp := first_size R cL ck dL0 dk0 same law; rewrite -/p in sp.
  have low_p i : (i < p.+1)%N -> (i < n)%N by move=> h; apply: leq_trans h p_n.
  have st1 : forall l, (l < p.+1)%N -> stands (zr dL) (zr dk) L z k (nth x0 (checker.first_part js) l) l.
    by move=> l l_p; apply: first_stand.
  have z1 : forall l, (l < p.+1)%N -> 0 < z l by move=> l /low_p; apply: (distance_gt0 lawful).
  have k1 : forall l, (l < p.+1)%N -> 0 <= k l by move=> l /low_p; apply: (stiffness_ge0 lawful).
  have e1 : forall l, (0 < l < p)%N -> 0 < k l by apply: (elastic_before two lawful).
  have b1 : forall l, (l.+1 < p.+1)%N -> z l - z l.+1 = L l by move=> l h; apply: (chain_beads R); apply/low_p/ltnW.
  have p1 : forall l, (l < p.+1)%N -> 0 < L l by move=> l /low_p; apply: pos.
  have Fle : value R (checker.low f) <= F <= value R (checker.high f) by case/andP: Fb => -> /ltW ->.
  have := @part_contains (checker.first_part js) (checker.low f) (checker.high f) F z k L; rewrite sp.
  move=> /(_ isT st1 z1 k1 e1 b1 p1 pl ph low0 Fle) [szp inside].
  apply: (normal_shape _ _ shape); last by rewrite appE size_cat szp size_zeros minusE subnKC.
  by move=> i i_n; rewrite /Q appE nth_cat szp ltnS; case: leqP => h; [exact: inside | rewrite zerosE; exact: nothing].
case: ifP => [/andP [/Z.eqb_eq f1 /Z.eqb_eq l1] | _ //].
rewrite /checker.count_part !(second_changes R cL ck dL0 dk0 same law) // => /andP [cnt shape].
have [xs fx] := first_string two lawful one; have [ys fy] := second_string two lawful one.
have [x x_ys xb] := root_between lh fy cnt.
have x_fs : x \in fs.
  by rewrite (roots_of_inj rfs (roots_of_strings two lawful fx fy)) mem_sort mem_cat x_ys orbT.
have FE : F = x by apply: (the_force rfs bf tts st x_fs xb).
have p_lt : (p < n.-1)%N by rewrite -subn_gt0 -(string_size fy); case: (ys) x_ys.
have rest : (H (from p z) (from p k) (n.-1 - p)).[F] = 0.
  by apply/eqP; rewrite FE -/(root _ _) (roots_of_root x (string_roots_of fy)).
have [Fy mQ] := second_mode p_lt rest.
pose Q i := if (i < p)%N then 0 else turn (from p z) (from p k) F (n.-1 - p) (i - p).
apply: (finish Q Fy mQ).
  by move=> i i_n; rewrite /Q; case: ltnP => // pi; rewrite f1 l1 inside_second.
have sp := second_size R cL ck dL0 dk0 same law; rewrite -/p in sp.
have sl := second_last R c; rewrite -/n -/k -/p in sl.
have at_n i : (i < n - p)%N -> (p + i < n)%N by rewrite ltn_subRL.
have st1 : forall l, (l < n - p)%N -> stands (zr dL) (zr dk) (from p L) (from p z) (from p k) (nth x0 (checker.second_part js) l) l.
  by move=> l l_p; apply: second_stand.
have s1 : (1 < n - p)%N by rewrite ltn_subRL addn1 -ltn_predRL.
have z1 : forall l, (l < n - p)%N -> 0 < from p z l by move=> l /at_n; apply: (distance_gt0 lawful).
have k1 : forall l, (l < n - p)%N -> 0 <= from p k l by move=> l /at_n; apply: (stiffness_ge0 lawful).
have e1 : forall l, (0 < l < n.-1 - p)%N -> 0 < from p k l.
  by move=> l /andP [l0 l_m]; apply: (elastic_behind two lawful one p_lt); rewrite l0 ltnW.
have b1 : forall l, (l.+1 < n - p)%N -> from p z l - from p z l.+1 = from p L l.
  by move=> l h; rewrite /from addnS; apply: (chain_beads R); apply/at_n/ltnW.
have p1 : forall l, (l < n - p)%N -> 0 < from p L l by move=> l /at_n; apply: pos.
have Fle : value R (checker.low f) <= F <= value R (checker.high f) by case/andP: Fb => -> /ltW ->.
have := @part_contains (checker.second_part js) (checker.low f) (checker.high f) F (from p z) (from p k) (from p L).
rewrite sp sl; move=> /(_ s1 st1 z1 k1 e1 b1 p1 pl ph low0 Fle) [szp inside].
apply: (normal_shape _ _ shape); last by rewrite appE size_cat szp size_zeros subnKC // ltnW.
move=> i i_n; rewrite /Q appE nth_cat size_zeros; case: ltnP => h; first by rewrite zerosE; exact: nothing.
by apply: inside; apply: (ltn_sub2r p_n i_n).
Qed.

End Certificate.

(* Of a certificate that the checker accepts: the shape of a force is that of a mode (29), (30) at that very force, zero
   outside of the part that bends, one at an angle that is stated as 1, and each angle lies within a unit of the last digit
   of what stands for it. *)
Theorem shapes_sound (R : rcfType) (c : checker.certificate) : checker.holds c ->
  let n := links c in let L := length_of R c in let k := stiffness_of R c in
  forall fs f s, roots_of (D n L k) fs -> List.In f (checker.forces c) -> checker.force_shape f = Some s ->
  exists w : nat -> R,
  [/\ exists Fy, mode L k (nth 0 fs (Z.to_nat (checker.number f)).-1) (\col_(i < n) w i) Fy,
      forall i, (i < n)%N -> ~~ ((checker.first s <=? Z.of_nat i + 1) && (Z.of_nat i + 1 <=? checker.last s))%Z -> w i = 0,
      size (checker.angles s) = n,
      exists2 p, (p < n)%N & w p = 1 /\ value R (nth (checker.Rational 0 1, 0%Z) (checker.angles s) p).1 = 1 &
      forall i, (i < n)%N ->
        angle_stands (checker.shape_digits s) (nth (checker.Rational 0 1, 0%Z) (checker.angles s) i) (w i)].
Proof.
rewrite /checker.holds.
case/andP=> [/andP [/andP [/andP [/andP [/andP [/andP [/andP [/andP [/andP [cL ck] dL0] dk0] same] law] _] fsP] ts] ss] _].
move=> fs f s rfs f_in fsh.
have /andP [bf _] := proj1 (List.forallb_forall _ _) fsP f f_in.
have := proj1 (List.forallb_forall _ _) ss f f_in; rewrite fsh /= => sh.
exact: (shape_true cL ck dL0 dk0 same law rfs bf (proj1 (List.forallb_forall _ _) ts) sh).
Qed.
