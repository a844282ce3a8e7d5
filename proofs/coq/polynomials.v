(* The polynomials in integers of checker.v are those of the real chain. *)
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

Lemma revE X (s : seq X) : List.rev s = rev s.
Proof.
have catE (a b : seq X) : List.app a b = a ++ b by elim: a => //= x a ->.
by elim: s => //= x s ->; rewrite rev_cons -cats1 catE.
Qed.

Section Values.

Variable R : rcfType.
Local Notation zr := (integers.zr R).

(* The value of a list of coefficients, from the constant up. *)
Fixpoint at_force (p : seq Z) (x : R) : R := if p is a :: p' then zr a + x * at_force p' x else 0.

Lemma at_plus p q x : at_force (checker.plus p q) x = at_force p x + at_force q x.
Proof.
elim: p q => [|a p IH] [|b q] /=; rewrite ?add0r ?addr0 //.
by rewrite IH zrD; ring.
Qed.

Lemma at_scale c p x : at_force (checker.scale c p) x = zr c * at_force p x.
Proof. by elim: p => [|a p IH] /=; rewrite ?mulr0 // IH zrM; ring. Qed.

Lemma at_times p q x : at_force (checker.times p q) x = at_force p x * at_force q x.
Proof.
elim: p => [|a p IH]; first by rewrite mul0r.
by rewrite /= at_plus at_scale /= IH zr0; ring.
Qed.

Lemma at_alternated s p x : at_force (checker.alternated s p) x = zr s * at_force p (- x).
Proof.
elim: p s => [|a p IH] s /=; first by rewrite mulr0.
by rewrite IH zrM zrN; ring.
Qed.

Lemma at_cat p q x : at_force (p ++ q) x = at_force p x + x ^+ size p * at_force q x.
Proof. by elim: p => [|a p IH] /=; rewrite ?expr0 ?mul1r ?add0r // IH exprS; ring. Qed.

Lemma at_rev p x : x != 0 -> x ^+ size p * at_force p x^-1 = x * at_force (rev p) x.
Proof.
move=> x0; elim: p => [|a p IH]; first by rewrite /= !mulr0.
rewrite rev_cons -cats1 at_cat size_rev /= mulr0 addr0 [RHS]mulrDr -IH exprS.
by move: (at_force p _) (x ^+ _) => v X; field.
Qed.

Lemma at_zeros p x : List.forallb (Z.eqb 0) p -> at_force p x = 0.
Proof.
by elim: p => // -[|a|a] p IH //= /IH ->; rewrite zr0 mulr0 addr0.
Qed.

(* p_i a^i b = q_i c^i d for all i *)
Lemma at_proportional p q (a b c d : Z) x : zr a != 0 -> checker.proportional p q a b c d ->
  zr b * at_force p x = zr d * at_force q (x * zr c / zr a).
Proof.
move=> a0; elim: p q b d => [|u p IH] q b d.
  by move=> h; rewrite mulr0 (at_zeros _ (p := q)) ?mulr0 //; case: q h.
case: q => [|v q].
  by move=> h; rewrite [at_force [::] _]/= mulr0 (at_zeros _ (p := u :: p)) ?mulr0.
rewrite [checker.proportional _ _ _ _ _ _]/= => /andP [uv /IH e].
have {}uv : zr u * zr b = zr v * zr d by apply/eqP; move: uv; rewrite (zr_eq R) !zrM.
rewrite /=; move: e; rewrite !zrM; move: (at_force p x) (at_force q _) => P Q e.
rewrite mulrDr mulrC uv [in LHS]mulrCA.
have -> : zr b * P = zr c * zr d * Q / zr a by rewrite -e; field.
by field.
Qed.

Lemma homogeneousP p (P D : Z) : (0 < D)%Z -> 0 < zr (checker.homogeneous p P D).2 /\
  zr (checker.homogeneous p P D).1 = zr (checker.homogeneous p P D).2 * at_force p (zr P / zr D).
Proof.
move=> D0; have {D0} d0 : 0 < zr D by apply: zr_gt0; apply/Z.ltb_lt.
elim: p => [|a p] /=; first by rewrite mulr0 zr0 zr1; split=> //; exact: ltr01.
case: (checker.homogeneous p P D) => v d /= [dp e]; rewrite zrM; split; first exact: mulr_gt0.
by rewrite zrD !zrM e; field; rewrite gt_eqF.
Qed.

Lemma sgn_product a b : (Z.sgn a * Z.sgn b =? -1)%Z -> zr a * zr b < 0.
Proof.
move=> h; rewrite -zrM -(zr0 R) -(zr_lt R); apply/Z.ltb_lt.
by move: h; case: a => [|a|a]; case: b => [|b|b].
Qed.

Lemma signs_differ p x y : checker.proper x -> checker.proper y ->
  (checker.sign_at p x * checker.sign_at p y =? -1)%Z -> at_force p (value R x) * at_force p (value R y) < 0.
Proof.
move=> /Z.ltb_lt dx /Z.ltb_lt dy /sgn_product.
have [hx ->] := homogeneousP p (checker.num x) dx; have [hy ->] := homogeneousP p (checker.num y) dy.
by rewrite mulrACA pmulr_rlt0 // mulr_gt0.
Qed.

(* The same as a polynomial. *)
Definition as_poly (p : seq Z) : {poly R} := \poly_(i < size p) zr (nth 0%Z p i).

Lemma horner_as_poly p x : (as_poly p).[x] = at_force p x.
Proof.
rewrite horner_poly; elim: p => [|a p IH]; first by rewrite big_ord0.
rewrite /= big_ord_recl expr0 mulr1 -IH mulr_sumr; congr (_ + _).
by apply: eq_bigr => i _; rewrite lift0 exprS mulrCA.
Qed.

End Values.

Section Sweep.

Variables (R : rcfType) (dL dk : R) (L z k : nat -> R).
Hypotheses (dL0 : 0 < dL) (dk0 : 0 < dk).
Local Notation zr := (integers.zr R).
Local Notation stands := (stands dL dk L z k).

(* What the recursion in integers has gathered on the way. *)
Definition gathered (m : nat) : R := dL / z 0%N * \prod_(l < m) (dL * dk * z l).

Lemma sweep_polynomial_stands x : forall rest j i h m (sigma : R),
  (forall l, (l <= size rest)%N -> stands (nth j (j :: rest) l) (i + l)) ->
  (forall l, (l <= size rest)%N -> 0 < z (i + l)%N) ->
  (forall l, (l < size rest)%N -> z (i + l)%N - z (i + l).+1 = L (i + l)%N) ->
  at_force h x = sigma * (H z k i).[x * dL / dk] ->
  at_force m x = sigma * (dk / dL) * (z i * k i * (G z k i).[x * dL / dk]) ->
  at_force (checker.sweep_polynomial j rest h m) x =
  sigma * (\prod_(l < size rest) (dL * dk * z (i + l)%N)) * (H z k (i + size rest)).[x * dL / dk].
Proof.
set F := x * dL / dk; elim=> [|j' rest IH] j i h m sigma st zp Ls hE mE.
  by rewrite /= big_ord0 mulr1 addn0.
have [l0 z0 k0] := st 0%N isT; have [l1 z1 k1] := st 1%N isT.
rewrite /= addn0 in l0 z0 k0; rewrite /= addn1 in l1 z1 k1.
have zi : 0 < z i by have := zp 0%N isT; rewrite addn0.
have zi1 : 0 < z i.+1 by have := zp 1%N isT; rewrite addn1.
have Li : z i - z i.+1 = L i by have := Ls 0%N isT; rewrite addn0.
have xE : x = F * dk / dL by rewrite /F; field; rewrite !gt_eqF.
rewrite /=; set t := checker.plus _ (0%Z :: _); set h' := checker.plus (checker.scale _ h) _.
have tE : at_force t x = dk * sigma * z i * z i.+1 * (G z k i.+1).[F].
  rewrite /t at_plus at_scale /= at_scale zr0 zrN hE mE l0 z1 G_at /bead Li {1}xE.
  by field; rewrite !gt_eqF.
have h'E : at_force h' x = dL * dk * z i * sigma * (H z k i.+1).[F].
  by rewrite /h' at_plus !at_scale zrM tE hE z0 z1 k1 H_at; ring.
have m'E : at_force (checker.scale (checker.stiff j') t) x =
    dL * dk * z i * sigma * (dk / dL) * (z i.+1 * k i.+1 * (G z k i.+1).[F]).
  by rewrite at_scale tE k1; field; rewrite gt_eqF.
rewrite big_ord_recl addn0 -addSnnS (IH _ i.+1 _ _ (dL * dk * z i * sigma)) //.
- have -> : \prod_(l < size rest) (dL * dk * z (i.+1 + l)%N) = \prod_(l < size rest) (dL * dk * z (i + lift ord0 l)%N).
    by apply: eq_bigr => l _; rewrite lift0 addSnnS.
  by move: (\prod_(_ < _) _) (_.[F]) => P V; ring.
- by move=> l l_r; rewrite addSnnS (set_nth_default j) //; apply: (st l.+1).
- by move=> l l_r; rewrite addSnnS; apply: (zp l.+1).
by move=> l l_r; rewrite addSnnS; apply: (Ls l.+1).
Qed.

Lemma polynomial_stands (js : seq checker.joint) x0 x : (0 < size js)%N ->
  (forall l, (l < size js)%N -> stands (nth x0 js l) l) ->
  (forall l, (l < size js)%N -> 0 < z l) ->
  (forall l, (l.+1 < size js)%N -> z l - z l.+1 = L l) ->
  at_force (checker.polynomial js) x = gathered (size js).-1 * (H z k (size js).-1).[x * dL / dk].
Proof.
case: js => // j rest _ st zp Ls; have z0 : 0 < z 0%N by apply: (zp 0%N).
have {}st0 : stands j 0 by apply: (st 0%N).
rewrite /= (sweep_polynomial_stands (i := 0) (sigma := dL / z 0%N)) //.
- by move=> l l_r; rewrite (set_nth_default x0) //; apply: st.
- by case: st0 => a b c; rewrite /= b hornerC mulr0 addr0; field; rewrite gt_eqF.
by case: st0 => a b c; rewrite /= c hornerC mulr0 addr0; field; rewrite !gt_eqF.
Qed.

Lemma gathered_neq0 m : (forall l, (l <= m)%N -> 0 < z l) -> gathered m != 0.
Proof.
move=> zp; rewrite /gathered mulf_neq0 ?mulf_neq0 ?invr_eq0 ?gt_eqF ?zp //.
by apply: prodr_gt0 => l _; rewrite !mulr_gt0 // zp // ltnW.
Qed.

End Sweep.

(* Polynomials with fractions as coefficients, as certificates state them. *)
Section Fractions.

Variable R : rcfType.
Local Notation zr := (integers.zr R).

Definition stated (s : seq checker.rational) : {poly R} :=
  \poly_(i < size s) value R (nth (checker.Rational 0 1) s i).

Lemma cleared_stated d s p : checker.clears d s p -> as_poly R p = zr d *: stated s.
Proof.
have clearsP : forall (xs : seq checker.rational) (ys : seq Z), checker.clears d xs ys -> size ys = size xs /\
    forall i, (i < size xs)%N -> zr (nth 0%Z ys i) = zr d * value R (nth (checker.Rational 0 1) xs i).
  elim=> [|x xs IH] [|y ys] //= /andP [/andP [dx e] /IH [-> h]]; split=> // -[|i] i_x; last exact: h.
  move: e; rewrite (zr_eq R) !zrM => /eqP e; have d0 : 0 < zr (checker.den x) by apply: zr_gt0.
  by apply: (mulIf (negbT (gt_eqF d0))); rewrite /= e /value; field; rewrite gt_eqF.
case/clearsP => sz h; apply/polyP => i; rewrite coefZ !coef_poly sz.
by case: ifP => [i_s|_]; rewrite ?mulr0 // h.
Qed.

Lemma at_cleared d s p x : checker.clears d s p -> at_force p x = zr d * (stated s).[x].
Proof. by move=> c; rewrite -horner_as_poly (cleared_stated c) hornerZ. Qed.

End Fractions.
