(* Sylvester's law of inertia for a quadratic form under linear conditions, and the counts of two forms compared. *)
From mathcomp Require Import all_ssreflect all_algebra.

Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Import Order.TTheory GRing.Theory Num.Theory.
Local Open Scope ring_scope.

Section Inertia.

Variable R : realFieldType.
Implicit Types (n m c : nat).

(* The conditions are rows; they hold of q where all of them vanish. *)
Definition vanish n (rows : seq 'rV[R]_n) (q : 'cV[R]_n) : Prop := forall r, r \in rows -> r *m q = 0.

Lemma vanish_cat n (rows rows' : seq 'rV[R]_n) q : vanish (rows ++ rows') q <-> vanish rows q /\ vanish rows' q.
Proof.
split=> [h|[a b] r]; last by rewrite mem_cat => /orP [/a|/b].
by split=> r r_in; apply: h; rewrite mem_cat r_in ?orbT.
Qed.

(* Fewer conditions than coordinates leave more than zero. *)
Lemma common_zero n (rows : seq 'rV[R]_n) : (size rows < n)%N -> exists2 q, q != 0 & vanish rows q.
Proof.
move=> few; pose X : 'M[R]_(size rows, n) := \matrix_(i, j) rows`_i 0 j.
have : kermx X^T != 0.
  rewrite kermx_eq0 /row_free neq_ltn; apply/orP; left.
  by apply: leq_ltn_trans few; rewrite mxrank_tr rank_leq_row.
case/rowV0Pn => u /sub_kermxP uX u0; exists u^T.
  by apply: contra u0 => /eqP h; rewrite -[u]trmxK h trmx0.
move=> r /(nthP 0) [i i_lt <-]; apply/trmx_inj; rewrite trmx_mul trmxK trmx0.
have -> : rows`_i^T = X^T *m (delta_mx (Ordinal i_lt) 0 : 'cV_(size rows)).
  by rewrite -colE; apply/colP => j; rewrite !mxE.
by rewrite mulmxA uX mul0mx.
Qed.

(* A sum of squares of linear forms, each with its weight. *)
Definition squares n (ps : seq (R * 'rV[R]_n)) (q : 'cV[R]_n) : R := \sum_(p <- ps) p.1 * (p.2 *m q) 0 0 ^+ 2.

(* Where V vanishes, E is such a sum: c of its weights are negative, and its linear forms determine q. *)
Definition inertia n (E : 'cV[R]_n -> R) (V : seq 'rV[R]_n) c : Prop := exists ps : seq (R * 'rV[R]_n),
  [/\ (size V + size ps = n)%N, count (fun p => p.1 < 0) ps = c, forall q, vanish V q -> E q = squares ps q &
      forall q, vanish V q -> vanish [seq p.2 | p <- ps] q -> q = 0].

Lemma squares_ge0 n (ps : seq (R * 'rV[R]_n)) q :
  (forall p, p \in ps -> p.1 < 0 -> p.2 *m q = 0) -> 0 <= squares ps q.
Proof.
move=> zero; rewrite /squares big_seq; apply: sumr_ge0 => p /zero {}zero; case: (ltrP p.1 0) => [/zero ->|p0].
  by rewrite mxE expr0n mulr0.
by rewrite mulr_ge0 ?sqr_ge0.
Qed.

Lemma squares_lt0 n (ps : seq (R * 'rV[R]_n)) q :
  (forall p, p \in ps -> ~~ (p.1 < 0) -> p.2 *m q = 0) -> ~ vanish [seq p.2 | p <- ps] q -> squares ps q < 0.
Proof.
elim: ps => [|p ps IH] zero nz; first by case: nz => r; rewrite in_nil.
have {}IH := IH (fun p' p'_in => zero p' (mem_behead (s := p :: ps) p'_in)).
have le : squares ps q <= 0.
  rewrite -oppr_ge0 /squares -sumrN big_seq; apply: sumr_ge0 => p' p'_in.
  have := zero p'; rewrite inE p'_in orbT => /(_ isT); case: (ltrP p'.1 0) => [p'0 _|_ /(_ isT) ->].
    by rewrite oppr_ge0 mulr_le0_ge0 ?sqr_ge0 // ltW.
  by rewrite mxE expr0n mulr0 oppr0.
rewrite /squares big_cons -/(squares ps q).
have := zero p; rewrite inE eqxx => /(_ isT); case: (ltrP p.1 0) => [p0 _|_ /(_ isT) pq]; last first.
  rewrite pq mxE expr0n mulr0 add0r; apply: IH => h; apply: nz => r; rewrite inE.
  by case/orP => [/eqP -> //|/h].
case: (eqVneq ((p.2 *m q) 0 0) 0) => [e|e]; last first.
  by apply: ltr_naddr => //; rewrite nmulr_rlt0 // lt0r sqrf_eq0 e sqr_ge0.
rewrite e expr0n mulr0 add0r; apply: IH => h; apply: nz => r; rewrite inE.
by case/orP => [/eqP ->|/h //]; apply/matrixP => i j; rewrite !ord1 e mxE.
Qed.

(* Where E' is negative, under V' and Z, X takes it to a shape under V of which E is no greater: then E' has at most as
   many negative squares as E, and one more for each further condition. *)
Theorem inertia_le n m (E : 'cV[R]_n -> R) (E' : 'cV[R]_m -> R) V V' c c' (X : 'M[R]_(n, m)) Z :
  inertia E V c -> inertia E' V' c' ->
  (forall q, vanish V' q -> vanish Z q -> E' q < 0 -> vanish V (X *m q) /\ E (X *m q) <= E' q) ->
  (c' <= c + size Z)%N.
Proof.
move=> [ps [sps <- Eps _]] [ps' [sps' <- Eps' inj']] h; rewrite leqNgt; apply/negP => many.
pose rest := [seq p.2 | p <- ps' & ~~ (p.1 < 0)]; pose sent := [seq p.2 *m X | p <- ps & p.1 < 0].
have [|q q0] := @common_zero m (V' ++ rest ++ Z ++ sent).
  rewrite !size_cat !size_map !size_filter -[X in (_ < X)%N]sps' ltn_add2l.
  by rewrite -(count_predC (fun p : R * 'rV[R]_m => p.1 < 0) ps') [X in (_ < X)%N]addnC ltn_add2l addnC.
case/vanish_cat => V'q /vanish_cat [restq] /vanish_cat [Zq sentq].
have E'q : E' q < 0.
  rewrite Eps' //; apply: squares_lt0 => [p p_in pn|nz]; last by move: q0; rewrite (inj' q V'q nz) eqxx.
  by apply: restq; apply: map_f; rewrite mem_filter pn.
have [VX le] := h q V'q Zq E'q; have := le_lt_trans le E'q; rewrite Eps // ltNge => /negP; apply.
apply: squares_ge0 => p p_in p0; rewrite mulmxA; apply: sentq.
by apply: (map_f (fun p : R * 'rV[R]_n => p.2 *m X)); rewrite mem_filter p0.
Qed.

End Inertia.

(* From counts to lists. *)
Section Lists.

Variable R : realFieldType.
Implicit Types (p : {poly R}) (fs : seq R).

(* Between any two forces there is one that is no root of a polynomial. *)
Lemma between p (a b : R) : p != 0 -> a < b -> exists x, [/\ a < x, x < b & p.[x] != 0].
Proof.
move=> p0 a_b; pose at_ i : R := a + (b - a) / i.+2%:R; have ba : 0 < b - a by rewrite subr_gt0.
have inside i : a < at_ i < b.
  rewrite /at_ ltr_addl divr_gt0 ?ltr0Sn //= -ltr_subr_addl ltr_pdivr_mulr ?ltr0Sn //.
  by rewrite ltr_pmulr // ltr1n.
case: (boolP (all (fun i => root p (at_ i)) (iota 0 (size p)))) => [all0|/allPn [i _ ni]]; last first.
  by exists (at_ i); have /andP [-> ->] := inside i.
have : (size [seq at_ i | i <- iota 0 (size p)] < size p)%N.
  apply: max_poly_roots => //; first by apply/allP => x /mapP [i i_in ->]; apply: (allP all0).
  rewrite map_inj_uniq ?iota_uniq // => i j /addrI /(mulfI (negbT (gt_eqF ba))) /invr_inj /eqP.
  by rewrite eqr_nat => /eqP [].
by rewrite size_map size_iota ltnn.
Qed.

Lemma count_below_nth fs m x : sorted <=%R fs -> (m < size fs)%N -> x <= fs`_m -> (count (fun f => f < x)%R fs <= m)%N.
Proof.
move=> sfs m_lt x_le; rewrite -{1}(cat_take_drop m fs) count_cat.
rewrite [X in (_ + X)%N](_ : _ = 0%N) ?addn0.
  by apply: leq_trans (count_size _ _) _; rewrite size_take m_lt.
apply/eqP; rewrite -leqn0 leqNgt -has_count; apply/hasPn => f /(nthP 0) [i i_lt <-]; rewrite -leNgt.
rewrite nth_drop; apply: le_trans x_le _; move: i_lt; rewrite size_drop ltn_subRL => i_lt.
by apply: (sorted_leq_nth le_trans le_refl 0 sfs) => //; rewrite ?inE // leq_addr.
Qed.

Lemma count_above_nth fs m x : sorted <=%R fs -> (m < size fs)%N -> fs`_m < x -> (m < count (fun f => f < x)%R fs)%N.
Proof.
move=> sfs m_lt lt_x; rewrite -(cat_take_drop m.+1 fs) count_cat.
apply: leq_trans (leq_addr _ _); rewrite -[X in (X <= _)%N](size_takel m_lt) leq_eqVlt; apply/orP; left.
rewrite eq_sym -all_count; apply/allP => f /(nthP 0) [i]; rewrite size_takel // => i_lt <-; rewrite nth_take //.
apply: le_lt_trans lt_x; apply: (sorted_leq_nth le_trans le_refl 0 sfs) => //; rewrite inE //.
exact: leq_trans i_lt m_lt.
Qed.

(* Where fs' has at most d more below every force but some, its forces are not below those of fs, d places on. *)
Lemma forces_le fs fs' p d m : sorted <=%R fs -> sorted <=%R fs' -> p != 0 ->
  (forall x, fs'`_(m + d) < x -> p.[x] != 0 -> (count (fun f => f < x)%R fs' <= count (fun f => f < x)%R fs + d)%N) ->
  (m < size fs)%N -> (m + d < size fs')%N -> fs`_m <= fs'`_(m + d).
Proof.
move=> sfs sfs' p0 h m_lt md_lt; rewrite leNgt; apply/negP => /(between p0) [x [x_gt x_lt px]].
have := count_above_nth sfs' md_lt x_gt; rewrite ltnNge => /negP; apply.
by apply: leq_trans (h x x_gt px) _; rewrite leq_add2r; apply: count_below_nth; rewrite // ltW.
Qed.

End Lists.
