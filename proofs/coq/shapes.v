(* The mode shape along one string of beads at a critical force, and the intervals of checker.v around it. *)
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp Require Import polyrcf.
From mathcomp Require Import zify ssrZ.
From Coq Require Import ZArith.
From mathcomp Require Import ring.
Require Import chain determinant string recursion forces integers.
Require checker.

Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Import Order.TTheory GRing.Theory Num.Theory.
Local Open Scope ring_scope.

Section Shape.

Variables (R : rcfType) (z k : nat -> R) (F : R) (m : nat).
Hypotheses (zp : forall i, (i <= m)%N -> 0 < z i) (kp : forall i, (0 < i < m)%N -> 0 < k i) (m0 : (0 < m)%N).
Hypothesis end_at_rest : (H z k m).[F] = 0.

Let K i : R := \prod_(l < i) k l.+1.

(* Deflections, slopes, and the angles that they make, the first of which is one. *)
Definition deflected i : R := if i is j.+1 then (if j == m then 0 else (H z k j).[F] / (z 0%N * K j)) else 0.
Definition slope i : R := if i is j.+1 then (G z k i).[F] / (z 0%N * K j) else k 0%N / z 0%N.
Definition turn i : R :=
  if i is j.+1 then (if k i == 0 then - deflected i / z i else z i * slope i / k i) else 1.

Let K_neq0 i : (i < m)%N -> K i != 0.
Proof.
move=> i_m; rewrite gt_eqF //; apply: prodr_gt0 => l _; apply: kp; rewrite ltn0Sn /=.
by apply: leq_ltn_trans (ltn_ord l) i_m.
Qed.
Let K_S i : K i.+1 = K i * k i.+1. Proof. by rewrite /K big_ord_recr. Qed.
Let z_neq0 i : (i <= m)%N -> z i != 0. Proof. by move=> h; rewrite gt_eqF // zp. Qed.
Let passive_last i : (i.+1 <= m)%N -> k i.+1 = 0 -> i.+1 = m.
Proof.
move=> i_m ki; apply/eqP; rewrite eqn_leq i_m leqNgt; apply/negP => h.
by have := kp (i := i.+1); rewrite h ki ltxx => /(_ isT).
Qed.

Lemma deflectedS i : (i <= m)%N -> deflected i.+1 = deflected i + z i * turn i.
Proof.
case: i => [|i] i_m.
  rewrite /deflected /turn eq_sym gtn_eqF // /K big_ord0 hornerC !mulr1 add0r.
  by field; rewrite z_neq0.
have Ki : K i != 0 by apply: K_neq0.
have z0 : z 0%N != 0 by apply: z_neq0.
have zi : z i.+1 != 0 by apply: z_neq0.
have i_neq : (i == m) = false by rewrite ltn_eqF.
rewrite /turn {2 3}/deflected i_neq; case: (altP (k i.+1 =P 0)) => [k0|k0].
  rewrite /deflected (passive_last i_m k0) eqxx; move: (_ / (_ * K i)) => d.
  by rewrite -(passive_last i_m k0); field.
have -> : deflected i.+2 = (H z k i.+1).[F] / (z 0%N * K i.+1).
  by rewrite /deflected; case: eqP => // e; rewrite {1}e end_at_rest mul0r.
rewrite /slope H_at K_S; move: (H z k i).[F] (G z k i.+1).[F] (z 0%N) z0 (K i) Ki (z i.+1) (k i.+1) k0.
by move=> h g u u0 y y0 v a a0; field; rewrite u0 y0 a0.
Qed.

Lemma slope_turn i : (i <= m)%N -> k i * turn i = z i * slope i.
Proof.
case: i => [|i] i_m; first by rewrite /turn /slope mulr1; field; rewrite z_neq0.
rewrite /turn; case: (altP (k i.+1 =P 0)) => [k0|k0]; last by rewrite mulrC divfK.
have e := passive_last i_m k0; have zm : z i.+1 ^+ 2 != 0 by rewrite expf_neq0 // z_neq0.
have : z i.+1 ^+ 2 * (G z k i.+1).[F] = 0.
  by have := end_at_rest; rewrite -e H_at k0 mul0r add0r.
by move/eqP; rewrite mulf_eq0 (negPf zm) /= => /eqP g0; rewrite /slope g0 k0 !mul0r mulr0.
Qed.

Lemma slopeS i : (i < m)%N -> slope i.+1 = slope i - F * bead z i * deflected i.+1.
Proof.
case: i => [|i] i_m; have z0 : z 0%N != 0 by apply: z_neq0.
  rewrite /slope /deflected eq_sym gtn_eqF // /K big_ord0 G_at !hornerC !mulr1.
  by move: (bead z 0) => b; field.
have Ki : K i != 0 by apply/K_neq0/ltnW.
have k0 : k i.+1 != 0 by rewrite gt_eqF // kp.
rewrite /slope /deflected ltn_eqF // G_at K_S; move: (bead z i.+1) => b.
by field; rewrite Ki z0 k0.
Qed.

End Shape.

(* Intervals of integers. *)
Section Spans.

Variables (R : rcfType) (dL dk : R) (L z k : nat -> R) (F : R) (m : nat).
Hypotheses (dL0 : 0 < dL) (dk0 : 0 < dk).
Hypotheses (zp : forall i, (i <= m)%N -> 0 < z i) (kp : forall i, (0 < i < m)%N -> 0 < k i) (m0 : (0 < m)%N).
Hypotheses (Ls : forall i, (i < m)%N -> z i - z i.+1 = L i) (Lp : forall i, (i < m)%N -> 0 < L i).
Hypotheses (kn : forall i, (i <= m)%N -> 0 <= k i).
Local Notation zr := (integers.zr R).
Local Notation stands := (stands dL dk L z k).
Local Notation turn := (turn z k F m).

Definition contains (s : checker.span) (x : R) : Prop :=
  [/\ 0 < zr (checker.over s), zr (checker.lower s) <= x * zr (checker.over s) &
      x * zr (checker.over s) <= zr (checker.upper s)].

Lemma product_above (p1 p2 p h hu : R) : 0 < p1 -> p1 <= p <= p2 -> h <= hu ->
  p * h <= (if 0 <= hu then p2 * hu else p1 * hu).
Proof.
move=> p10 /andP [a b] hh; have p0 : 0 < p by apply: lt_le_trans a.
case: (lerP 0 hu) => hu0.
  by apply: le_trans (_ : p * hu <= _); rewrite ?ler_pmul2l // ler_wpmul2r.
by apply: le_trans (_ : p * hu <= _); rewrite ?ler_pmul2l // ler_wnmul2r // ltW.
Qed.

Lemma product_below (p1 p2 p h hl : R) : 0 < p1 -> p1 <= p <= p2 -> hl <= h ->
  (if 0 <= hl then p1 * hl else p2 * hl) <= p * h.
Proof.
move=> p10 /andP [a b] hh; have p0 : 0 < p by apply: lt_le_trans a.
case: (lerP 0 hl) => hl0.
  by apply: le_trans (_ : p * hl <= _); rewrite ?ler_pmul2l // ler_wpmul2r.
by apply: le_trans (_ : p * hl <= _); rewrite ?ler_pmul2l // ler_wnmul2r // ltW.
Qed.

Let K i : R := \prod_(l < i) k l.+1.

Variables (P1 P2 D : Z).
Hypotheses (D0 : 0 < zr D) (P10 : 0 < zr P1) (PF : zr P1 <= F * zr D * dk / dL <= zr P2).

Lemma sweep_contains : forall rest j i hl hu ml mu sigma (s : R),
  (i + size rest)%N = m ->
  (forall l, (l <= size rest)%N -> stands (nth j (j :: rest) l) (i + l)) ->
  zr hl <= s * (H z k i).[F] <= zr hu ->
  zr ml <= s * (dk / dL) * (z i * k i * (G z k i).[F]) <= zr mu ->
  0 < s -> ((0 < size rest)%N -> zr sigma = s * (z 0%N * K i) / dL) ->
  size (checker.sweep_shape P1 P2 D j rest hl hu ml mu sigma) = size rest /\
  forall l, (l < size rest)%N ->
    contains (nth (checker.Span 0 0 1) (checker.sweep_shape P1 P2 D j rest hl hu ml mu sigma) l) (turn (i + l).+1).
Proof.
pose P := F * zr D * dk / dL; have PF' : zr P1 <= P <= zr P2 by exact: PF.
elim=> [|j' rest IH] j i hl hu ml mu sigma s im st /andP [hl_ hu_] /andP [ml_ mu_] s0 sE; first by split.
have i_m : (i < m)%N by rewrite -im addnS ltnS leq_addr.
have [l0 z0 k0] := st 0%N isT; have [l1 z1 k1] := st 1%N isT.
rewrite /= addn0 in l0 z0 k0; rewrite /= addn1 in l1 z1 k1.
have zi : 0 < z i by apply/zp/ltnW.
have zi1 : 0 < z i.+1 by apply: zp.
have zz : 0 < z 0%N by apply: zp.
have Li : 0 < L i by apply: Lp.
have Ki : 0 < K i.
  by apply: prodr_gt0 => l _; apply: kp; rewrite ltn0Sn /=; apply: leq_ltn_trans (ltn_ord l) i_m.
have {}sE := sE isT; set h := s * (H z k i).[F] in hl_ hu_.
set mm := s * (dk / dL) * (z i * k i * (G z k i).[F]) in ml_ mu_.
pose t := zr D * (dL * z i.+1) * mm - dL * L i * (P * h).
have tE : t = zr D * dk * s * z i * z i.+1 * (G z k i.+1).[F].
  rewrite /t /mm /h /P G_at /bead (Ls i_m); move: (zr D) => d.
  by field; rewrite !gt_eqF.
rewrite /=; set tl := (_ - checker.len j * (if (0 <=? hu)%Z then _ else _))%Z.
set tu := (_ - checker.len j * (if (0 <=? hl)%Z then _ else _))%Z.
have tl_ : zr tl <= t.
  rewrite /tl zrB !zrM z1 l0 /t; apply: ler_sub; first by rewrite ler_pmul2l // !mulr_gt0.
  rewrite ler_pmul2l ?mulr_gt0 //; apply: le_trans (product_above P10 PF' hu_) _.
  by rewrite (zr_le R) zr0; case: ifP; rewrite zrM.
have tu_ : t <= zr tu.
  rewrite /tu zrB !zrM z1 l0 /t; apply: ler_sub; first by rewrite ler_pmul2l // !mulr_gt0.
  rewrite ler_pmul2l ?mulr_gt0 //; apply: le_trans _ (product_below P10 PF' hl_).
  by rewrite (zr_le R) zr0; case: ifP; rewrite zrM.
have a_ : zr (D * checker.dist j * checker.stiff j')%Z = zr D * (dL * z i) * (dk * k i.+1) by rewrite !zrM z0 k1.
have k1n : 0 <= k i.+1 by apply: kn.
have a0 : 0 <= zr D * (dL * z i) * (dk * k i.+1) by rewrite !mulr_ge0 // ltW // !mulr_gt0.
pose s' := zr D * dL * dk * z i * s.
have s'0 : 0 < s' by rewrite /s' !mulr_gt0.
have h'E : s' * (H z k i.+1).[F] = zr D * (dL * z i) * (dk * k i.+1) * h + dL * z i.+1 * t.
  by rewrite tE H_at /s' /h; ring.
have m'E : s' * (dk / dL) * (z i.+1 * k i.+1 * (G z k i.+1).[F]) = dk * k i.+1 * t.
  by rewrite tE /s'; move: (zr D) => d; field; rewrite gt_eqF.
have zd1 : 0 <= dL * z i.+1 by rewrite mulr_ge0 // ltW.
have im' : (i.+1 + size rest)%N = m by rewrite addSnnS.
have st' l : (l <= size rest)%N -> stands (nth j' (j' :: rest) l) (i.+1 + l).
  by move=> l_r; rewrite addSnnS (set_nth_default j) //; apply: (st l.+1).
have := IH j' i.+1 (D * checker.dist j * checker.stiff j' * hl + checker.dist j' * tl)%Z
  (D * checker.dist j * checker.stiff j' * hu + checker.dist j' * tu)%Z (checker.stiff j' * tl)%Z
  (checker.stiff j' * tu)%Z (D * checker.dist j * checker.stiff j' * sigma)%Z s' im' st'.
case=> //.
- have e p q : zr (D * checker.dist j * checker.stiff j' * p + checker.dist j' * q)%Z =
      zr D * (dL * z i) * (dk * k i.+1) * zr p + dL * z i.+1 * zr q.
    by rewrite zrD zrM a_ zrM z1.
  by rewrite h'E !e; apply/andP; split; apply: ler_add; rewrite ler_wpmul2l.
- by rewrite m'E !zrM k1; apply/andP; split; rewrite ler_wpmul2l // mulr_ge0 // ltW.
- by move=> _; rewrite zrM a_ sE /K big_ord_recr /= -/(K i) /s'; move: (zr D) => d; field; rewrite gt_eqF.
move=> sz inside; split; first by rewrite /= sz.
case=> [|l] l_r; last by rewrite addnS -addSn; apply: inside.
rewrite /= addn0 /turn (zr_eq R) k1 zr0 mulf_eq0 gt_eqF //=.
have zK : z 0%N * K i != 0 by rewrite gt_eqF // mulr_gt0.
case: (altP (k i.+1 =P 0)) => [k10|k10] /=; rewrite /contains /=.
  have o : zr (checker.dist j' * sigma) = z i.+1 * s * (z 0%N * K i).
    by rewrite zrM z1 sE; field; rewrite gt_eqF.
  have e : - deflected z k F m i.+1 / z i.+1 * zr (checker.dist j' * sigma) = - h.
    by rewrite o /= ltn_eqF // /h -/(K i); move: (z 0%N * K i) zK => y y0; field; rewrite y0 gt_eqF.
  by rewrite e !zrN !ler_opp2 hl_ hu_ o !mulr_gt0.
have k1p : 0 < k i.+1 by rewrite lt0r k10.
have o : zr (D * checker.dist j * checker.stiff j' * sigma) = zr D * z i * (dk * k i.+1) * s * (z 0%N * K i).
  by rewrite zrM a_ sE; move: (zr D) => d; field; rewrite gt_eqF.
have e : z i.+1 * slope z k F i.+1 / k i.+1 * zr (D * checker.dist j * checker.stiff j' * sigma) = t.
  rewrite o tE /= -/(K i); move: (zr D) (z 0%N * K i) zK => d y y0.
  by field; rewrite y0 k10.
by rewrite e tl_ tu_ o !mulr_gt0.
Qed.

End Spans.
