(* The straight chain, as core/plumbline/chain.hpp and core/plumbline/linearised.hpp define it.

   Joints and links count from 0 here: L 0 is the paper's L_1. A chain of n links is given by two functions of which
   only the values below n matter; z i = L i + ... + L (n-1), so that z n = 0. *)
From mathcomp Require Import all_ssreflect all_algebra.

Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Import GRing.Theory Num.Theory.
Local Open Scope ring_scope.

Section Chain.

Variables (R : ringType) (n : nat) (L k : nat -> R).

(* Distance from joint i to the end point. *)
Definition distance (i : nat) : R := \sum_(i <= j < n) L j.

(* (28): entry i of S0 is z_i, entry (i, j) of S1 is -z_max(i,j). *)
Definition S0 : 'cV[R]_n := \col_(i < n) distance i.
Definition S1 : 'M[R]_n := \matrix_(i < n, j < n) - distance (maxn i j).
Definition Kq : 'M[R]_n := \matrix_(i < n, j < n) (k i *+ (i == j)).
Definition M : 'M[R]_n := - S1.

(* (33) *)
Definition A : 'M[R]_(n + 1) := block_mx S1 0 0 0.
Definition B : 'M[R]_(n + 1) := block_mx Kq S0 S0^T 0.

(* Orientation of link j. *)
Definition theta (q : 'cV[R]_n) (j : nat) : R := \sum_(i < n | (i <= j)%N) q i 0.

(* The matrix of (33) at a force, and its determinant D(F) as a polynomial in the force. *)
Definition pencil (F : R) : 'M[R]_(n + 1) := F *: A + B.

(* Equations (29) and (30): a buckling mode. *)
Definition mode (F : R) (q : 'cV[R]_n) (Fy : R) : Prop :=
  [/\ q != 0, Kq *m q + F *: (S1 *m q) + Fy *: S0 = 0 & S0^T *m q = 0].

Definition critical (F : R) : Prop := exists q Fy, mode F q Fy.

End Chain.

(* Which chains are meant. A joint of stiffness zero is passive. *)
Section Kinds.

Variables (R : numDomainType) (n : nat) (L k : nat -> R).

Definition chain_of_links : Prop :=
  (forall i, (i < n)%N -> 0 < L i) /\ (forall i, (i < n)%N -> 0 <= k i).

Definition at_most_one_passive : Prop :=
  forall i j, (i < n)%N -> (j < n)%N -> k i = 0 -> k j = 0 -> i = j.

(* No interior passive joint, and at most one at all. *)
Definition no_interior_passive : Prop :=
  forall i, (0 < i)%N -> (i.+1 < n)%N -> k i != 0.

End Kinds.

Section Energy.

Variables (R : fieldType) (n : nat) (L k : nat -> R).

(* q^T K q and q^T M q as sums, see energies_are_forms in definite.v *)
Definition strain (q : 'cV[R]_n) : R := \sum_(i < n) k i * q i 0 ^+ 2.
Definition shortening (q : 'cV[R]_n) : R := \sum_(j < n) L j * theta q j ^+ 2.

End Energy.
