(* Equal links: which forces are critical, in closed form: theorem "Equal links" of theorems.md. *)
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp Require Import complex.
From mathcomp Require Import zify ring.
Require Import chain determinant string recursion forces definite orientations.

Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Import Order.TTheory GRing.Theory Num.Theory.
Local Open Scope ring_scope.

(* Chebyshev's polynomials of the second kind, S_j = U_(j-1), and of the third, V_j = U_j - U_(j-1). *)
Section Chebyshev.

Variables (R : comRingType) (x : R).

Fixpoint both j : R * R := if j is i.+1 then ((both i).2, 2%:R * x * (both i).2 - (both i).1) else (0, 1).
Definition S j : R := (both j).1.
Definition V j : R := S j.+1 - S j.

Lemma S_S j : S j.+2 = 2%:R * x * S j.+1 - S j. Proof. by []. Qed.
Lemma V_S j : V j.+2 = 2%:R * x * V j.+1 - V j. Proof. by rewrite /V !S_S; ring. Qed.
Lemma V_0 : V 0 = 1. Proof. by rewrite /V /S /= subr0. Qed.
Lemma V_1 : V 1 = 2%:R * x - 1. Proof. by rewrite /V /S /= mulr1 subr0. Qed.
Lemma V_step j : V j.+1 - V j = 2%:R * (x - 1) * S j.+1. Proof. by rewrite /V S_S; ring. Qed.
Lemma sum_V j : \sum_(0 <= i < j) V i = S j.
Proof. by rewrite /V telescope_sumr // /S /= subr0. Qed.

End Chebyshev.

Section Equal.

Variables (R : realFieldType) (n : nat) (l kk base F : R).
Hypotheses (two : (1 < n)%N) (l0 : 0 < l) (k0 : 0 < kk) (F0 : F != 0).

Definition equal_length (j : nat) : R := l.
Definition equal_stiffness (i : nat) : R := if i is 0 then base else kk.
Definition cosine : R := 1 - F * l / (2%:R * kk).

Let x := cosine.
Let n0 : n%:R != 0 :> R. Proof. by rewrite pnatr_eq0 -lt0n ltnW. Qed.
Let Fx : F * l = 2%:R * kk * (1 - x).
Proof. by rewrite /x /cosine; field; rewrite gt_eqF. Qed.
Let x1 : x != 1.
Proof.
apply/eqP => e; have /eqP := Fx; rewrite e subrr mulr0 mulf_eq0 (negPf F0) /=.
by rewrite gt_eqF.
Qed.

(* The balance of a link, with the orientations from a = Fy / F up. *)
Let w (t : nat -> R) (a : R) j := t j - a.

Lemma balance_inner t a j : (0 < j)%N -> (j.+1 < n)%N ->
  balance n equal_length equal_stiffness F (F * a) t j = kk * (2%:R * x * w t a j - w t a j.-1 - w t a j.+1).
Proof.
case: j => // j _ j_n; rewrite /balance j_n /turn_of /w /=.
have -> : F * (l * t j.+1) = F * l * t j.+1 by rewrite mulrA.
by rewrite [F * a * _]mulrAC Fx; ring.
Qed.

Lemma balance_last t a : balance n equal_length equal_stiffness F (F * a) t n.-1 =
  kk * ((2%:R * x - 1) * w t a n.-1 - w t a n.-2).
Proof.
rewrite /balance prednK ?ltnn; last exact: ltnW.
have -> : n.-1 = n.-2.+1 by lia.
rewrite /turn_of /w /= subr0 mulrA [F * a * _]mulrAC Fx; ring.
Qed.

Lemma balance_first t a : balance n equal_length equal_stiffness F (F * a) t 0 =
  base * (w t a 0 + a) + kk * (2%:R * x * w t a 0 - w t a 1 - w t a 0).
Proof.
by rewrite /balance two /turn_of /w /= subr0 mulrA [F * a * _]mulrAC Fx; ring.
Qed.

Let L := equal_length.
Let k := equal_stiffness.

Lemma sum_w t a : \sum_(0 <= j < n) L j * t j = l * (\sum_(0 <= j < n) w t a j + n%:R * a).
Proof.
rewrite /L /equal_length -mulr_sumr; congr (_ * _).
by rewrite /w sumrB sumr_const_nat subn0 -[a *+ n]mulr_natl subrK.
Qed.

(* On a base of any stiffness. *)
Theorem critical_equal : critical n L k F <->
  base * (n%:R * V x n.-1 - S x n) = 2%:R * n%:R * kk * (1 - x) * S x n.
Proof.
have nE : n = n.-2.+2 by lia.
have edge a c : base * (c * V x n.-1 + a) + kk * (2%:R * x * (c * V x n.-1) - c * V x n.-2 - c * V x n.-1) =
    base * (c * V x n.-1 + a) - kk * c * (2%:R * (1 - x) * S x n).
  have e : V x n = 2%:R * x * V x n.-1 - V x n.-2 by rewrite nE V_S.
  have e' : V x n - V x n.-1 = 2%:R * (x - 1) * S x n by rewrite [in LHS]nE V_step -nE.
  transitivity (base * (c * V x n.-1 + a) + kk * c * (V x n - V x n.-1)); first by rewrite e; ring.
  by rewrite e'; ring.
split=> [[q [Fy]]|h].
  rewrite [q]shape_theta; set t := theta q => /mode_moments [q0 /moments_balances bal axis].
  pose a := Fy / F; have Fa : Fy = F * a by rewrite /a mulrC divfK.
  rewrite Fa in bal; pose c := w t a n.-1.
  have wV j : (j < n)%N -> w t a (n.-1 - j) = c * V x j.
    elim/ltn_ind: j => -[|[|j]] IH j_n; first by rewrite subn0 V_0 mulr1.
      have /eqP := bal n.-1 (ltac:(lia)); rewrite balance_last mulf_eq0 gt_eqF //= subr_eq0 => /eqP e.
      by rewrite V_1 subn1 -e; apply: mulrC.
    have := bal (n.-1 - j.+1)%N (ltac:(lia)); rewrite balance_inner; [|lia|lia].
    have -> : (n.-1 - j.+1).-1 = (n.-1 - j.+2)%N by lia.
    have -> : (n.-1 - j.+1).+1 = (n.-1 - j)%N by lia.
    rewrite (IH j) ?(IH j.+1); try lia; move/eqP; rewrite mulf_eq0 gt_eqF //= V_S => /eqP e.
    have -> : w t a (n.-1 - j.+2) = 2%:R * x * (c * V x j.+1) - c * V x j -
        (2%:R * x * (c * V x j.+1) - w t a (n.-1 - j.+2) - c * V x j) by ring.
    by rewrite e subr0; ring.
  have sumV : \sum_(0 <= j < n) w t a j = c * S x n.
    rewrite -sum_V mulr_sumr big_nat_rev; apply: eq_big_nat => j /andP [_ j_n].
    by rewrite -wV //; congr (w t a _); lia.
  have ca : c * S x n = - (n%:R * a).
    have /eqP := axis; rewrite (sum_w t a) sumV mulf_eq0 gt_eqF //= addr_eq0.
    by move/eqP.
  have c0 : c != 0.
    apply: contraNneq q0 => c0; rewrite shape_eq0; apply/forallP => i.
    have a0 : a = 0 by have /eqP := ca; rewrite c0 mul0r eq_sym oppr_eq0 mulf_eq0 (negPf n0) => /eqP.
    have := wV (n.-1 - i)%N (ltac:(have := ltn_ord i; lia)).
    have -> : (n.-1 - (n.-1 - i))%N = i by have := ltn_ord i; lia.
    by rewrite c0 mul0r /w a0 subr0 => /eqP.
  have := bal 0%N (ltac:(lia)); rewrite balance_first.
  have -> : w t a 0 = c * V x n.-1 by rewrite -wV ?subnn //; lia.
  have -> : w t a 1 = c * V x n.-2 by rewrite -wV; [congr (w t a _)|]; lia.
  rewrite edge => e; apply: (mulfI c0).
  have aE : n%:R * a = - (c * S x n) by rewrite ca opprK.
  transitivity (n%:R * (base * (c * V x n.-1 + a)) - base * (n%:R * a) + base * (- (c * S x n))); first by ring.
  rewrite -aE addrNK; move/eqP: e; rewrite subr_eq0 => /eqP ->; ring.
pose a := - S x n / n%:R; pose t j := V x (n.-1 - j) + a.
have wt j : w t a j = V x (n.-1 - j) by rewrite /w /t addrK.
have na : n%:R * a = - S x n by rewrite /a mulrC divfK.
exists (shape n t), (F * a); apply/mode_moments; split.
- rewrite shape_eq0; apply/forallP => z; move/eqP: x1; apply.
  have := eqP (z (Ordinal (ltac:(lia) : (n.-1 < n)%N))); have := eqP (z (Ordinal (ltac:(lia) : (n.-2 < n)%N))).
  rewrite /t /= subnn; have -> : (n.-1 - n.-2)%N = 1%N by lia.
  rewrite V_0 V_1 => <- /eqP; rewrite (inj_eq (addIr _)) => /eqP e.
  apply: (@mulfI _ 2%:R); first by rewrite pnatr_eq0.
  by apply: (@addIr _ (-1)); rewrite -e; ring.
- apply/moments_balances => j j_n; case: (posnP j) => [->|j0].
    rewrite balance_first !wt subn0; have -> : (n.-1 - 1)%N = n.-2 by lia.
    have := edge a 1; rewrite !mul1r mulr1 => ->; apply: (mulfI n0); rewrite mulr0.
    transitivity (base * (n%:R * V x n.-1 + n%:R * a) - 2%:R * n%:R * kk * (1 - x) * S x n); first by ring.
    by rewrite na h subrr.
  case: (eqVneq j n.-1) => [->|j_last].
    rewrite balance_last !wt subnn; have -> : (n.-1 - n.-2)%N = 1%N by lia.
    by rewrite V_0 V_1 mulr1 subrr mulr0.
  rewrite balance_inner ?wt //; last by lia.
  have -> : (n.-1 - j.-1 = (n.-1 - j.+1).+2)%N by lia.
  have -> : (n.-1 - j = (n.-1 - j.+1).+1)%N by lia.
  by rewrite V_S; ring.
rewrite (sum_w t a) na -sum_V; apply/eqP; rewrite mulf_eq0 gt_eqF //= subr_eq0; apply/eqP.
by rewrite [RHS]big_nat_rev; apply: eq_big_nat => j /andP [_ j_n]; rewrite wt; congr (V x _); lia.
Qed.

End Equal.

(* By angles: cos phi + i sin phi as a point c + i s of the unit circle, so that its n-th power is cos n phi + i sin n phi. *)
Section Angles.

Variables (R : rcfType) (n : nat) (l kk c s : R).
Hypotheses (two : (1 < n)%N) (l0 : 0 < l) (k0 : 0 < kk) (circle : c ^+ 2 + s ^+ 2 = 1) (s0 : s != 0).
Local Open Scope complex_scope.

Let z : R[i] := c +i* s.
Definition force_at : R := 2%:R * kk / l * (1 - c).

Lemma power_at j : z ^+ j.+1 = (c * S c j.+1 - S c j) +i* (s * S c j.+1).
Proof.
elim: j => [|j IH]; first by rewrite expr1 /S /= !mulr1 subr0.
rewrite exprS IH S_S; have e : s ^+ 2 = 1 - c ^+ 2 by rewrite -circle addrC addKr.
apply/eqP; rewrite eq_complex /=; apply/andP; split; apply/eqP; last by ring.
transitivity (c * (c * S c j.+1 - S c j) - s ^+ 2 * S c j.+1); first by ring.
by rewrite e; ring.
Qed.

Let c1 : 1 - c != 0.
Proof.
apply: contra s0 => /eqP/subr0_eq e; move: circle; rewrite -e expr1n => /(canRL (addKr _)).
by rewrite addNr => /eqP; rewrite sqrf_eq0.
Qed.
Let F0 : force_at != 0.
Proof.
by apply: mulf_neq0 c1; apply: mulf_neq0; rewrite ?invr_eq0 ?(gt_eqF l0) // mulf_neq0 ?pnatr_eq0 // gt_eqF.
Qed.
Let cosineE : cosine l kk force_at = c.
Proof. by rewrite /cosine /force_at; field; rewrite !gt_eqF. Qed.
Let im : complex.Im (z ^+ n) = s * S c n.
Proof. by case: n two => // m _; rewrite power_at. Qed.
Let re : complex.Re (z ^+ n) = c * S c n - S c n.-1.
Proof. by case: n two => // m _; rewrite power_at. Qed.

(* (a): sin n phi = 0 *)
Theorem equal_on_passive_base : critical n (equal_length l) (equal_stiffness kk 0) force_at <-> complex.Im (z ^+ n) = 0.
Proof.
rewrite critical_equal // cosineE mul0r im; split=> [/esym/eqP|/eqP]; rewrite !mulf_eq0.
  by rewrite !pnatr_eq0 (gt_eqF k0) (negPf c1) (gtn_eqF (ltnW two)) /= => /eqP ->; rewrite mulr0.
by rewrite (negPf s0) /= => /eqP ->; rewrite mulr0.
Qed.

(* (b): (n (1 - cos phi) + 1) sin n phi = n sin phi cos n phi *)
Theorem equal_on_elastic_base : critical n (equal_length l) (equal_stiffness kk kk) force_at <->
  (n%:R * (1 - c) + 1) * complex.Im (z ^+ n) = n%:R * s * complex.Re (z ^+ n).
Proof.
rewrite critical_equal // cosineE im re; have -> : V c n.-1 = S c n - S c n.-1 by rewrite /V prednK // ltnW.
have d : s * (kk * (n%:R * (S c n - S c n.-1) - S c n) - 2%:R * n%:R * kk * (1 - c) * S c n) =
    kk * (n%:R * s * (c * S c n - S c n.-1) - (n%:R * (1 - c) + 1) * (s * S c n)) by ring.
split=> e; apply/eqP; rewrite eq_sym -subr_eq0.
  by apply/eqP/(mulfI (negbT (gt_eqF k0))); rewrite -d e subrr !mulr0.
by rewrite -oppr_eq0 opprB; apply/eqP/(mulfI s0); rewrite d e subrr !mulr0.
Qed.

End Angles.
