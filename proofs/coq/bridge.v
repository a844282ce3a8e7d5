(* The matrices and the polynomial that the comparison with the C++ core prints are those of the chain. *)
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp Require Import polyrcf.
From mathcomp Require Import zify ssrZ.
From Coq Require Import ZArith.
From mathcomp Require Import ring.
Delimit Scope nat_scope with N.
Require Import chain determinant string recursion forces definite modes eigenvalues integers polynomials sound sound_algebra.
Require checker.

Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Import Order.TTheory GRing.Theory Num.Theory.
Local Open Scope ring_scope.

Lemma nthE X (x : X) i s : List.nth i s x = nth x s i.
Proof. by elim: s i => [|y s IH] [|i] //=. Qed.
Lemma ltbE a b : Nat.ltb a b = (a < b)%N. Proof. by lia. Qed.
Lemma eqbE a b : Nat.eqb a b = (a == b). Proof. by lia. Qed.
Lemma max_nE a b : Nat.max a b = maxn a b. Proof. by lia. Qed.

Section Bridge.

Variables (R : rcfType) (c : checker.certificate).
Local Notation zr := (integers.zr R).
Let x0 := checker.Joint 0 0 0.
Let dL := checker.common (checker.lengths c).
Let dk := checker.common (checker.stiffness c).
Let ls := checker.cleared dL (checker.lengths c).
Let ks := checker.cleared dk (checker.stiffness c).
Let js := checker.joints ls ks.

Hypotheses (cL : checker.clears dL (checker.lengths c) ls) (ck : checker.clears dk (checker.stiffness c) ks).
Hypotheses (dL0 : (0 <? dL)%Z) (dk0 : (0 <? dk)%Z).
Hypotheses (same : Nat.eqb (length (checker.lengths c)) (length (checker.stiffness c))).

Let n := links c.
Let L := length_of R c.
Let k := stiffness_of R c.
Let z := distance n L.

Let insideE i : checker.inside js i = (i < n)%N.
Proof. by rewrite /checker.inside ltbE lengthE (size_js R cL ck same). Qed.

Let atE i : (i < n)%N -> zr (checker.dist (checker.joint_at js i)) / zr dL = z i /\
                         zr (checker.stiff (checker.joint_at js i)) / zr dk = k i.
Proof.
move=> i_n; rewrite /checker.joint_at nthE; have [_ -> ->] := joints_stand R cL ck same i_n.
by split; rewrite mulrAC mulfV ?mul1r // gt_eqF //; apply: zr_gt0.
Qed.

Let outside (o : 'I_1) : (n + o < n)%N = false. Proof. by rewrite ord1 addn0 ltnn. Qed.

Theorem entry_A_is (i j : 'I_(n + 1)) : value R (checker.entry_A dL js i j) = A n L i j.
Proof.
rewrite /checker.entry_A !insideE -(splitK i) -(splitK j).
case: (split i) => a; case: (split j) => b /=; rewrite ?outside ?ltn_ord /= ?andbF.
- rewrite block_mxEul mxE max_nE /value /= zrN mulNr; have [|-> _] // := atE (i := maxn a b).
  by rewrite gtn_max !ltn_ord.
- by rewrite block_mxEur mxE /value /= mul0r.
- by rewrite block_mxEdl mxE /value /= mul0r.
by rewrite block_mxEdr mxE /value /= mul0r.
Qed.

Theorem entry_B_is (i j : 'I_(n + 1)) : value R (checker.entry_B dL dk js i j) = B n L k i j.
Proof.
rewrite /checker.entry_B !insideE -(splitK i) -(splitK j).
case: (split i) => a; case: (split j) => b /=; rewrite ?outside ?ltn_ord /=.
- rewrite block_mxEul mxE eqbE -val_eqE /=; case: (_ == _); rewrite /value /= ?mul0r //.
  by have [|_ ->] // := atE (i := a).
- by rewrite block_mxEur mxE /value /=; have [|-> _] // := atE (i := a).
- by rewrite block_mxEdl !mxE /value /=; have [|-> _] // := atE (i := b).
by rewrite block_mxEdr mxE /value /= mul0r.
Qed.

Hypothesis law : checker.lawful js.

Theorem coefficient_is i : value R (checker.coefficient dL dk js i) = (D n L k)`_i.
Proof.
have L0 : zr dL != 0 by rewrite gt_eqF //; apply: zr_gt0.
have k0 : zr dk != 0 by rewrite gt_eqF //; apply: zr_gt0.
have two := two_links R cL ck dL0 dk0 same law; have lawful := chain_lawful R cL ck dL0 dk0 same law.
have g0 : zr (checker.gathered dL dk js) != 0.
  rewrite (gatheredE R cL ck dL0 dk0 same law); apply: gathered_neq0; [exact: zr_gt0|exact: zr_gt0|] => l l_n.
  by apply: (distance_gt0 lawful); apply: leq_ltn_trans l_n _; rewrite ltn_predL ltnW.
pose scaled := \poly_(i < size (D n L k)) ((D n L k)`_i * (zr dL / zr dk) ^+ i).
have e : as_poly R (checker.polynomial js) = - zr (checker.gathered dL dk js) *: scaled.
  apply: poly_ext => x; rewrite horner_as_poly (whole_polynomial (R := R) cL ck dL0 dk0 same law) hornerZ mulNr; congr (- (_ * _)).
  by rewrite horner_coef horner_poly; apply: eq_bigr => l _; rewrite -[RHS]mulrA -exprMn -[x * _ / _]mulrA [x * _]mulrC.
have zrX (a : Z) m : zr (a ^ Z.of_nat m)%Z = zr a ^+ m.
  elim: m => [|m IH]; first by rewrite Z.pow_0_r zr1.
  by rewrite Nat2Z.inj_succ Z.pow_succ_r ?zrM ?IH ?exprS //; apply: Nat2Z.is_nonneg.
have := congr1 (fun p : {poly R} => p`_i) e; rewrite coefZ !coef_poly {e} => ei.
have -> : checker.coefficient dL dk js i = checker.Rational
    (- List.nth i (checker.polynomial js) 0%Z * dk ^ Z.of_nat i) (checker.gathered dL dk js * dL ^ Z.of_nat i).
  by rewrite /checker.coefficient; have := size_js R cL ck same; rewrite -/js; case: (js) => [|j [|]] //= e; move: two; rewrite -e.
rewrite /value; cbn [checker.num checker.den].
move: (checker.gathered dL dk js) g0 ei => g g0 ei.
rewrite nthE -[(- _ * _)%Z]/(- nth 0%Z (checker.polynomial js) i * _)%Z.
rewrite !zrM zrN !zrX; case: (ltnP i (size (checker.polynomial js))) ei => [i_s|i_s].
  move=> ->; case: (ltnP i (size (D n L k))) => [_|i_D]; last by rewrite nth_default // !mulr0 oppr0 !mul0r.
  rewrite expr_div_n; move: ((D n L k)`_i) (zr dL ^+ i) (zr dk ^+ i) (expf_neq0 i L0) (expf_neq0 i k0) => d a b a0 b0.
  by move: (zr g) g0 => y y0; field; rewrite y0 a0 b0.
rewrite (nth_default 0%Z) // zr0 oppr0 !mul0r => /esym/eqP; rewrite mulf_eq0 oppr_eq0 (negPf g0) /=.
case: ltnP => [_|i_D _]; last by rewrite nth_default.
by rewrite mulf_eq0 expf_eq0 mulf_eq0 invr_eq0 (negPf L0) (negPf k0) andbF orbF => /eqP ->.
Qed.

End Bridge.
