(* The potential energy of a loaded chain at any angles, and what its second variation is: that of stability.v. Theorem
   "Stable below the lowest force" of theorems.md.

   No analysis is assumed. Cosine and sine are any two functions with the bounds that their series have,
   1 - x^2/2 <= cos x <= 1 - x^2/2 + x^4/24 and |sin x - x| <= |x|^3/6; so the energy along a curve of shapes is compared
   with the square of the parameter, with a remainder of third order. *)
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp Require Import ring.
Require Import chain determinant recursion forces definite stability.

Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Import Order.TTheory GRing.Theory Num.Theory.
Local Open Scope ring_scope.

Section Potential.

Variables (R : rcfType) (n : nat) (L k : nat -> R).
Hypothesis L_ge0 : forall i, (i < n)%N -> 0 <= L i.

Variables (cosine sine : R -> R).
Hypothesis cosine_bounds : forall x, 1 - x ^+ 2 / 2%:R <= cosine x <= 1 - x ^+ 2 / 2%:R + x ^+ 4 / 24%:R.
Hypothesis sine_bounds : forall x, `|sine x - x| <= `|x| ^+ 3 / 6%:R.

Implicit Types (q u w : 'cV[R]_n) (F t : R).

(* The end point, delta_x of (21), and the potential E - F delta_x. *)
Definition reach q : R := \sum_(j < n) L j * cosine (theta q j).
Definition height q : R := \sum_(j < n) L j * sine (theta q j).
Definition potential F q : R := strain k q / 2%:R - F * (\sum_(j < n) L j - reach q).

Lemma theta0 j : theta (0 : 'cV[R]_n) j = 0.
Proof. by rewrite /theta big1 // => i _; rewrite mxE. Qed.

Lemma cosine0 : cosine 0 = 1.
Proof. by have := cosine_bounds 0; rewrite !expr0n /= !mul0r subr0 addr0 => h; apply/eqP; rewrite eq_le andbC. Qed.

Lemma potential0 F : potential F 0 = 0.
Proof.
rewrite /potential /strain big1 => [|i _]; last by rewrite mxE expr0n mulr0.
have -> : reach 0 = \sum_(j < n) L j by apply: eq_bigr => j _; rewrite theta0 cosine0 mulr1.
by rewrite subrr mulr0 mul0r subr0.
Qed.

(* At every shape, however large. *)
Theorem potential_to_second_order F q :
  `|potential F q - potential F 0 - second_variation L k F q / 2%:R| <=
  `|F| * (\sum_(j < n) L j * theta q j ^+ 4 / 24%:R).
Proof.
have -> : potential F q - potential F 0 - second_variation L k F q / 2%:R =
          F * \sum_(j < n) L j * (cosine (theta q j) - (1 - theta q j ^+ 2 / 2%:R)).
  rewrite potential0 second_variationE /potential /reach /shortening.
  have -> : \sum_(j < n) L j * (cosine (theta q j) - (1 - theta q j ^+ 2 / 2%:R)) =
            \sum_(j < n) L j * cosine (theta q j) - \sum_(j < n) L j + (\sum_(j < n) L j * theta q j ^+ 2) / 2%:R.
    by rewrite mulr_suml -sumrB -big_split /=; apply: eq_bigr => j _; field.
  by move: (\sum_(j < n) L j * cosine _) (\sum_(j < n) L j) (\sum_(j < n) L j * _ ^+ 2) (strain _ _) => *; field.
rewrite normrM; apply: ler_wpmul2l => //.
apply: le_trans (ler_norm_sum _ _ _) _; apply: ler_sum => j _.
have Lj := L_ge0 (ltn_ord j).
rewrite normrM (ger0_norm Lj) -mulrA; apply: ler_wpmul2l => //.
have /andP [lo hi] := cosine_bounds (theta q j).
by rewrite ger0_norm ?subr_ge0 // ler_subl_addl.
Qed.

Lemma axis_theta q : ((S0 n L)^T *m q) 0 0 = \sum_(j < n) L j * theta q j.
Proof.
rewrite mxE; under eq_bigr do rewrite !mxE distance_ord mulr_suml.
rewrite exchange_big /=; apply: eq_bigr => l _; rewrite /theta big_distrr [RHS]big_mkcond /=; apply: eq_bigr => i _.
by case: (i <= l)%N; rewrite ?mulr1n // mulr0n mul0r.
Qed.

(* The constraint y = 0 is S0^T q = 0 to first order. *)
Theorem height_to_first_order q :
  `|height q - ((S0 n L)^T *m q) 0 0| <= \sum_(j < n) L j * `|theta q j| ^+ 3 / 6%:R.
Proof.
rewrite axis_theta.
rewrite /height -sumrB; apply: le_trans (ler_norm_sum _ _ _) _; apply: ler_sum => j _.
rewrite -mulrBr normrM (ger0_norm (L_ge0 (ltn_ord j))) -mulrA.
by apply: ler_wpmul2l; rewrite ?L_ge0.
Qed.

(* A curve of shapes t u + t^2 w(t) through the straight one, w bounded for |t| <= 1. *)
Section Curve.

Variables (u : 'cV[R]_n) (w : R -> 'cV[R]_n) (C : R).
Hypothesis w_bounded : forall t i, `|t| <= 1 -> `|w t i 0| <= C.

Definition along t : 'cV[R]_n := t *: u + t ^+ 2 *: w t.

Let U : R := \sum_(i < n) `|u i 0|.
Let W : R := \sum_(i < n) C.

Lemma theta_bound q (b : 'I_n -> R) j : (forall i, `|q i 0| <= b i) -> `|theta q j| <= \sum_(i < n) b i.
Proof.
move=> qb; rewrite /theta; apply: le_trans (ler_norm_sum _ _ _) _.
rewrite big_mkcond /=; apply: ler_sum => i _; case: (i <= j)%N; first exact: qb.
exact: le_trans (normr_ge0 _) (qb i).
Qed.

Lemma theta_along t j : theta (along t) j = t * theta u j + t ^+ 2 * theta (w t) j.
Proof. by rewrite /theta !mulr_sumr -big_split /=; apply: eq_bigr => i _; rewrite !mxE. Qed.

Lemma theta_u j : `|theta u j| <= U. Proof. exact: theta_bound. Qed.
Lemma theta_w t j : `|t| <= 1 -> `|theta (w t) j| <= W.
Proof. by move=> t1; apply: theta_bound => i; apply: w_bounded. Qed.

Lemma small_power t m p : `|t| <= 1 -> (m <= p)%N -> `|t| ^+ p <= `|t| ^+ m.
Proof. by move=> t1 mp; apply: ler_wiexpn2l. Qed.

Lemma theta_small t j : `|t| <= 1 -> `|theta (along t) j| <= `|t| * (U + W).
Proof.
move=> t1; rewrite theta_along mulrDr; apply: le_trans (ler_norm_add _ _) _.
apply: ler_add; rewrite normrM; first by apply: ler_wpmul2l => //; apply: theta_u.
by apply: ler_pmul => //; [rewrite normrX -[X in _ <= X]expr1; apply: small_power | apply: theta_w].
Qed.

(* A square of a sum of first and second order is that of its first order, but for the third. *)
Lemma square_along (a b D c t : R) : `|t| <= 1 -> `|b| <= D ->
  `|c * (t * a + t ^+ 2 * b) ^+ 2 - t ^+ 2 * (c * a ^+ 2)| <= `|t| ^+ 3 * (`|c| * ((2%:R * `|a| + D) * D)).
Proof.
move=> t1 bD; have D0 : 0 <= D := le_trans (normr_ge0 _) bD.
have -> : c * (t * a + t ^+ 2 * b) ^+ 2 - t ^+ 2 * (c * a ^+ 2) = t ^+ 3 * (c * ((2%:R * a + t * b) * b)) by ring.
rewrite normrM normrX normrM normrM; apply: ler_wpmul2l; first exact: exprn_ge0.
apply: ler_wpmul2l => //; apply: ler_pmul => //.
apply: le_trans (ler_norm_add _ _) _; rewrite !normrM normr_nat; apply: ler_add => //.
by rewrite -[D]mul1r; apply: ler_pmul.
Qed.

Lemma squares_along (I : finType) (c a : I -> R) (b : R -> I -> R) (D t : R) : `|t| <= 1 -> (forall i, `|b t i| <= D) ->
  `|\sum_i c i * (t * a i + t ^+ 2 * b t i) ^+ 2 - t ^+ 2 * (\sum_i c i * a i ^+ 2)| <=
  `|t| ^+ 3 * (\sum_i `|c i| * ((2%:R * `|a i| + D) * D)).
Proof.
move=> t1 bD; rewrite mulr_sumr -sumrB [X in _ <= X]mulr_sumr.
apply: le_trans (ler_norm_sum _ _ _) _; apply: ler_sum => i _; exact: square_along.
Qed.

Lemma B_ge0 : 0 <= U + W.
Proof.
have t1 : `|0 : R| <= 1 by rewrite normr0.
by apply: addr_ge0; apply: sumr_ge0 => i _ //; apply: le_trans (normr_ge0 _) (w_bounded i t1).
Qed.

Lemma power_small t j m p : `|t| <= 1 -> (m <= p)%N -> `|theta (along t) j| ^+ p <= `|t| ^+ m * (U + W) ^+ p.
Proof.
move=> t1 mp; apply: le_trans (_ : (`|t| * (U + W)) ^+ p <= _).
  by apply: ler_expn2r; rewrite ?nnegrE ?theta_small // mulr_ge0 // B_ge0.
by rewrite exprMn; apply: ler_wpmul2r; [apply: exprn_ge0; exact: B_ge0 | exact: small_power].
Qed.

Lemma powers_small t m p (d : R) : 0 <= d -> `|t| <= 1 -> (m <= p)%N ->
  \sum_(j < n) L j * `|theta (along t) j| ^+ p / d <= `|t| ^+ m * (\sum_(j < n) L j * (U + W) ^+ p / d).
Proof.
move=> d0 t1 mp; rewrite mulr_sumr; apply: ler_sum => j _.
have -> : `|t| ^+ m * (L j * (U + W) ^+ p / d) = L j * (`|t| ^+ m * (U + W) ^+ p) / d by ring.
apply: ler_wpmul2r; first by rewrite invr_ge0.
by apply: ler_wpmul2l; [exact: L_ge0 | exact: power_small].
Qed.

(* Held on the axis it leaves the straight shape along the constraint of the linear equations. *)
Theorem tangent : (forall t, 0 < t <= 1 -> height (along t) = 0) -> (S0 n L)^T *m u = 0.
Proof.
move=> on_axis; set a := ((S0 n L)^T *m u) 0 0.
set K := \sum_(j < n) L j * (U + W) ^+ 3 / 6%:R + \sum_(j < n) L j * W.
have small t : 0 < t <= 1 -> `|a| <= K * t.
  move=> t01; have /andP [t0 t1] := t01; have t1' : `|t| <= 1 by rewrite gtr0_norm.
  have := height_to_first_order (along t); rewrite on_axis // sub0r normrN axis_theta.
  have -> : \sum_(j < n) L j * theta (along t) j = t * (a + t * \sum_(j < n) L j * theta (w t) j).
    by rewrite /a axis_theta mulrDr !mulr_sumr -big_split /=; apply: eq_bigr => j _; rewrite theta_along; ring.
  rewrite normrM (gtr0_norm t0) => h.
  have := le_trans h (powers_small (ler0n R 6) t1' (isT : (2 <= 3)%N)).
  rewrite (gtr0_norm t0) expr2 -mulrA ler_pmul2l // => {h} h.
  have b : `|t * \sum_(j < n) L j * theta (w t) j| <= t * \sum_(j < n) L j * W.
    rewrite normrM (gtr0_norm t0); apply: ler_wpmul2l; first exact: ltW.
    apply: le_trans (ler_norm_sum _ _ _) _; apply: ler_sum => j _.
    rewrite normrM (ger0_norm (L_ge0 (ltn_ord j))); apply: ler_wpmul2l; [exact: L_ge0 | exact: theta_w].
  have -> : a = (a + t * \sum_(j < n) L j * theta (w t) j) - t * \sum_(j < n) L j * theta (w t) j by rewrite addrK.
  by apply: le_trans (ler_norm_sub _ _) _; rewrite /K mulrDl; apply: ler_add; rewrite [X in _ <= X]mulrC.
have K0 : 0 <= K by have := small 1; rewrite ltr01 lexx mulr1 => /(_ isT); apply: le_trans.
have a0 : a = 0.
  apply/eqP; rewrite -normr_eq0 eq_le normr_ge0 andbT leNgt; apply/negP => a_gt0.
  have d0 : 0 < K + `|a| + `|a| by rewrite -addrA ltr_paddl // addr_gt0.
  have t01 : 0 < `|a| / (K + `|a| + `|a|) <= 1.
    by rewrite divr_gt0 //= ler_pdivr_mulr // mul1r ler_addr addr_ge0.
  have := small _ t01; rewrite mulrA ler_pdivl_mulr // [`|a| * _]mulrC ler_pmul2r //.
  by rewrite -addrA ger_addl leNgt addr_gt0.
by apply/matrixP => i j; rewrite !ord1 -/a a0 mxE.
Qed.

(* Half the second derivative of the energy along the curve is half the second variation of its direction, whatever the
   curve does to second order: w does not occur. *)
Theorem second_derivative F : exists K, forall t, `|t| <= 1 ->
  `|potential F (along t) - potential F 0 - t ^+ 2 * (second_variation L k F u / 2%:R)| <= K * `|t| ^+ 3.
Proof.
set Kr := `|F| * (\sum_(j < n) L j * (U + W) ^+ 4 / 24%:R).
set Kk := \sum_(i < n) `|k i| * ((2%:R * `|u i 0| + C) * C).
set Km := \sum_(j < n) `|L j| * ((2%:R * `|theta u j| + W) * W).
exists (Kr + Kk / 2%:R + `|F| * (Km / 2%:R)) => t t1.
have r : `|potential F (along t) - potential F 0 - second_variation L k F (along t) / 2%:R| <= Kr * `|t| ^+ 3.
  apply: le_trans (potential_to_second_order _ _) _; rewrite /Kr -mulrA; apply: ler_wpmul2l => //.
  rewrite [X in _ <= X]mulrC; have := powers_small (ler0n R 24) t1 (isT : (3 <= 4)%N); apply: le_trans.
  by apply: ler_sum => j _; rewrite -normrX ger0_norm // exprn_even_ge0.
have s : `|strain k (along t) - t ^+ 2 * strain k u| <= Kk * `|t| ^+ 3.
  rewrite [X in _ <= X]mulrC /strain (eq_bigr (fun i : 'I_n => k i * (t * u i 0 + t ^+ 2 * w t i 0) ^+ 2)).
    exact: (@squares_along (ordinal_finType n) (fun i => k i) (fun i => u i 0) (fun s i => w s i 0) C t t1
              (fun i => w_bounded i t1)).
  by move=> i _; rewrite !mxE.
have m : `|shortening L (along t) - t ^+ 2 * shortening L u| <= Km * `|t| ^+ 3.
  rewrite [X in _ <= X]mulrC /shortening.
  rewrite (eq_bigr (fun j : 'I_n => L j * (t * theta u j + t ^+ 2 * theta (w t) j) ^+ 2)).
    exact: (@squares_along (ordinal_finType n) (fun j => L j) (fun j => theta u j) (fun s j => theta (w s) j) W t t1
              (fun j => theta_w j t1)).
  by move=> j _; rewrite theta_along.
have -> : potential F (along t) - potential F 0 - t ^+ 2 * (second_variation L k F u / 2%:R) =
  (potential F (along t) - potential F 0 - second_variation L k F (along t) / 2%:R) +
  (strain k (along t) - t ^+ 2 * strain k u) / 2%:R - F * ((shortening L (along t) - t ^+ 2 * shortening L u) / 2%:R).
  by rewrite !second_variationE; field.
have half x : `|x / 2%:R| = `|x| / 2%:R :> R by rewrite normrM normfV normr_nat.
rewrite [X in _ <= X]mulrDl [X in _ <= X + _]mulrDl.
apply: le_trans (ler_norm_sub _ _) _; apply: ler_add.
  apply: le_trans (ler_norm_add _ _) _; apply: ler_add => //.
  by rewrite half -[X in _ <= X]mulrA [_^-1 * _]mulrC mulrA; apply: ler_wpmul2r; rewrite ?invr_ge0 ?ler0n.
rewrite normrM -mulrA; apply: ler_wpmul2l => //.
by rewrite half -[X in _ <= X]mulrA [_^-1 * _]mulrC mulrA; apply: ler_wpmul2r; rewrite ?invr_ge0 ?ler0n.
Qed.

End Curve.

End Potential.
