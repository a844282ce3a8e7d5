(* All stiffnesses or all lengths by one factor: theorem "Scaling" of theorems.md. *)
From mathcomp Require Import all_ssreflect all_algebra.
Require Import chain.

Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Import Order.TTheory GRing.Theory Num.Theory.
Local Open Scope ring_scope.

Section Scaling.

Variables (R : fieldType) (n : nat) (L k : nat -> R) (c : R).
Hypothesis c0 : c != 0.
Implicit Types (q : 'cV[R]_n) (F Fy : R).

Lemma Kq_scaled : Kq n (fun i => c * k i) = c *: Kq n k.
Proof. by apply/matrixP=> i j; rewrite !mxE mulrnAr. Qed.
Lemma distance_scaled i : distance n (fun j => c * L j) i = c * distance n L i.
Proof. by rewrite /distance mulr_sumr. Qed.
Lemma S0_scaled : S0 n (fun j => c * L j) = c *: S0 n L.
Proof. by apply/matrixP=> i j; rewrite !mxE distance_scaled. Qed.
Lemma S1_scaled : S1 n (fun j => c * L j) = c *: S1 n L.
Proof. by apply/matrixP=> i j; rewrite !mxE distance_scaled mulrN. Qed.

Theorem stiffness_scaled F q Fy : mode L (fun i => c * k i) (c * F) q (c * Fy) <-> mode L k F q Fy.
Proof.
have e : Kq n (fun i => c * k i) *m q + (c * F) *: (S1 n L *m q) + (c * Fy) *: S0 n L =
    c *: (Kq n k *m q + F *: (S1 n L *m q) + Fy *: S0 n L).
  by rewrite Kq_scaled -scalemxAl !scalerDr !scalerA.
split=> -[q0 e1 e2]; split=> //; last by rewrite e e1 scaler0.
by apply: (scalerI c0); rewrite -e e1 scaler0.
Qed.

Theorem length_scaled F q Fy : mode (fun j => c * L j) k (F / c) q (Fy / c) <-> mode L k F q Fy.
Proof.
have e : (F / c) *: (S1 n (fun j => c * L j) *m q) + (Fy / c) *: S0 n (fun j => c * L j) =
    F *: (S1 n L *m q) + Fy *: S0 n L.
  by rewrite S1_scaled S0_scaled -scalemxAl !scalerA !divfK.
have axis : (S0 n (fun j => c * L j))^T *m q = c *: ((S0 n L)^T *m q) by rewrite S0_scaled linearZ /= -scalemxAl.
split=> -[q0 e1 e2]; split=> //; rewrite ?axis ?e2 ?scaler0 //.
- by rewrite -addrA -e addrA.
- by apply: (scalerI c0); rewrite -axis e2 scaler0.
by rewrite -addrA e addrA.
Qed.

End Scaling.
