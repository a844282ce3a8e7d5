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

Section Cut.

Variable R : fieldType.
Implicit Types (z k : nat -> R) (p j : nat).

Definition from p (f : nat -> R) (i : nat) : R := f (p + i)%N.

(* A passive joint cuts the string: what follows is the string behind it, times what ends there. *)
Lemma behind_passive z k p j : k p = 0 ->
  H z k (p + j) = G z k p * H (from p z) (from p k) j /\
  k (p + j)%N *: G z k (p + j) = k (p + j)%N *: (G z k p * G (from p z) (from p k) j).
Proof.
move=> kp; elim: j => [|j [hH hG]].
  rewrite addn0 kp !scale0r; split=> //; rewrite {2}/H /= /from addn0.
  by case: p kp => [|p] kp; rewrite ?H_S ?kp ?scale0r ?add0r mulrC mul_polyC // /H /G /= alg_polyC.
have GE : G z k (p + j.+1) = G z k p * G (from p z) (from p k) j.+1.
  rewrite addnS !G_S hG hH mulrBr -!scalerAr; congr (_ *: _ - _); last by rewrite mulrCA /bead /from addnS.
split; last by rewrite GE.
rewrite [in LHS]addnS H_S -addnS GE hH H_S; move: (G _ _ j.+1) => g; rewrite mulrDr.
by congr (_ + _); rewrite -scalerAr.
Qed.

Lemma at_passive z k p : k p = 0 -> H z k p = z p ^+ 2 *: G z k p.
Proof.
move=> kp; have [+ _] := behind_passive z 0 kp.
by rewrite addn0 => ->; rewrite /H /= /from addn0 mulrC mul_polyC.
Qed.

End Cut.

Section Forces.

Variable R : rcfType.
Implicit Types (z k : nat -> R) (F : R) (fs xs ys : seq R).

Lemma poly_ext (p q : {poly R}) : (forall x, p.[x] = q.[x]) -> p = q.
Proof.
move=> h; apply/eqP; rewrite -subr_eq0; apply/negPn/negP => r0.
pose rs := [seq i%:R : R | i <- iota 0 (size (p - q))].
have : (size rs < size (p - q)%R)%N.
  apply: max_poly_roots => //; first by apply/allP => x _; rewrite /root !hornerE h subrr.
  by rewrite map_inj_uniq ?iota_uniq // => a b /eqP; rewrite eqr_nat => /eqP.
by rewrite size_map size_iota ltnn.
Qed.

(* The forces of one string of m beads. *)
Record string_forces z k m xs : Prop := StringForces {
  string_roots_of : roots_of (H z k m) xs;
  string_uniq : uniq xs;
  string_size : size xs = m;
  string_positive : all (fun f => 0 < f) xs;
  string_changes : forall F, changes z k F m = count (fun f => f < F) xs
}.

Lemma string_list z k m : distances m z -> (forall i, (0 < i < m)%N -> 0 < k i) -> (0 < m)%N ->
  0 <= k 0%N -> 0 <= k m -> 0 < k 0%N \/ 0 < k m -> exists xs, string_forces z k m xs.
Proof.
case: m => // m dz kp _ k0 km some.
have [x [sx cx _]] := string_theorem dz kp k0 km some.
have [pos inc _] := sx; exists [seq x i | i <- index_iota 0 m.+1]; split.
- split; last exact: splits_prod.
  rewrite (@sorted_map _ _ x) /index_iota subn0.
  apply/(sortedP 0%N) => i; rewrite size_iota => i_m; rewrite !nth_iota // ?(ltnW i_m) //= !add0n.
  by rewrite ltW // inc.
- rewrite map_inj_in_uniq ?iota_uniq // => i j; rewrite !mem_index_iota /= => i_m j_m xij.
  by case: (ltngtP i j) => // h; [have := inc _ _ h j_m | have := inc _ _ h i_m]; rewrite xij ltxx.
- by rewrite size_map size_iota subn0.
- by apply/allP => f /mapP [i]; rewrite mem_index_iota => /andP [_ i_m] ->; apply: pos.
by move=> F; rewrite cx below_count.
Qed.

Variables (n : nat) (L k : nat -> R).
Let z := distance n L.

(* The first interior passive joint; the last joint where there is none. *)
Definition cut (k : nat -> R) : nat := (find (fun i => k i.+1 == 0) (iota 0 n.-2)).+1.

(* The algorithm: sign changes, string by string. *)
Definition count_below F : nat :=
  (changes z k F (cut k) + changes (from (cut k) z) (from (cut k) k) F (n.-1 - cut k))%N.

Hypotheses (two : (1 < n)%N) (links : chain_of_links n L k) (one : at_most_one_passive n k).

Lemma cut_le : (cut k <= n.-1)%N.
Proof.
by rewrite /cut; case: n two => [|[|m]] // _ /=; rewrite ltnS -[X in (_ <= X)%N](size_iota 0 m) find_size.
Qed.

Lemma cut_passive : (cut k < n.-1)%N -> k (cut k) = 0.
Proof.
rewrite /cut; case: n two => [|[|m]] // _ /=; rewrite ltnS => h.
have has_ : has (fun i => k i.+1 == 0) (iota 0 m) by rewrite has_find size_iota.
by have := nth_find 0%N has_; rewrite nth_iota // add0n => /eqP.
Qed.

Lemma elastic_before i : (0 < i < cut k)%N -> 0 < k i.
Proof.
case: i => // i; rewrite /cut /= ltnS => i_f.
have i_n : (i < n.-2)%N.
  by apply: leq_trans i_f _; rewrite -[X in (_ <= X)%N](size_iota 0) find_size.
have := before_find 0%N i_f; rewrite nth_iota // add0n => /negbT k0.
rewrite lt0r k0; have [_] := links; apply; move: i_n; case: n two => [|[|m]] //= _ h.
by rewrite !ltnS ltnW.
Qed.

Lemma stiffness_ge0 i : (i < n)%N -> 0 <= k i. Proof. by have [_] := links; apply. Qed.

Lemma distance_step i : (i < n)%N -> z i = L i + z i.+1.
Proof. by move=> i_n; rewrite /z /distance big_ltn. Qed.

Lemma distance_gt0 i : (i < n)%N -> 0 < z i.
Proof.
move=> i_n; rewrite distance_step // ltr_paddr //; last by have [+ _] := links; apply.
rewrite /z /distance big_nat; apply: sumr_ge0 => j /andP [_ j_n].
by apply: ltW; have [+ _] := links; apply.
Qed.

Lemma chain_distances : distances n.-1 z.
Proof.
have n1 i : (i <= n.-1)%N -> (i < n)%N by case: n two.
split=> i i_n; first by apply: distance_gt0; apply: n1.
rewrite [X in _ < X]distance_step ?ltr_addr; first by have [+ _] := links; apply; apply: n1; apply: ltnW.
by apply: n1; apply: ltnW.
Qed.

Lemma distances_from p m : (p + m <= n.-1)%N -> distances m (from p z).
Proof.
have [a b] := chain_distances => pm; split=> i i_m; first by apply: a; apply: leq_trans pm; rewrite leq_add2l.
by rewrite /from addnS; apply: b; apply: leq_trans pm; rewrite ltn_add2l.
Qed.

(* Both strings; the second is empty where no interior joint is passive. *)
Lemma first_string : exists xs, string_forces z k (cut k) xs.
Proof.
have c_n : (cut k < n)%N by apply: leq_ltn_trans cut_le _; case: n two.
apply: string_list => //; try exact: stiffness_ge0.
- by have [a b] := chain_distances; have h := cut_le; split=> i i_c; [apply: a|apply: b]; apply: leq_trans i_c h.
- exact: elastic_before.
- by apply: stiffness_ge0; case: n two.
rewrite !lt0r !stiffness_ge0 //; last by case: n two.
case: (altP (k 0%N =P 0)) => [k0|]; last by left.
case: (altP (k (cut k) =P 0)) => [kc|]; last by right.
by have := one _ c_n k0 kc => /(_ (ltn_trans (ltn0Sn _) c_n)).
Qed.

Lemma elastic_behind i : (cut k < n.-1)%N -> (0 < i <= n.-1 - cut k)%N -> 0 < from (cut k) k i.
Proof.
move=> c_lt /andP [i0 i_m].
have in_n j : (j <= n.-1 - cut k)%N -> (cut k + j < n)%N.
  move=> j_m; apply: (@leq_ltn_trans n.-1); last by case: n two.
  by rewrite -(subnKC (ltnW c_lt)) leq_add2l.
rewrite lt0r stiffness_ge0 ?in_n // andbT; apply/eqP => ki.
have := one (in_n _ i_m) (in_n 0%N (leq0n _)) ki; rewrite addn0 => /(_ (cut_passive c_lt)) /eqP.
by rewrite -[X in _ == X]addn0 eqn_add2l gtn_eqF.
Qed.

Lemma second_string : exists ys, string_forces (from (cut k) z) (from (cut k) k) (n.-1 - cut k) ys.
Proof.
have c_le := cut_le; case: (posnP (n.-1 - cut k)) => [-> | pos].
  exists [::]; split=> //; split=> //; exists (from (cut k) z 0 ^+ 2).
    rewrite expf_neq0 // /from addn0 gt_eqF // distance_gt0 //.
    by apply: leq_ltn_trans c_le _; case: n two.
  by rewrite big_nil alg_polyC.
have c_lt : (cut k < n.-1)%N by rewrite -subn_gt0.
have kc := cut_passive c_lt.
have kp i := @elastic_behind i c_lt.
apply: string_list => //.
- by apply: distances_from; rewrite subnKC.
- by move=> i /andP [i0 i_m]; apply: kp; rewrite i0 ltnW.
- by rewrite /from addn0 kc.
- by apply: ltW; apply: kp; rewrite pos leqnn.
by right; apply: kp; rewrite pos leqnn.
Qed.

Lemma D_recursion : D n L k = - H z k n.-1.
Proof.
apply: poly_ext => F; rewrite horner_D pencil_bordered hornerN hornerH.
have nz i : (i <= n.-1)%N -> z i != 0.
  by move=> i_n; rewrite gt_eqF //; have [a _] := chain_distances; apply: a.
have := recursion_det k F nz; rewrite prednK //; exact: ltnW.
Qed.

(* D is, up to a constant, the product of both strings. *)
Lemma D_product : exists2 c, c != 0 &
  D n L k = c *: (H z k (cut k) * H (from (cut k) z) (from (cut k) k) (n.-1 - cut k)).
Proof.
have zc : z (cut k) != 0 by rewrite gt_eqF //; have [a _] := chain_distances; apply/a/cut_le.
rewrite D_recursion; case: (ltngtP (cut k) n.-1) cut_le => // [c_n _|-> _]; last first.
  exists (- (z n.-1 ^- 2)); rewrite ?oppr_eq0 ?invr_eq0 ?expf_neq0 //.
    by rewrite gt_eqF //; have [a _] := chain_distances; apply/a/leqnn.
  have zn : z n.-1 != 0 by rewrite gt_eqF //; have [a _] := chain_distances; apply/a/leqnn.
  rewrite subnn /(H _ _ 0) /= /from addn0 mulrC mul_polyC scalerA mulNr mulVf ?expf_neq0 //.
  by rewrite scaleN1r.
have kc := cut_passive c_n; exists (- (z (cut k) ^- 2)); first by rewrite oppr_eq0 invr_eq0 expf_neq0.
have [+ _] := behind_passive z (n.-1 - cut k) kc; rewrite subnKC ?(ltnW c_n) // => ->.
rewrite (at_passive z kc) -scalerAl scalerA mulNr mulVf ?expf_neq0 //.
by rewrite scaleN1r.
Qed.

(* The roots of D are those of both strings. *)
Lemma roots_of_strings xs ys : string_forces z k (cut k) xs ->
  string_forces (from (cut k) z) (from (cut k) k) (n.-1 - cut k) ys -> roots_of (D n L k) (sort <=%R (xs ++ ys)).
Proof.
move=> [[_ [c c0 cE]] _ _ _ _] [[_ [d d0 dE]] _ _ _ _]; split; first exact: sort_le_sorted.
have pe : perm_eq (sort <=%R (xs ++ ys)) (xs ++ ys) by apply/permPl/perm_sort.
have [e e0 ->] := D_product; exists (e * (c * d)); first by rewrite !mulf_neq0.
by rewrite (perm_big _ pe) big_cat [in LHS]cE [in LHS]dE /= -scalerAl -scalerAr !scalerA mulrA.
Qed.

(* All of them: n - 1, positive, the roots of D with multiplicity, counted by sign changes. *)
Theorem critical_forces : exists fs,
  [/\ roots_of (D n L k) fs, size fs = n.-1, all (fun f => 0 < f) fs &
      forall F, count_below F = count (fun f => f < F) fs].
Proof.
have [xs fx] := first_string; have [ys fy] := second_string.
exists (sort <=%R (xs ++ ys)); have pe : perm_eq (sort <=%R (xs ++ ys)) (xs ++ ys) by apply/permPl/perm_sort.
have := roots_of_strings fx fy; case: fx fy => [_ _ sx px cx] [_ _ sy py cy]; split=> //.
- by rewrite size_sort size_cat sx sy subnKC // cut_le.
- by rewrite (perm_all _ pe) all_cat px py.
by move=> F; rewrite /count_below cx cy (permP pe) count_cat.
Qed.

(* No two agree unless an interior joint is passive. *)
Theorem simple_forces fs : no_interior_passive n k -> roots_of (D n L k) fs -> uniq fs.
Proof.
move=> elastic rfs; have c_n : cut k = n.-1.
  case: (ltngtP (cut k) n.-1) cut_le => // h _.
  have := cut_passive h => /eqP; rewrite (negPf (elastic _ _ _)) //.
  by rewrite -(prednK (ltnW two)) ltnS.
have [xs [[sx [c c0 cE]] ux _ _ _]] := first_string.
have [e e0 DE] := D_product.
suff : roots_of (D n L k) xs by move/(roots_of_inj rfs) => ->.
have zn : z n.-1 != 0 by rewrite gt_eqF //; have [a _] := chain_distances; apply/a/leqnn.
split=> //; exists (e * (c * z n.-1 ^+ 2)); first by rewrite !mulf_neq0.
rewrite DE cE c_n subnn /(H _ _ 0) /= /from addn0 [X in _ *: X]mulrC mul_polyC !scalerA.
by congr (_ *: _); ring.
Qed.

End Forces.
