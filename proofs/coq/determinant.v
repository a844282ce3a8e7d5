(* D(F) = det(A F + B) along the chain: from the end point to the base by determinants of tails, from the base to the
   end point by the recursion (theorem "Recursion" (c) of theorems.md). *)
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp Require Import ring.
Require Import chain.

Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Import GRing.Theory.
Local Open Scope ring_scope.

Section Bordered.

Variable R : comRingType.
Implicit Types (z k : nat -> R) (F c : R) (m : nat).

Definition shifted (f : nat -> R) (i : nat) : R := f i.+1.

(* K - F M, bordered by z, with c in the corner: rows and columns 0 ... m. *)
Definition entry m z k F c (i j : nat) : R :=
  if i == m then (if j == m then c else z j)
  else if j == m then z i else k i *+ (i == j) - F * z (maxn i j).

Definition bordered m z k F c : 'M[R]_m.+1 := \matrix_(i, j) entry m z k F c i j.
Definition bare m z k F : 'M[R]_m := \matrix_(i, j) (k i *+ (val i == val j) - F * z (maxn i j)).

Lemma det_corner m z k F c :
  \det (bordered m z k F c) = \det (bordered m z k F 0) + c * \det (bare m z k F).
Proof.
rewrite !(expand_det_row _ ord_max) !big_ord_recr /= !mxE /entry !eqxx mul0r addr0.
congr (_ + _).
  apply: eq_bigr => i _; rewrite !mxE /entry eqxx /= !eqn_leq [(m <= i)%N]leqNgt ltn_ord andbF.
  congr (_ * _); rewrite /cofactor; congr (_ * \det _); apply/matrixP=> a b; rewrite !mxE /entry.
  by rewrite lift_max !eqn_leq [(m <= a)%N]leqNgt ltn_ord andbF.
congr (_ * _); rewrite /cofactor /= -signr_odd addnn odd_double expr0 mul1r.
congr (\det _); apply/matrixP=> a b; rewrite !mxE /entry !lift_max !eqn_leq.
by rewrite [(m <= a)%N]leqNgt [(m <= b)%N]leqNgt !ltn_ord !andbF.
Qed.

Lemma delta_mul m (a b : 'I_m) (X : 'M[R]_m) i j : (delta_mx a b *m X) i j = X b j *+ (i == a).
Proof.
rewrite mxE (bigD1 b) //= mxE eqxx andbT big1 ?addr0; last first.
  by move=> l /negPf l_b; rewrite mxE l_b andbF mul0r.
by case: (i == a); rewrite ?mul1r ?mul0r.
Qed.

Lemma mul_delta m (a b : 'I_m) (X : 'M[R]_m) i j : (X *m delta_mx a b) i j = X i a *+ (j == b).
Proof.
rewrite mxE (bigD1 a) //= mxE eqxx /= big1 ?addr0; last first.
  by move=> l /negPf l_a; rewrite mxE l_a mulr0.
by case: (j == b); rewrite ?mulr1 ?mulr0.
Qed.

Lemma det_shear m (a b : 'I_m) F : a != b -> \det (1%:M + F *: delta_mx a b : 'M[R]_m) = 1.
Proof.
have lower (u v : 'I_m) : (v < u)%N -> \det (1%:M + F *: delta_mx u v : 'M[R]_m) = 1.
  move=> v_u; rewrite det_trig.
    by rewrite big1 // => i _; rewrite !mxE eqxx; case: (altP (i =P u)) => [->|] /=;
       rewrite ?(gtn_eqF v_u) -?val_eqE /= ?mulr0 ?addr0 ?(gtn_eqF v_u) ?mulr0 ?addr0.
  apply/is_trig_mxP => i j i_j; rewrite !mxE -!val_eqE /= (ltn_eqF i_j) mulr0n add0r.
  case: (altP (val i =P val u)) => [iu|] /=; rewrite ?mulr0 //.
  case: (altP (val j =P val v)) => [jv|] /=; rewrite ?mulr0 //.
  by move: i_j v_u; rewrite iu jv => /ltn_trans h /h; rewrite ltnn.
move=> a_b; case: (ltngtP a b) => [|/lower //|/val_inj ab]; last by rewrite ab eqxx in a_b.
move=> /lower ba; rewrite -det_tr -[RHS]ba; congr (\det _); apply/matrixP=> i j.
by rewrite !mxE eq_sym andbC.
Qed.

Lemma det_step m z k F c :
  \det (bordered m.+1 z k F c) =
  (k 0%N + F * z 0%N + F ^+ 2 * c) * \det (bordered m (shifted z) (shifted k) F c)
  - (z 0%N + F * c) ^+ 2 * \det (bare m (shifted z) (shifted k) F).
Proof.
set N := bordered m.+1 z k F c.
have last0 : ord0 != (ord_max : 'I_m.+2) by [].
pose U : 'M[R]_m.+2 := 1%:M + F *: delta_mx ord0 ord_max.
pose V : 'M[R]_m.+2 := 1%:M + F *: delta_mx ord_max ord0.
have -> : \det N = \det (U *m N *m V).
  by rewrite !det_mulmx !det_shear // mul1r mulr1.
have at_ i j : (U *m N *m V) i j =
    N i j + F * N ord_max j *+ (i == ord0) + F * N i ord_max *+ (j == ord0)
    + F ^+ 2 * c *+ ((i == ord0) && (j == ord0)).
  have mulU i' j' : (U *m N) i' j' = N i' j' + F * (N ord_max j' *+ (i' == ord0)).
    by rewrite mulmxDl mul1mx -scalemxAl mxE; congr (_ + _); rewrite mxE delta_mul.
  rewrite mulmxDr mulmx1 -scalemxAr mxE [in X in _ + X = _]mxE mul_delta !mulU.
  have -> : N ord_max ord_max = c by rewrite mxE /entry !eqxx.
  by case: (i == _); case: (j == _); rewrite /= ?mulr0n ?mulr1n; ring.
move: (U *m N *m V) at_ => W at_; clear U V.
have Wtail i j : W (lift ord0 i) (lift ord0 j) = bordered m (shifted z) (shifted k) F c i j.
  by rewrite at_ /= !mulr0n !addr0 !mxE /entry /shifted !lift0 !eqSS maxnSS.
have W0 j : W ord0 (lift ord0 j) = (z 0%N + F * c) *+ (j == ord_max).
  rewrite at_ /= ?andbF ?mulr0n ?addr0 !mxE /entry /= ?lift0 ?eqSS ?eqxx.
  by rewrite -[j == ord_max]val_eqE /= max0n; case: (_ == m); rewrite ?mulr0n ?mulr1n; ring.
have W00 : W ord0 ord0 = k 0%N + F * z 0%N + F ^+ 2 * c.
  by rewrite at_ /= !mulr1n !mxE /entry /= !eqxx maxnn mulr1n; ring.
have Wlast : W ord_max ord0 = z 0%N + F * c.
  by rewrite at_ eqxx /= !mulr1n !mxE /entry !eqxx /=; ring.
have Wcol (i : 'I_m.+1) : i != ord_max -> W (lift ord0 i) ord0 = 0.
  rewrite -[i == ord_max]val_eqE /= => /negPf i_m; rewrite at_ /= ?mulr0n ?mulr1n ?addr0 !mxE /entry /= !eqxx.
  by rewrite /bump leq0n add1n eqSS i_m maxn0 mulr0n; ring.
rewrite (expand_det_row _ ord0) big_ord_recl W00; congr (_ * _ + _).
  rewrite /cofactor expr0 mul1r; congr (\det _); apply/matrixP=> i j.
  by rewrite -Wtail mxE mxE.
rewrite big_ord_recr big1 /= ?add0r; last first.
  by move=> i _; rewrite W0 -(inj_eq val_inj) /= ltn_eqF ?mulr0n ?mul0r.
have max_ : lift ord0 ord_max = ord_max :> 'I_m.+2 by apply: val_inj.
rewrite W0 eqxx mulr1n /cofactor; set P := row' _ _.
have P0 i : P i ord0 = W (lift ord0 i) ord0 by do 2![rewrite [LHS]mxE]; congr (W _ _); apply: val_inj.
rewrite (expand_det_col _ ord0) (bigD1 ord_max) //= big1 ?addr0; last first.
  by move=> i i_m; rewrite P0 Wcol ?mul0r.
rewrite P0 max_ Wlast /cofactor /bump /= ?leq0n ?add0n ?addn0.
have -> : \det (row' ord_max (col' ord0 P)) = \det (bare m (shifted z) (shifted k) F).
  congr (\det _); apply/matrixP=> i j; do 4![rewrite [LHS]mxE].
  have -> : lift (lift ord0 ord_max) (lift ord0 j) = lift ord0 (lift ord_max j) :> 'I_m.+2.
    by apply: val_inj; rewrite /= /bump !leq0n !add1n !ltnS [(m <= j)%N]leqNgt ltn_ord.
  rewrite Wtail !mxE /entry !lift_max !eqn_leq.
  by rewrite [(m <= i)%N]leqNgt [(m <= j)%N]leqNgt !ltn_ord !andbF.
move: (\det _) (z 0%N + F * c) => X w; have sq : (-1) ^+ m * (-1) ^+ m = 1 :> R by rewrite -expr2 sqrr_sign.
rewrite add1n [(-1) ^+ m.+1]exprS; move: ((-1) ^+ m) sq => s sq.
by transitivity (- (w ^+ 2 * (s * s) * X)); [ring | rewrite sq mulr1].
Qed.

End Bordered.

Section Recursion.

Variable R : fieldType.
Implicit Types (z k : nat -> R) (F : R) (m j : nat).

(* m_i of theorem "Spring and mass" *)
Definition bead z j := (z j - z j.+1) / (z j * z j.+1).

(* One link: (H_i, G_i) to (H_{i+1}, G_{i+1}). *)
Definition link z k F (s : R * R) j :=
  let g := k j * s.2 - F * bead z j * s.1 in (k j.+1 * s.1 + z j.+1 ^+ 2 * g, g).

Fixpoint state z k F (s : R * R) j := if j is i.+1 then link z k F (state z k F s i) i else s.

Lemma stateS z k F s j : state z k F s j.+1 = state (shifted z) (shifted k) F (link z k F s 0) j.
Proof. by elim: j => //= j ->. Qed.

(* From any state on, what the recursion ends in by the determinants of the links that are left. *)
Lemma state_det m z k F s : (forall i, (i <= m)%N -> z i != 0) ->
  (state z k F s m).1 =
  (\det (bare m (shifted z) (shifted k) F) - F * \det (bordered m (shifted z) (shifted k) F 0) / z 0%N) * s.1
  - \det (bordered m (shifted z) (shifted k) F 0) * k 0%N * s.2.
Proof.
elim: m z k s => [|m IH] z k s nz.
  have -> : bordered 0 (shifted z) (shifted k) F 0 = 0 by apply/matrixP=> i j; rewrite !ord1 !mxE.
  by rewrite /= det_mx00 det0 mulr0 mul0r subr0 mul1r !mul0r subr0.
rewrite stateS IH; last by move=> i i_m; apply: nz.
have D1 := det_step m (shifted z) (shifted k) F 1; have D0 := det_step m (shifted z) (shifted k) F 0.
move: D1; rewrite !(det_corner _ _ _ _ 1) D0.
have z0 : z 0%N != 0 by apply: nz. have z1 : z 1%N != 0 by apply: nz.
rewrite /link /bead /shifted /=.
move: (\det (bare m _ _ F)) (\det (bordered m _ _ F 0)) (\det (bare m.+1 _ _ F)) => e d e1 /(canRL (addKr _)).
by rewrite !mul1r => ->; field; rewrite z0 z1.
Qed.

(* The start of the recursion. *)
Definition start z : R * R := (z 0%N ^+ 2, 1).

Theorem recursion_det m z k F : (forall i, (i <= m)%N -> z i != 0) ->
  \det (bordered m.+1 z k F 0) = - (state z k F (start z) m).1.
Proof.
move=> nz; rewrite state_det // det_step /=.
move: (\det _) (\det _) (nz 0%N (leq0n m)) => e d z0; by field.
Qed.

End Recursion.
