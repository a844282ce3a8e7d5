(* The critical forces of a chain: n - 1 positive numbers, the roots of D(F) = det(A F + B) with multiplicity, counted
   below a force by the sign changes of the recursion (theorems "Definiteness", "Recursion", "Simple modes"). *)
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp Require Import polyrcf.
From mathcomp Require Import ring.
Require Import chain determinant string recursion.

Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Import Order.TTheory GRing.Theory Num.Theory.
Local Open Scope ring_scope.

(* A list of forces: the roots of a polynomial with multiplicity, ascending. *)
Section Lists.

Variable R : rcfType.
Implicit Types (p : {poly R}) (fs : seq R).

Definition roots_of p fs : Prop :=
  sorted <=%R fs /\ exists2 c, c != 0 & p = c *: \prod_(f <- fs) ('X - f%:P).

Lemma prod_XsubC_perm (s t : seq R) :
  \prod_(f <- s) ('X - f%:P) = \prod_(f <- t) ('X - f%:P) -> perm_eq s t.
Proof.
elim: s t => [|x s IH] t.
  case: t => // y t h; have : root (\prod_(f <- [::]) ('X - f%:P)) y by rewrite h root_prod_XsubC mem_head.
  by rewrite root_prod_XsubC.
move=> h; have xt : x \in t by rewrite -root_prod_XsubC -h root_prod_XsubC mem_head.
rewrite perm_sym; apply: perm_trans (perm_to_rem xt) _; rewrite perm_cons perm_sym; apply: IH.
move: h; rewrite big_cons (perm_big _ (perm_to_rem xt)) big_cons; apply: mulfI.
by rewrite polyXsubC_eq0.
Qed.

Lemma roots_of_inj p fs gs : roots_of p fs -> roots_of p gs -> fs = gs.
Proof.
move=> [sf [c c0 pc]] [sg [d d0 pd]]; apply: (le_sorted_eq sf sg).
apply: prod_XsubC_perm; have cd : c = d.
  have := congr1 lead_coef pc; rewrite pd !lead_coefZ.
  by rewrite !(monicP (monic_prod_XsubC _ _ _)) !mulr1.
move: pd; rewrite pc cd; move/(congr1 (fun q => d^-1 *: q)).
by rewrite !scalerA mulVf // !scale1r.
Qed.

Lemma roots_of_root p fs F : roots_of p fs -> root p F = (F \in fs).
Proof. by move=> [_ [c c0 ->]]; rewrite rootZ // root_prod_XsubC. Qed.

Lemma splits_prod p m (x : nat -> R) : splits p m x ->
  exists2 c, c != 0 & p = c *: \prod_(f <- [seq x i | i <- index_iota 0 m]) ('X - f%:P).
Proof.
case=> _ _ [c c0 ->]; exists ((-1) ^+ m * c); first by rewrite mulf_neq0 ?signr_eq0 ?gt_eqF.
rewrite mulrC -scalerA; congr (_ *: _); rewrite big_map big_mkord.
rewrite (eq_bigr (fun i : 'I_m => - ('X - (x i)%:P))); last by move=> i _; rewrite opprB.
by rewrite prodrN card_ord -[in LHS]signr_odd -[in RHS]signr_odd; case: (odd m);
   rewrite ?expr1 ?scaleN1r ?mulN1r // !expr0 scale1r mul1r.
Qed.

Lemma below_count m (x : nat -> R) F : below m x F = count (fun f => f < F) [seq x i | i <- index_iota 0 m].
Proof. by rewrite -sum1_count big_map big_mkcond big_mkord; apply: eq_bigr => i _; case: (_ < _). Qed.

End Lists.

Section Determinant.

Variables (R : fieldType) (n : nat) (L k : nat -> R).

(* D(F) of theorems.md as a polynomial in F. *)
Definition D : {poly R} := \det ('X *: map_mx polyC (A n L) + map_mx polyC (B n L k)).

Lemma horner_det m (a b : 'M[R]_m) F : (\det ('X *: map_mx polyC a + map_mx polyC b)).[F] = \det (F *: a + b).
Proof.
rewrite -[LHS]/(horner_eval F _) -det_map_mx; congr (\det _); apply/matrixP=> i j.
by rewrite !mxE /= /horner_eval !(hornerD, hornerM, hornerC, hornerX).
Qed.

Lemma horner_D F : D.[F] = \det (pencil n L k F).
Proof. exact: horner_det. Qed.

Lemma det_cast m m' (e : m = m') (X : 'M[R]_m) : \det (castmx (e, e) X) = \det X.
Proof. by case: m' / e; rewrite castmx_id. Qed.

Lemma pencil_bordered F : \det (pencil n L k F) = \det (bordered n (distance n L) k F 0).
Proof.
rewrite -(det_cast (addn1 n)); congr (\det _); apply/matrixP=> i j.
rewrite castmxE /= [RHS]mxE /entry.
have n0 (i' : 'I_n) : (i' == n :> nat) = false by apply/ltn_eqF.
have at_n (o : 'I_1) : (n + o)%N == n by rewrite ord1 addn0.
rewrite -[nat_of_ord i]/(nat_of_ord (cast_ord (esym (addn1 n)) i)).
rewrite -[nat_of_ord j]/(nat_of_ord (cast_ord (esym (addn1 n)) j)).
move: (cast_ord _ i) (cast_ord _ j) => a b.
rewrite -(splitK a) -(splitK b); case: (split a) => a'; case: (split b) => b' /=; rewrite ?n0 ?at_n /pencil.
- by rewrite [LHS]mxE [X in X + _]mxE 2!block_mxEul !mxE mulrN addrC.
- by rewrite [LHS]mxE [X in X + _]mxE 2!block_mxEur !mxE mulr0 add0r.
- by rewrite [LHS]mxE [X in X + _]mxE 2!block_mxEdl !mxE mulr0 add0r.
by rewrite [LHS]mxE [X in X + _]mxE 2!block_mxEdr !mxE mulr0 addr0.
Qed.


End Determinant.
