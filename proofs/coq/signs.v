(* Changes of sign along a sequence, zeros dropped, and along its differences. *)
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp Require Import zify ring.

Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Import Order.TTheory GRing.Theory Num.Theory.
Local Open Scope ring_scope.

Section Signs.

Variable R : realDomainType.
Implicit Types (b d e x y : R) (s ds : seq R).

(* After the value b, the last that is not zero. *)
Fixpoint changes_after b s : nat :=
  if s is x :: s' then (if (x == 0)%R then changes_after b s' else (b * x < 0)%R + changes_after x s')%N else 0%N.

Definition sign_changes s := changes_after 0 s.

Lemma mul_lt0 x y : (x * y < 0) = [&& x != 0, y != 0 & (x < 0) (+) (y < 0)].
Proof. exact: mulr_lt0. Qed.

Lemma mul_gt0 x y : (0 < x * y) = [&& x != 0, y != 0 & ~~ ((x < 0) (+) (y < 0))].
Proof. by rewrite -oppr_lt0 -mulNr mulr_lt0 oppr_eq0 oppr_lt0; case: (ltrgtP x 0) => //= _; case: (y < 0). Qed.

(* Signs of a sum. *)
Lemma sum_signs x d : [&& (x == 0) ==> ((x + d == 0) == (d == 0)) && ((x + d < 0) == (d < 0)),
  (d == 0) ==> ((x + d == 0) == (x == 0)) && ((x + d < 0) == (x < 0)),
  [&& x != 0, d != 0 & ~~ ((x < 0) (+) (d < 0))] ==> (x + d != 0) && ((x + d < 0) == (x < 0)) &
  [&& x != 0, d != 0 & x + d == 0] ==> (x < 0) (+) (d < 0)].
Proof.
case: (ltrgtP x 0) => [x0|x0|->]; case: (ltrgtP d 0) => [d0|d0|->]; rewrite ?add0r ?addr0 ?eqxx ?ltxx //=.
- by have h : x + d < 0; [rewrite -oppr_gt0 opprD addr_gt0 ?oppr_gt0 | rewrite h (lt_eqF h)].
- by rewrite implybT.
- by rewrite (lt_eqF x0) x0.
- by rewrite implybT.
- by have h := addr_gt0 x0 d0; rewrite (gt_eqF h) ltNge (ltW h).
- by rewrite (gt_eqF x0) ltNge (ltW x0).
- by rewrite (lt_eqF d0) d0.
by rewrite (gt_eqF d0) ltNge (ltW d0).
Qed.

(* The differences ds change sign at least as often as the values from x on, and once more for each end that is zero: b is the
   last value, e the last difference before, that is not zero. *)
Lemma rolle_after ds x b e : b != 0 -> ~~ (x * b < 0) -> ((x == 0) ==> (e * b < 0)) ->
  (changes_after b (scanl +%R x ds) + (last x (scanl +%R x ds) == 0)%R + (0 < e * b)%R <= (changes_after e ds).+1)%N.
Proof.
elim: ds x b e => [|d ds IH] x b e b0 xb eb /=.
  by move: eb; case: (x == 0) => //= [h|_]; [rewrite ltNge (ltW h) | case: (0 < _)].
have := IH (x + d) (if x + d == 0 then b else x + d) (if d == 0 then e else d).
have := sum_signs x d; move: xb eb b0; rewrite !mul_lt0 !mul_gt0.
case: (x + d == 0) / eqP => [->|/eqP xd]; case: (d == 0) / eqP => [d0|/eqP d0];
  rewrite ?eqxx ?d0 ?(negPf d0) ?(negPf xd) ?mul_lt0 ?mul_gt0 /= ?(negPf d0) ?(negPf xd) /= ?addr0 ?ltxx ?addbb /=;
  move: (last _ _ == 0) (changes_after _ (scanl _ _ _)) (changes_after _ ds) => z m l;
  move: (x == 0) (b == 0) (e == 0) (x < 0) (b < 0) (e < 0) (d < 0) (x + d < 0);
  do 8! [case => //=]; lia.
Qed.

(* Of what stands before a sequence only the sign matters; it brings at most one change. *)
Lemma changes_after_sign b b' s : 0 < b * b' -> changes_after b s = changes_after b' s.
Proof.
elim: s b b' => //= x s IH b b'; rewrite mul_gt0 => bb'; case: eqP => [_|_]; first by apply: IH; rewrite mul_gt0.
by congr (_ + _)%N; rewrite !mul_lt0; move: bb'; case: (b == 0); case: (b' == 0); case: (b < 0); case: (b' < 0).
Qed.

Lemma changes_after_le b s : (changes_after b s <= (sign_changes s).+1)%N.
Proof.
rewrite /sign_changes; elim: s => //= x s IH; case: eqP => // _.
by rewrite mul0r ltxx -add1n leq_add2r leq_b1.
Qed.

Lemma sign_changes_cons x s : (sign_changes (x :: s) <= (sign_changes s).+1)%N.
Proof.
rewrite /sign_changes /=; case: eqP => // _.
by rewrite mul0r ltxx changes_after_le.
Qed.

Lemma sign_changes_zero s : sign_changes (0 :: s) = sign_changes s.
Proof. by rewrite /sign_changes /= eqxx. Qed.

(* The last value that is not zero. *)
Definition last_of b s := foldl (fun b x => if x == 0 then b else x) b s.

Lemma last_of_rcons b s x : last_of b (rcons s x) = if x == 0 then last_of b s else x.
Proof. by rewrite /last_of -cats1 foldl_cat. Qed.

Lemma changes_after_rcons b s x :
  changes_after b (rcons s x) = (changes_after b s + (if (x == 0)%R then 0%N else (last_of b s * x < 0)%R))%N.
Proof.
by elim: s b => [|y s IH] b /=; [case: eqP; rewrite ?addn0 | case: eqP => _; rewrite IH ?addnA].
Qed.

Lemma sign_changes_rcons s x : (sign_changes (rcons s x) <= (sign_changes s).+1)%N.
Proof.
by rewrite /sign_changes changes_after_rcons -addn1 leq_add2l; case: eqP => // _; apply: leq_b1.
Qed.

Lemma sign_changes_rcons0 s : sign_changes (rcons s 0) = sign_changes s.
Proof. by rewrite /sign_changes changes_after_rcons eqxx addn0. Qed.

(* Factors of one sign change nothing. *)
Lemma changes_after_scaled (a : R) (f g w : nat -> R) m i b :
  (forall j, (i <= j < i + m)%N -> g j = w j * f j /\ 0 < a * w j) ->
  changes_after (a * b) [seq g j | j <- iota i m] = changes_after b [seq f j | j <- iota i m].
Proof.
elim: m i b => [|m IH] i b h //=; have [|-> wi] := h i; first by rewrite leqnn addnS ltnS leq_addr.
have {}IH c := IH i.+1 c (fun j hj => h j (ltac:(rewrite addnS -addSn; case/andP: hj => /ltnW -> ->))).
have w0 : w i != 0 by apply: contraTneq wi => ->; rewrite mulr0 ltxx.
rewrite mulf_eq0 (negPf w0) /= -!IH; case: (eqVneq (f i) 0) => // f0.
congr (_ + _)%N; first by rewrite mulrACA pmulr_rlt0.
by apply: changes_after_sign; rewrite mulrACA [w i * a]mulrC pmulr_rgt0 // lt0r sqrf_eq0 f0 sqr_ge0.
Qed.

Lemma sign_changes_scaled (a : R) (f g w : nat -> R) m i :
  (forall j, (i <= j < i + m)%N -> g j = w j * f j /\ 0 < a * w j) ->
  sign_changes [seq g j | j <- iota i m] = sign_changes [seq f j | j <- iota i m].
Proof. by move/changes_after_scaled => /(_ 0); rewrite mulr0. Qed.

(* Rolle: f_0 ... f_N has no more changes than its differences, but one; and each end that is zero takes one off. *)
Lemma scanl_differences (f : nat -> R) m i :
  scanl +%R (f i) [seq (f j.+1 - f j)%R | j <- iota i m] = [seq f j | j <- iota i.+1 m].
Proof. by elim: m i => [|m IH] i //=; rewrite addrC subrK IH. Qed.

Lemma last_iota (f : nat -> R) m i : last (f i) [seq f j | j <- iota i.+1 m] = f (i + m)%N.
Proof. by elim: m i => [|m IH] i /=; rewrite ?addn0 // IH addSnnS. Qed.

Lemma rolle_zero (f : nat -> R) m i : f i = 0 -> (exists2 j, (i <= j <= i + m)%N & f j != 0) ->
  (changes_after 0 [seq f j | j <- iota i.+1 m] + (f (i + m)%N == 0)%R <=
   changes_after 0 [seq (f j.+1 - f j)%R | j <- iota i m])%N.
Proof.
elim: m i => [|m IH] i fi [j j_i fj].
  by move: fj; have -> : j = i; [lia | rewrite fi eqxx].
rewrite /= fi subr0; case: (eqVneq (f i.+1) 0) => [e|e].
  rewrite -addSnnS; apply: IH => //; exists j => //.
  by have : j <> i; [move=> ji; rewrite ji fi eqxx in fj | lia].
rewrite !mul0r ltxx !add0n -addSnnS -last_iota -scanl_differences.
have {}IH x b c nz := @rolle_after [seq f j.+1 - f j | j <- iota i.+1 m] x b c nz.
have {IH} := IH (f i.+1) (f i.+1) (f i.+1) e.
rewrite -expr2 ltNge sqr_ge0 (negPf e) lt0r sqr_ge0 sqrf_eq0 e addn1 => /(_ isT isT).
by rewrite ltnS.
Qed.

Theorem rolle (f : nat -> R) N : (exists2 j, (j <= N)%N & f j != 0) ->
  (sign_changes [seq f j | j <- iota 0 N.+1] + (f 0%N == 0)%R + (f N == 0)%R <=
   (sign_changes [seq (f j.+1 - f j)%R | j <- iota 0 N]).+1)%N.
Proof.
move=> some; rewrite /sign_changes /=; case: (eqVneq (f 0%N) 0) => [e|e].
  by rewrite addn1 addSn ltnS; apply: rolle_zero.
rewrite mul0r ltxx add0n addn0 -[X in (_ + (f X == 0)%R)%N]add0n -last_iota -scanl_differences.
have h x b c nz := @rolle_after [seq f j.+1 - f j | j <- iota 0 N] x b c nz.
have {h} := h (f 0%N) (f 0%N) 0 e.
by rewrite mul0r ltxx addn0 -expr2 ltNge sqr_ge0 (negPf e) => /(_ isT isT).
Qed.

End Signs.
