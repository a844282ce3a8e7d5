(* Below its lowest critical force the straight chain is a strict local minimum of the potential among all shapes whose
   end point is on the axis, however these are reached: the quadratic theorem of stability.v and the remainders of
   potential.v. Theorem "Stable below the lowest force" of theorems.md. Cosine and sine as in potential.v. *)
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp Require Import ring.
Require Import chain determinant recursion forces definite stability potential.

Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Import Order.TTheory GRing.Theory Num.Theory.
Local Open Scope ring_scope.

Section Minimum.

Variables (R : rcfType) (n : nat) (L k : nat -> R).
Hypotheses (two : (1 < n)%N) (links : chain_of_links n L k) (one : at_most_one_passive n k).

Variables (cosine sine : R -> R).
Hypothesis cosine_bounds : forall x, 1 - x ^+ 2 / 2%:R <= cosine x <= 1 - x ^+ 2 / 2%:R + x ^+ 4 / 24%:R.
Hypothesis sine_bounds : forall x, `|sine x - x| <= `|x| ^+ 3 / 6%:R.

Let pos i : (i < n)%N -> 0 < L i. Proof. by have [h _] := links; apply: h. Qed.
Let nonneg i : (i < n)%N -> 0 <= L i. Proof. by move=> h; apply: ltW; apply: pos. Qed.
Let n0 : (0 < n)%N. Proof. exact: ltnW. Qed.
Let base : 'I_n := Ordinal n0.
Let k0_ge0 : 0 <= k 0%N. Proof. by have [_ h] := links; apply: h. Qed.

Definition whole : R := \sum_(j < n) L j.

Lemma whole_gt0 : 0 < whole.
Proof. by rewrite /whole (bigD1 base) //=; apply: ltr_paddr; [apply: sumr_ge0 => i _; exact: nonneg | exact: pos]. Qed.

(* The shape turned about the base, so that the linear constraint holds. *)
Definition off (q : 'cV[R]_n) : R := (\sum_(j < n) L j * theta q j) / whole.
Definition turned (q : 'cV[R]_n) : 'cV[R]_n := \col_i (q i 0 - off q *+ (i == base)).

Lemma theta_turned q j : theta (turned q) j = theta q j - off q.
Proof.
rewrite /theta; under eq_bigr do rewrite mxE; rewrite sumrB; congr (_ - _).
rewrite (bigD1 base) //= ?eqxx ?mulr1n big1 ?addr0 // => i /andP [_ i0]; by rewrite (negbTE i0) mulr0n.
Qed.

Lemma off_whole q : off q * whole = \sum_(j < n) L j * theta q j.
Proof. by rewrite /off divfK // gt_eqF // whole_gt0. Qed.

Lemma turned_on_axis q : (S0 n L)^T *m turned q = 0.
Proof.
apply/matrixP => i j; rewrite !ord1 axis_theta mxE.
under eq_bigr do rewrite theta_turned mulrBr; rewrite sumrB -mulr_suml -/whole -off_whole.
by rewrite mulrC subrr.
Qed.

Lemma shortening_turned q : shortening L (turned q) = shortening L q - off q ^+ 2 * whole.
Proof.
rewrite /shortening; under eq_bigr do rewrite theta_turned.
have -> : \sum_(j < n) L j * (theta q j - off q) ^+ 2 =
  \sum_(j < n) L j * theta q j ^+ 2 - 2%:R * off q * (\sum_(j < n) L j * theta q j) + off q ^+ 2 * whole.
  rewrite /whole !mulr_sumr -sumrB -big_split /=; apply: eq_bigr => j _; ring.
rewrite -off_whole; move: (\sum_(j < n) L j * theta q j ^+ 2) (off q) whole => S t w; ring.
Qed.

Lemma strain_turned q :
  strain k (turned q) = strain k q - k 0%N * off q * (2%:R * q base 0 - off q).
Proof.
have e : \sum_(i < n | i != base) k i * turned q i 0 ^+ 2 = \sum_(i < n | i != base) k i * q i 0 ^+ 2.
  by apply: eq_bigr => i i0; rewrite mxE (negbTE i0) mulr0n subr0.
rewrite /strain (bigD1 base) //= e [in RHS](bigD1 base) //= mxE ?eqxx ?mulr1n.
move: (\sum_(i < n | i != base) _) (q base 0) (off q) (k 0%N) => S x t c; ring.
Qed.

Section Near.

Variables (q : 'cV[R]_n) (r : R).
Hypotheses (r1 : r <= 1) (near : forall j, (j < n)%N -> `|theta q j| <= r).
Hypothesis held : height L sine q = 0.

Let S := shortening L q.
Let r0 : 0 <= r. Proof. exact: le_trans (normr_ge0 _) (near n0). Qed.
Let theta1 (j : 'I_n) : `|theta q j| <= 1. Proof. exact: le_trans (near (ltn_ord j)) r1. Qed.

Lemma S_ge0 : 0 <= S. Proof. by apply: shortening_ge0 => i; apply: pos. Qed.

(* Powers of the orientations against their squares. *)
Lemma power_near (j : 'I_n) p : (2 < p)%N -> `|theta q j| ^+ p <= r * theta q j ^+ 2.
Proof.
move=> p2; rewrite -[theta q j ^+ 2]ger0_norm ?sqr_ge0 // normrX.
rewrite -(subnKC p2) exprD exprSr -mulrA [`|_| ^+ 2 * _]mulrC; apply: ler_wpmul2r; first exact: exprn_ge0.
rewrite -[X in _ <= X]mulr1; apply: ler_pmul => //; first exact: exprn_ge0.
  exact: near (ltn_ord j).
exact: exprn_ile1.
Qed.

Lemma powers_near p d : (2 < p)%N -> 1 <= d -> \sum_(j < n) L j * `|theta q j| ^+ p / d <= r * S.
Proof.
move=> p2 d1; have d0 : 0 < d := lt_le_trans ltr01 d1.
rewrite /S /shortening mulr_sumr; apply: ler_sum => j _; rewrite ler_pdivr_mulr //.
have Lj := nonneg (ltn_ord j).
apply: (@le_trans _ _ (r * (L j * theta q j ^+ 2))); last first.
  by apply: ler_pemulr => //; apply: mulr_ge0 => //; apply: mulr_ge0 => //; exact: sqr_ge0.
by rewrite mulrCA; apply: ler_wpmul2l => //; apply: power_near.
Qed.

(* The end point is on the axis but for the third order. *)
Lemma off_small : `|off q| * whole <= r * S.
Proof.
have := height_to_first_order nonneg sine_bounds q; rewrite held sub0r normrN axis_theta -off_whole normrM.
rewrite (gtr0_norm whole_gt0) => h; apply: le_trans h _; apply: powers_near => //; by rewrite (ler_nat _ 1).
Qed.

Lemma off_near : `|off q| <= r.
Proof.
rewrite -(ler_pmul2r whole_gt0) -{1}(gtr0_norm whole_gt0) -normrM off_whole.
apply: le_trans (ler_norm_sum _ _ _) _; rewrite /whole mulr_sumr; apply: ler_sum => j _.
rewrite normrM (ger0_norm (nonneg (ltn_ord j))) mulrC; apply: ler_wpmul2r; first exact: nonneg.
exact: near.
Qed.

Lemma base_near : `|q base 0| <= r.
Proof.
have := near n0; congr (`|_| <= r); rewrite /theta (bigD1 base) //= big1 ?addr0 // => i /andP [].
by rewrite leqn0 => /eqP i0 /eqP []; apply: val_inj.
Qed.

Lemma off_squared : off q ^+ 2 * whole <= r * S.
Proof.
apply: le_trans off_small; rewrite -[off q ^+ 2]ger0_norm ?sqr_ge0 // normrX expr2 -mulrA.
rewrite -[X in _ <= X]mul1r; apply: ler_wpmul2r; first by rewrite mulr_ge0 // ltW // whole_gt0.
exact: le_trans off_near r1.
Qed.

Lemma base_term : `|k 0%N * off q * (2%:R * q base 0 - off q)| <= 3%:R * k 0%N / whole * (r * S).
Proof.
have three : `|2%:R * q base 0 - off q| <= 3%:R.
  have -> : 3%:R = 2%:R * 1 + 1 :> R by ring.
  apply: le_trans (ler_norm_sub _ _) _; rewrite normrM normr_nat; apply: ler_add; last exact: le_trans off_near r1.
  by apply: ler_wpmul2l; [exact: ler0n | exact: le_trans base_near r1].
rewrite normrM [`|k 0%N * off q|]normrM (ger0_norm k0_ge0).
have -> : 3%:R * k 0%N / whole * (r * S) = k 0%N * (r * S / whole) * 3%:R by ring.
have small : `|off q| <= r * S / whole by rewrite ler_pdivl_mulr ?whole_gt0 // off_small.
have nonneg_k : 0 <= k 0%N * `|off q| by apply: mulr_ge0; [exact: k0_ge0 | exact: normr_ge0].
apply: ler_pmul nonneg_k (normr_ge0 _) _ three; exact: ler_wpmul2l.
Qed.

Lemma remainder_near (F : R) : `|F| * (\sum_(j < n) L j * theta q j ^+ 4 / 24%:R) <= `|F| * (r * S).
Proof.
apply: ler_wpmul2l => //; rewrite (eq_bigr (fun j : 'I_n => L j * `|theta q j| ^+ 4 / 24%:R)) => [|j _].
  by apply: powers_near => //; rewrite (ler_nat _ 1).
by rewrite -normrX ger0_norm // exprn_even_ge0.
Qed.

(* The energy from below, where F' is between F and the lowest force. *)
Lemma energy_near (F F' : R) : (forall p : 'cV[R]_n, (S0 n L)^T *m p = 0 -> F' * shortening L p <= strain k p) ->
  S * ((F' - F) / 2%:R - r * (`|F'| + 3%:R * k 0%N / whole + `|F|)) <= potential L k cosine F q - potential L k cosine F (0 : 'cV[R]_n).
Proof.
move=> room; have := room _ (turned_on_axis q); rewrite shortening_turned strain_turned -/S => h.
have := potential_to_second_order k nonneg cosine_bounds F q.
rewrite ler_distl => /andP [low _].
have rem := remainder_near F; have bt := base_term; have os := off_squared.
have rS : 0 <= r * S by rewrite mulr_ge0 // S_ge0.
have quadratic : (F' - F) * S - `|F'| * (r * S) - 3%:R * k 0%N / whole * (r * S) <= second_variation L k F q.
  rewrite second_variationE -/S; set x := k 0%N * off q * _ in h bt; set y := off q ^+ 2 * whole in h os.
  have y0 : 0 <= y by rewrite mulr_ge0 ?sqr_ge0 // ltW // whole_gt0.
  have F'y : F' * y <= `|F'| * (r * S).
    by apply: le_trans (ler_norm _) _; rewrite normrM (ger0_norm y0); apply: ler_wpmul2l.
  have x_low : - (3%:R * k 0%N / whole * (r * S)) <= x by move: bt; rewrite ler_norml => /andP [].
  have -> : (F' - F) * S - `|F'| * (r * S) - 3%:R * k 0%N / whole * (r * S) =
            (F' * S - `|F'| * (r * S)) + - (3%:R * k 0%N / whole * (r * S)) - F * S by ring.
  rewrite ler_add2r; apply: (@le_trans _ _ ((F' * S - F' * y) + x)); last first.
    by rewrite -mulrBr -ler_subr_addr.
  by apply: ler_add => //; rewrite ler_add2l ler_opp2.
set b := 3%:R * k 0%N / whole in quadratic *.
apply: (@le_trans _ _ (second_variation L k F q / 2%:R - `|F| * (r * S))); last first.
  by apply: le_trans low; rewrite ler_add2l ler_opp2.
apply: (@le_trans _ _ (((F' - F) * S - `|F'| * (r * S) - b * (r * S)) / 2%:R - `|F| * (r * S))); last first.
  by rewrite ler_add2r; apply: ler_wpmul2r => //; rewrite invr_ge0 ler0n.
have b0 : 0 <= b by rewrite /b divr_ge0 ?mulr_ge0 ?ler0n // ltW // whole_gt0.
have -> : ((F' - F) * S - `|F'| * (r * S) - b * (r * S)) / 2%:R - `|F| * (r * S) =
          S * ((F' - F) / 2%:R - r * (`|F'| + b + `|F|)) + (`|F'| + b) / 2%:R * (r * S) by field.
by rewrite ler_addl mulr_ge0 // divr_ge0 ?ler0n // addr_ge0.
Qed.

End Near.

Lemma theta_near (q : 'cV[R]_n) r j : (forall i, `|q i 0| <= r) -> `|theta q j| <= n%:R * r.
Proof.
move=> qr; have r0 : 0 <= r := le_trans (normr_ge0 _) (qr base).
apply: le_trans (theta_bound (b := fun _ => r) j qr) _.
by rewrite sumr_const card_ord mulr_natl lexx.
Qed.

(* No shape near the straight one has less energy, nor as much. *)
Theorem strict_local_minimum fs (F : R) : roots_of (D n L k) fs -> all (fun f => F < f) fs ->
  exists2 r : R, 0 < r & forall q : 'cV[R]_n, q != 0 -> (forall i, `|q i 0| <= r) -> height L sine q = 0 ->
    potential L k cosine F (0 : 'cV[R]_n) < potential L k cosine F q.
Proof.
move=> rfs below; have [F' F_F' room] := room_below two links one rfs below.
set K := `|F'| + 3%:R * k 0%N / whole + `|F|.
have K0 : 0 <= K.
  by rewrite /K addr_ge0 // addr_ge0 // divr_ge0 ?mulr_ge0 ?ler0n // ltW // whole_gt0.
have c0 : 0 < F' - F by rewrite subr_gt0.
have K1 : 0 < K + 1 by apply: ltr_paddl.
set t := (F' - F) / 2%:R / (K + 1).
have t0 : 0 < t by rewrite divr_gt0 // divr_gt0 ?ltr0n.
set s := if t <= 1 then t else 1.
have s0 : 0 < s by rewrite /s; case: ifP => _; [exact: t0 | exact: ltr01].
have s1 : s <= 1 by rewrite /s; case: ifP => // _; exact: lexx.
have st : s <= t by rewrite /s; case: ifP => [_|/negbT]; [exact: lexx | rewrite -ltNge => /ltW].
have n_gt0 : 0 < n%:R :> R by rewrite ltr0n.
exists (s / n%:R) => [|q q0 near held]; first exact: divr_gt0.
have near' j : (j < n)%N -> `|theta q j| <= s.
  by move=> _; have := theta_near j near; rewrite mulrCA divff ?mulr1 // gt_eqF.
rewrite -subr_gt0; apply: lt_le_trans _ (energy_near s1 near' held F room).
rewrite pmulr_rgt0; last exact: (shortening_gt0 links).
rewrite subr_gt0 -/K; apply: (@lt_le_trans _ _ (t * (K + 1))).
  apply: (@le_lt_trans _ _ (t * K)); first exact: ler_wpmul2r.
  by rewrite ltr_pmul2l // ltr_addl.
by rewrite /t divfK // gt_eqF.
Qed.

End Minimum.
