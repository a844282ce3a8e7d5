(* What the checker accepts of polynomials is true of the real chain: the matrices A and B, and ties. *)
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp Require Import polyrcf.
From mathcomp Require Import zify ssrZ.
From Coq Require Import ZArith.
From mathcomp Require Import ring.
Delimit Scope nat_scope with N.
Require Import chain determinant string recursion forces definite modes eigenvalues integers polynomials sound.
Require checker.

Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Import Order.TTheory GRing.Theory Num.Theory.
Local Open Scope ring_scope.

Lemma tie_numbers (a b : nat) (m : Z) : Z.of_nat a = (m - 1)%Z -> Z.of_nat b = (m + 1)%Z ->
  Z.to_nat m = a.+1 /\ b = a.+2.
Proof. by lia. Qed.

Section Certificate.

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
Hypotheses (law : checker.lawful js).

Let n := links c.
Let L := length_of R c.
Let k := stiffness_of R c.
Let z := distance n L.

Let two : (1 < n)%N. Proof. exact: (two_links R cL ck dL0 dk0 same law). Qed.
Let lawful : chain_of_links n L k. Proof. exact: chain_lawful. Qed.
Let one : at_most_one_passive n k. Proof. exact: one_passive. Qed.
Let size_n : size js = n. Proof. exact: (size_js R cL ck same). Qed.
Let stand i : (i < n)%N -> stands (zr dL) (zr dk) L z k (nth x0 js i) i.
Proof. exact: joints_stand. Qed.
Let L0 : 0 < zr dL. Proof. exact: zr_gt0. Qed.
Let k0 : 0 < zr dk. Proof. exact: zr_gt0. Qed.
Let z0 i : (i < n)%N -> 0 < z i. Proof. exact: (distance_gt0 lawful). Qed.

(* The factor that the recursion in integers has gathered over the whole chain. *)
Lemma gatheredE : zr (checker.gathered dL dk js) = gathered (zr dL) (zr dk) z n.-1.
Proof.
have prods : forall s : seq checker.joint, zr (List.fold_right Z.mul (dL * dL)%Z
    (List.map (fun j => (checker.dist j * dk)%Z) s)) = zr dL ^+ 2 * \prod_(j <- s) (zr (checker.dist j) * zr dk).
  elim=> [|j s IH] /=; first by rewrite big_nil mulr1 zrM expr2.
  by rewrite big_cons !zrM IH mulrCA.
have removelastE : forall s : seq checker.joint, List.removelast s = take (size s).-1 s.
  elim=> // j [|j' s] //= IH; by rewrite -[RHS]/(j :: take (size (j' :: s)).-1 (j' :: s)) -IH.
rewrite /checker.gathered zrM prods removelastE -[List.tl js]/(behead js).
have sb : size (behead js) = n.-1 by rewrite size_behead size_n.
have -> : take (size (behead js)).-1 (behead js) = [seq nth x0 js i.+1 | i <- index_iota 0 n.-2].
  rewrite /index_iota subn0; apply: (@eq_from_nth _ x0); first by rewrite size_map size_iota size_take sb; case: (n) two => [|[|m]] //= _; rewrite ltnSn.
  move=> i; rewrite size_take sb => i_n; have {}i_n : (i < n.-2)%N by move: i_n; case: (n) two => [|[|m]] //= _; rewrite ltnSn.
  by rewrite nth_take // nth_behead (nth_map 0%N) ?size_iota // nth_iota.
have {prods removelastE} nE : n.-1 = n.-2.+1 by case: (n) two => [|[|m]].
rewrite [in RHS]nE /gathered big_map big_mkord big_ord_recl.
have zz : z 0%N != 0 by rewrite gt_eqF // z0 // ltnW.
have -> : \prod_(i < n.-2) (zr (checker.dist (nth x0 js i.+1)) * zr dk) = \prod_(i < n.-2) (zr dL * zr dk * z (lift ord0 i)).
  apply: eq_bigr => i _; rewrite lift0; have [|_ -> _] := stand (i := i.+1); last by ring.
  by move: (nat_of_ord i) (ltn_ord i) => j; rewrite -subn2 ltn_subRL add2n => /ltnW.
by rewrite -[z ord0]/(z 0%N); move: (zr dL) (zr dk) (z 0%N) (\prod_(_ < _) _) zz => a b u P nz; field.
Qed.

Lemma whole_polynomial x :
  at_force (checker.polynomial js) x = - (zr (checker.gathered dL dk js) * (D n L k).[x * zr dL / zr dk]).
Proof.
rewrite (D_recursion two lawful) hornerN mulrN opprK gatheredE.
rewrite (polynomial_stands (x0 := x0) (L := L) (z := z) (k := k) L0 k0) size_n //.
- exact: ltnW.
- by move=> l l_n; apply: (chain_beads R); apply: ltnW.
Qed.

(* Ranks, multiplicities of the eigenvalue zero, and the coefficients of det(lambda B - A). *)
Lemma matrices_true m : checker.matrices_hold dL dk js m ->
  [/\ checker.rank_A m = Z.of_nat (\rank (A n L)), checker.rank_B m = Z.of_nat (\rank (B n L k)),
      exists2 p, char_poly (BinvA n L k) = 'X^(Z.to_nat (checker.zero_algebraic m)) * p & ~~ root p 0,
      checker.zero_geometric m = Z.of_nat (\rank (kermx (BinvA n L k))) &
      forall x, (stated R (checker.characteristic m)).[x] = \det (x *: B n L k - A n L)].
Proof.
rewrite /checker.matrices_hold lengthE size_n.
set s := checker.characteristic m; set d := checker.common s; set cs := checker.cleared d s.
case/andP=> [/andP [/andP [/andP [/andP [/andP [/andP [/Z.eqb_eq -> /Z.eqb_eq ->] /Z.eqb_eq ->] /Z.eqb_eq ->] len] clear] d0] prop].
have rA : \rank (A n L) = n by apply: rank_A => i i_n; rewrite gt_eqF //; case: lawful => h _; apply: h.
split.
- by rewrite rA.
- by rewrite (rank_B two lawful one) addn1; lia.
- have [fs [rfs _ _ _]] := critical_forces two lawful one.
  by have [e r] := zero_twice two lawful one rfs; exists (\prod_(f <- fs) ('X - (- f^-1)%:P)).
- by rewrite mxrank_ker (rank_BinvA two lawful one) addnC addnK.
have dd : zr d != 0 by rewrite gt_eqF //; apply: zr_gt0.
have [sz _] := clearsP R clear.
have size_cs : size cs = (n + 2)%N.
  by rewrite sz; move: len => /PeanoNat.Nat.eqb_eq; rewrite lengthE => ->; rewrite plusE.
have away x : x != 0 -> (stated R s).[x] = \det (x *: B n L k - A n L).
  move=> nz; have nzV : x^-1 != 0 by rewrite invr_eq0.
  have := at_rev cs nzV; rewrite invrK (at_cleared (R := R) x clear) size_cs.
  have -> : at_force (rev cs) x^-1 = zr d * (D n L k).[- x^-1].
    have g0 : zr (checker.gathered dL dk js) != 0.
      rewrite gatheredE; apply: gathered_neq0 => // l l_n; apply: z0.
      by apply: leq_ltn_trans l_n _; rewrite ltn_predL ltnW.
    have := at_proportional (R := R) x^-1 (a := dL) _ prop; rewrite gt_eqF // => /(_ isT).
    rewrite revE at_alternated whole_polynomial -[(-1)%Z]/(- (1))%Z zrN zr1 => e; apply: (mulfI g0); rewrite {}e.
    have -> : - (x^-1 * zr dk / zr dL) * zr dL / zr dk = - x^-1 by field; rewrite nz !gt_eqF.
    by ring.
  have -> : x *: B n L k - A n L = x *: pencil n L k (- x^-1).
    by rewrite /pencil scalerDr scalerA mulrN mulfV // scaleN1r addrC.
  rewrite detZ -horner_D addnS exprS exprVn; have X0 : x ^+ (n + 1) != 0 by rewrite expf_neq0.
  move: (x ^+ _) (_.[x]) (_.[- _]) X0 => X S V X0 e; apply: (mulfI dd).
  transitivity (X * x * (x^-1 * X^-1 * (zr d * S))); first by field; rewrite nz X0.
  by rewrite e; field; rewrite nz.
have : 'X * stated R s = 'X * \det ('X *: map_mx polyC (B n L k) + map_mx polyC (- A n L)).
  by apply: poly_ext => x; rewrite !hornerM hornerX horner_det; case: (altP (x =P 0)) => [->|/away ->]; rewrite ?mul0r.
by move/(mulfI (negbT (polyX_eq0 R))) => e x; rewrite e horner_det.
Qed.

(* A common root of both strings is a double root. *)
Lemma common_root fs x : roots_of (D n L k) fs -> (H z k (cut n k)).[x] = 0 ->
  (H (from (cut n k) z) (from (cut n k) k) (n.-1 - cut n k)).[x] = 0 -> (1 < count_mem x fs)%N.
Proof.
move=> rfs hx hy; have [xs fx] := first_string two lawful one; have [ys fy] := second_string two lawful one.
have -> := roots_of_inj rfs (roots_of_strings two lawful fx fy).
have /permP -> : perm_eq (sort <=%R (xs ++ ys)) (xs ++ ys) by apply/permPl/perm_sort.
rewrite count_cat (_ : 2 = 1 + 1)%N // leq_add // -has_count has_pred1.
  by rewrite -(roots_of_root x (string_roots_of fx)); apply/eqP.
by rewrite -(roots_of_root x (string_roots_of fy)); apply/eqP.
Qed.

(* What divides the polynomial of a part of the chain has its roots among those of the part. *)
Lemma divides_root (part : seq checker.joint) s e (zp kp Lp : nat -> R) x : (0 < size part)%N ->
  (forall l, (l < size part)%N -> stands (zr dL) (zr dk) Lp zp kp (nth x0 part l) l) ->
  (forall l, (l < size part)%N -> 0 < zp l) ->
  (forall l, (l.+1 < size part)%N -> zp l - zp l.+1 = Lp l) ->
  checker.divides_part dL dk s e part ->
  root (as_poly R (checker.cleared (checker.common s) s)) x -> (H zp kp (size part).-1).[x] = 0.
Proof.
move=> sz st zpos Ls; rewrite /checker.divides_part; set f := checker.cleared _ s; set g := checker.cleared _ e.
case/andP=> [/andP [/andP [/andP [/andP [_ _] df] dg] _] prop] /eqP; rewrite horner_as_poly => fx.
have := at_proportional (R := R) x (a := dL) _ prop; rewrite gt_eqF // => /(_ isT).
rewrite at_times fx mul0r mulr0 zrM (polynomial_stands (x0 := x0) (L := Lp) (z := zp) (k := kp) L0 k0) //.
have -> : x * zr dk / zr dL * zr dL / zr dk = x by field; rewrite !gt_eqF.
have g0 : gathered (zr dL) (zr dk) zp (size part).-1 != 0.
  by apply: gathered_neq0 => // l l_p; apply: zpos; rewrite -(prednK sz) ltnS.
have nz : zr (checker.common s) * zr (checker.common e) != 0.
  by apply: mulf_neq0; rewrite gt_eqF //; apply: zr_gt0.
by move/esym => h; apply: (mulfI g0); apply: (mulfI nz); rewrite h !mulr0.
Qed.

Lemma counts_differ (fs : seq R) (a b : R) : a < b ->
  count (fun f => f < b) fs = (count (fun f => (f < a)%R) fs + count (fun f => (a <= f < b)%R) fs)%N.
Proof.
move=> ab; elim: fs => //= f s ->; rewrite addnACA; congr (_ + _)%N.
by case: (ltP f a) => h; rewrite ?(lt_trans h ab) // add0n.
Qed.

Lemma split_count (p : pred R) x (fs : seq R) : p x ->
  count p fs = (count_mem x fs + count (fun f => p f && (f != x)) fs)%N.
Proof.
move=> px; elim: fs => //= y s ->; rewrite addnACA; congr (_ + _)%N.
case: (altP (y =P x)) => [->|_]; first by rewrite px.
by rewrite andbT add0n.
Qed.

(* A tie: F_m = F_{m+1}. *)
Lemma tie_true fs t : roots_of (D n L k) fs -> checker.tied dL dk js t ->
  let m := Z.to_nat (checker.tie_number t) in
  [/\ (0 < m < n.-1)%N, nth 0 fs m.-1 = nth 0 fs m &
      value R (checker.tie_low t) <= nth 0 fs m < value R (checker.tie_high t)].
Proof.
move=> rfs; rewrite /checker.tied; cbv zeta; set f := checker.cleared _ (checker.factor t).
case/andP=> [/andP [/andP [/andP [/andP [/andP [/andP [/andP [pl ph] _] lh] cl] ch] sg] _]].
case: (checker.cofactors t) => [|c1 [|c2 [|? ?]]] // /andP [d1 d2].
set a := value R (checker.tie_low t); set b := value R (checker.tie_high t).
have ab : a < b by rewrite -lessP.
have : Num.sg (as_poly R f).[a] * Num.sg (as_poly R f).[b] = -1.
  by rewrite -sgrM !horner_as_poly ltr0_sg // signs_differ.
case/(ivt_sign (ltW ab)) => x; rewrite inE /= => /andP [ax xb] rt.
have c_le := @cut_le R n k two; have c_n : (cut n k < n)%N by apply: leq_ltn_trans c_le _; rewrite ltn_predL ltnW.
have cE : checker.cut js = cut n k by apply: cutE.
have h1 : (H z k (cut n k)).[x] = 0.
  have sf : size (checker.first_part js) = (cut n k).+1 by rewrite /checker.first_part firstnE cE size_takel // size_n.
  have := divides_root (part := checker.first_part js) (zp := z) (kp := k) (Lp := L) (x := x); rewrite sf /=; apply=> //.
  - move=> l l_c; rewrite /checker.first_part firstnE cE nth_take //; apply: stand; exact: leq_trans l_c _.
  - by move=> l l_c; apply: z0; apply: leq_trans l_c _.
  - by move=> l l_c; apply: (chain_beads R); apply: leq_trans (ltnW l_c) _.
  - exact: d1.
  exact: rt.
have h2 : (H (from (cut n k) z) (from (cut n k) k) (n.-1 - cut n k)).[x] = 0.
  have ss : size (checker.second_part js) = (n - cut n k)%N by rewrite /checker.second_part skipnE cE size_drop size_n.
  have pE : (n - cut n k).-1 = (n.-1 - cut n k)%N by rewrite -subnS -add1n subnDA subn1.
  have := divides_root (part := checker.second_part js) (zp := from (cut n k) z) (kp := from (cut n k) k)
    (Lp := from (cut n k) L) (x := x); rewrite ss pE; apply=> //.
  - by rewrite subn_gt0.
  - by move=> l l_c; rewrite /checker.second_part skipnE cE nth_drop; apply: stand; rewrite -ltn_subRL.
  - by move=> l l_c; apply: z0; rewrite -ltn_subRL.
  - by move=> l l_c; rewrite /from addnS; apply: (chain_beads R); rewrite -ltn_subRL ltnW.
  - exact: d2.
  exact: rt.
have twice := common_root rfs h1 h2.
have [gs [rgs sz _ cfs]] := critical_forces two lawful one.
rewrite -(roots_of_inj rfs rgs) {gs rgs} in sz cfs.
move: cl ch; rewrite !(count_atE R cL ck dL0 dk0 same law) // !cfs -/a -/b => /Z.eqb_eq cl /Z.eqb_eq ch.
set below := count (fun F => F < a) fs in cl; set above := count (fun F => F < b) fs in ch.
have [mE abE] := tie_numbers cl ch.
rewrite mE /= -[X in (_ < X)%N]sz; have sorted_fs : sorted <=%R fs by case: rfs.
have le_size : (below.+2 <= size fs)%N by rewrite -abE; exact: count_size.
have same_x i : (below <= i < below.+2)%N -> a <= nth 0 fs i < b /\ nth 0 fs i = x.
  case/andP=> i1 i2; have i_s : (i < size fs)%N by apply: leq_trans le_size.
  have within : a <= nth 0 fs i < b.
    by rewrite leNgt !nth_count // -/below -/above abE -leqNgt i1 i2.
  split; first exact: within.
  apply/eqP/negPn/negP => off.
  have := counts_differ fs ab; rewrite -/below -/above abE -addn2 => /addnI two_between.
  have split2 := @split_count (fun f => a <= f < b) x fs (introT andP (conj (ltW ax) xb)).
  have : has (fun f => (a <= f < b) && (f != x)) fs by apply/hasP; exists (nth 0 fs i); rewrite ?mem_nth // within off.
  rewrite has_count => w0; move: two_between; rewrite split2 => e.
  by have := leq_add twice w0; rewrite -e.
have [w1 e1] := same_x below.+1 (introT andP (conj (leqnSn _) (ltnSn _))); split; last by [].
- exact: le_size.
by have [_ ->] := same_x below (introT andP (conj (leqnn below) (leqnSn below.+1))).
Qed.

End Certificate.

(* Of a certificate that the checker accepts. *)
Section Accepted.

Variables (R : rcfType) (c : checker.certificate).
Hypothesis accepted : checker.holds c.
Let n := links c.
Let L := length_of R c.
Let k := stiffness_of R c.

(* The ranks, the multiplicities of the eigenvalue zero of B^-1 A, and the coefficients of det(lambda B - A). *)
Theorem matrices_sound m : checker.chain_matrices c = Some m ->
  [/\ checker.rank_A m = Z.of_nat (\rank (A n L)), checker.rank_B m = Z.of_nat (\rank (B n L k)),
      exists2 p, char_poly (BinvA n L k) = 'X^(Z.to_nat (checker.zero_algebraic m)) * p & ~~ root p 0,
      checker.zero_geometric m = Z.of_nat (\rank (kermx (BinvA n L k))) &
      forall x, (stated R (checker.characteristic m)).[x] = \det (x *: B n L k - A n L)].
Proof.
move=> cm; move: accepted; rewrite /checker.holds cm.
case/andP=> [/andP [/andP [/andP [/andP [/andP [/andP [/andP [/andP [/andP [cL ck] dL0] dk0] same] law] _] _] _] _] h].
exact: matrices_true.
Qed.

(* F_m = F_{m+1}, between the bounds. *)
Theorem ties_sound fs t : roots_of (D n L k) fs -> List.In t (checker.ties c) ->
  let m := Z.to_nat (checker.tie_number t) in
  [/\ (0 < m < n.-1)%N, nth 0 fs m.-1 = nth 0 fs m &
      value R (checker.tie_low t) <= nth 0 fs m < value R (checker.tie_high t)].
Proof.
move=> rfs t_in; move: accepted; rewrite /checker.holds.
case/andP=> [/andP [/andP [/andP [/andP [/andP [/andP [/andP [/andP [/andP [cL ck] dL0] dk0] same] law] _] _] ts] _] _].
by apply: tie_true => //; apply: (proj1 (List.forallb_forall _ _) ts).
Qed.

End Accepted.
