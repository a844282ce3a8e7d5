(* The recursion in integers of checker.v is the recursion of the real chain, up to positive factors. *)
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp Require Import polyrcf.
From mathcomp Require Import zify ssrZ ring.
From Coq Require Import ZArith.
Undelimit Scope N_scope.
Delimit Scope nat_scope with N.
Require Import chain determinant string recursion forces definite modes eigenvalues.
Require checker.

Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Import Order.TTheory GRing.Theory Num.Theory.
Local Open Scope ring_scope.

(* Integers and fractions as real numbers. *)
Section Numbers.

Variable R : rcfType.

Definition zr (x : Z) : R := (int_of_Z x)%:~R.

Lemma zrD x y : zr (x + y)%Z = zr x + zr y.
Proof. by rewrite /zr -intrD; congr (_%:~R); lia. Qed.
Lemma zrM x y : zr (x * y)%Z = zr x * zr y.
Proof. by rewrite /zr -intrM; congr (_%:~R); lia. Qed.
Lemma zrN x : zr (- x)%Z = - zr x.
Proof. by rewrite /zr -mulrNz; congr (_%:~R); lia. Qed.
Lemma zrB x y : zr (x - y)%Z = zr x - zr y.
Proof. by rewrite -zrN -zrD. Qed.
Lemma zr0 : zr 0%Z = 0. Proof. by []. Qed.
Lemma zr1 : zr 1%Z = 1. Proof. by []. Qed.
Lemma zr_lt x y : (x <? y)%Z = (zr x < zr y).
Proof. by rewrite /zr ltr_int; lia. Qed.
Lemma zr_le x y : (x <=? y)%Z = (zr x <= zr y).
Proof. by rewrite /zr ler_int; lia. Qed.
Lemma zr_eq x y : (x =? y)%Z = (zr x == zr y).
Proof. by rewrite /zr eqr_int; lia. Qed.
Lemma zr_gt0 x : (0 <? x)%Z -> 0 < zr x. Proof. by rewrite zr_lt. Qed.

Definition value (x : checker.rational) : R := zr (checker.num x) / zr (checker.den x).

Lemma lessP x y : checker.proper x -> checker.proper y -> checker.less x y = (value x < value y).
Proof.
rewrite /checker.proper /checker.less /value !zr_lt !zrM zr0 => dx dy.
by rewrite ltr_pdivr_mulr // mulrAC ltr_pdivl_mulr.
Qed.

End Numbers.

Section Lists.

Lemma firstnE X (s : seq X) m : List.firstn m s = take m s.
Proof. by elim: m s => [|m IH] [|x s] //=; rewrite IH. Qed.
Lemma skipnE X (s : seq X) m : List.skipn m s = drop m s.
Proof. by elim: m s => [|m IH] [|x s] //=. Qed.
Lemma lengthE X (s : seq X) : List.length s = size s.
Proof. by elim: s => //= x s ->. Qed.
Lemma forallbE X (a : pred X) (s : seq X) : List.forallb a s = all a s.
Proof. by elim: s => //= x s ->. Qed.
Lemma filterE X (a : pred X) (s : seq X) : List.filter a s = filter a s.
Proof. by elim: s => //= x s ->. Qed.

End Lists.

Section Sweep.

Variables (R : rcfType) (dL dk : R) (L z k : nat -> R).
Hypotheses (dL0 : 0 < dL) (dk0 : 0 < dk).
Let zr := zr R.

(* A joint in integers stands for joint i. *)
Definition stands (x : checker.joint) (i : nat) : Prop :=
  [/\ zr (checker.len x) = dL * L i, zr (checker.dist x) = dL * z i & zr (checker.stiff x) = dk * k i].

Lemma sweep_stands (P D : Z) (F : R) : 0 < zr D -> zr P * dL = F * zr D * dk ->
  forall rest j i h m count negative (sigma : R),
  (forall l, (l <= size rest)%N -> stands (nth j (j :: rest) l) (i + l)) ->
  (forall l, (l <= size rest)%N -> 0 < z (i + l)%N) ->
  (forall l, (l < size rest)%N -> z (i + l)%N - z (i + l).+1 = L (i + l)%N) ->
  zr h = sigma * (H z k i).[F] -> zr m = sigma * (dk / dL) * (z i * k i * (G z k i).[F]) -> 0 < sigma ->
  sweep z k F i = (count, negative) ->
  checker.sweep P D j rest h m count negative = changes z k F (i + size rest).
Proof.
move=> D0 PD; elim=> [|j' rest IH] j i h m count negative sigma st zp Ls hE mE s0 sw.
  by rewrite /= addn0 /changes sw.
have [l0 z0 k0] := st 0%N isT; have [l1 z1 k1] := st 1%N isT.
rewrite /= addn0 in l0 z0 k0; rewrite /= addn1 in l1 z1 k1.
have zi : 0 < z i by have := zp 0%N isT; rewrite addn0.
have zi1 : 0 < z i.+1 by have := zp 1%N isT; rewrite addn1.
have Li : z i - z i.+1 = L i by have := Ls 0%N isT; rewrite addn0.
pose sigma' := zr D * dL * dk * z i * sigma.
have s'0 : 0 < sigma' by rewrite /sigma' !mulr_gt0.
rewrite /=; set t := (_ - _)%Z; set h' := (_ + _)%Z.
have tE : zr t = zr D * dk * sigma * z i * z i.+1 * (G z k i.+1).[F].
  rewrite /t /zr zrB !zrM -/zr hE mE l0 z1 G_at /bead Li.
  transitivity (zr D * dk * sigma * z i * z i.+1 * (k i * (G z k i).[F]) - (zr P * dL) * L i * (sigma * (H z k i).[F])).
    by field; rewrite gt_eqF.
  by rewrite PD; field; rewrite !gt_eqF.
have h'E : zr h' = sigma' * (H z k i.+1).[F].
  by rewrite /h' /zr zrD !zrM -/zr tE hE z0 z1 k1 H_at /sigma'; field.
have m'E : zr (checker.stiff j' * t)%Z = sigma' * (dk / dL) * (z i.+1 * k i.+1 * (G z k i.+1).[F]).
  by rewrite /zr zrM -/zr tE k1 /sigma'; field; rewrite gt_eqF.
rewrite -addSnnS; apply: (IH _ _ _ _ _ _ sigma') => //.
- by move=> l l_r; rewrite addSnnS (set_nth_default j) //; apply: (st l.+1).
- by move=> l l_r; rewrite addSnnS; apply: (zp l.+1).
- by move=> l l_r; rewrite addSnnS; apply: (Ls l.+1).
rewrite /= sw; have -> : (h' =? 0)%Z = ((H z k i.+1).[F] == 0).
  by rewrite (zr_eq R) -/zr h'E mulf_eq0 gt_eqF.
have -> : (h' <? 0)%Z = ((H z k i.+1).[F] < 0).
  by rewrite (zr_lt R) -/zr h'E pmulr_rlt0.
by move: (if _ then _ else _) => now; case: now; case: negative {sw} => /=; rewrite ?addn0 ?addn1.
Qed.

Lemma changes_stands (P D : Z) (F : R) (js : seq checker.joint) x0 : 0 < zr D -> zr P * dL = F * zr D * dk ->
  (0 < size js)%N ->
  (forall l, (l < size js)%N -> stands (nth x0 js l) l) ->
  (forall l, (l < size js)%N -> 0 < z l) ->
  (forall l, (l.+1 < size js)%N -> z l - z l.+1 = L l) ->
  checker.changes P D js = changes z k F (size js).-1.
Proof.
case: js => // j rest D0 PD _ st zp Ls.
have z0 : 0 < z 0%N by apply: (zp 0%N).
have {}st0 : stands j 0 by apply: (st 0%N).
rewrite /= -[size rest]/(0 + size rest)%N; apply: (sweep_stands (sigma := dL / z 0%N) D0 PD) => //.
- by move=> l l_r; rewrite (set_nth_default x0) //; apply: st.
- by case: st0 => a b c; rewrite b hornerC; field; rewrite gt_eqF.
- by case: st0 => a b c; rewrite c hornerC; field; rewrite !gt_eqF.
by rewrite divr_gt0.
Qed.

End Sweep.

(* The list of joints that the checker makes of integers. *)
Section Joints.

Variable R : rcfType.
Let zr := zr R.
Let x0 := checker.Joint 0 0 0.

Lemma size_joints ls ks : size ls = size ks -> size (checker.joints ls ks) = size ls.
Proof. by elim: ls ks => [|l ls IH] [|k ks] //= [/IH ->]. Qed.

Lemma nth_joints ls ks i : size ls = size ks -> (i < size ls)%N ->
  [/\ checker.len (nth x0 (checker.joints ls ks) i) = nth 0%Z ls i,
      checker.stiff (nth x0 (checker.joints ls ks) i) = nth 0%Z ks i &
      zr (checker.dist (nth x0 (checker.joints ls ks) i)) = distance (size ls) (fun j => zr (nth 0%Z ls j)) i].
Proof.
elim: ls ks i => [|l ls IH] [|k ks] // i [sz]; case: i => [|i] /=; last first.
  move=> i_l; have [-> -> ->] := IH ks i sz i_l; split=> //.
  by rewrite /distance big_add1.
move=> _; split=> //; rewrite /distance big_nat_recl //= /zr zrD -/zr; congr (_ + _).
case: ls sz IH => [|l' ls] sz IH; first by case: ks {sz IH} => [|? ?]; rewrite big_geq.
case: ks sz IH => // k' ks sz IH; have [_ _] := IH (k' :: ks) 0%N sz isT.
by rewrite /=.
Qed.

Lemma cut_inE (rest : seq checker.joint) : (0 < size rest)%N ->
  checker.cut_in rest = (find (fun j => (checker.stiff j =? 0)%Z) (take (size rest).-1 rest)).+1.
Proof.
elim: rest => // j [|j' rest] IH _ //.
rewrite -[checker.cut_in _]/(if (checker.stiff j =? 0)%Z then 1%N else (checker.cut_in (j' :: rest)).+1).
rewrite IH // -[take (size [:: j, j' & rest]).-1 _]/(j :: take (size (j' :: rest)).-1 (j' :: rest)).
move: (take _ _) => s; rewrite /=; by case: (_ =? _)%Z.
Qed.

End Joints.
