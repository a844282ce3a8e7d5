(* Checks certificates of critical forces (proofs/certificates/certificate-format.md) in integers. This file is extracted to OCaml;
   what it accepts is true of the real chain by sound.v. Plain integers and lists: no other library is in it. *)
From Coq Require Import ZArith List Bool.
Import ListNotations.
Open Scope Z_scope.

(* What is read from a file: fractions with their denominators, and, where a number of significant digits is claimed,
   an exponent that is a hint: it is checked, not trusted. *)
Record rational := Rational { num : Z; den : Z }.
Record shape := Shape { first : Z; last : Z; shape_digits : Z; angles : list (rational * Z) }.
Record force := Force {
  number : Z; low : rational; high : rational; exponent : Z; digits : Z; below_low : Z; below_high : Z;
  force_shape : option shape }.
Record tie := Tie { tie_number : Z; tie_low : rational; tie_high : rational; factor : list rational;
  cofactors : list (list rational) }.
Record matrices := Matrices { rank_A : Z; rank_B : Z; zero_algebraic : Z; zero_geometric : Z;
  characteristic : list rational }.
Record certificate := Certificate { lengths : list rational; stiffness : list rational; forces : list force;
  ties : list tie; chain_matrices : option matrices }.

(* Fractions *)

Definition proper (x : rational) : bool := 0 <? den x.
Definition less (x y : rational) : bool := num x * den y <? num y * den x.

(* All fractions over one denominator. The quotients are checked by multiplication. *)
Definition common (xs : list rational) : Z := fold_right (fun x d => Z.lcm (den x) d) 1 xs.
Definition cleared (d : Z) (xs : list rational) : list Z := map (fun x => num x * (d / den x)) xs.
Fixpoint clears (d : Z) (xs : list rational) (ys : list Z) : bool :=
  match xs, ys with
  | [], [] => true
  | x :: xs', y :: ys' => (0 <? den x) && (y * den x =? num x * d) && clears d xs' ys'
  | _, _ => false
  end.

(* 10^e as a fraction *)
Definition power_of_ten (e : Z) : rational := if 0 <=? e then Rational (10 ^ e) 1 else Rational 1 (10 ^ (- e)).
Definition in_decade (x : rational) (e : Z) : bool :=
  let a := Rational (Z.abs (num x)) (den x) in negb (less a (power_of_ten (e - 1))) && less a (power_of_ten e).
Definition sane_digits (d : Z) : bool := (1 <=? d) && (d <=? 100000).

(* The chain in integers: a joint has the length of its link, its distance to the end point, its stiffness. *)
Record joint := Joint { len : Z; dist : Z; stiff : Z }.

Fixpoint joints (ls ks : list Z) : list joint :=
  match ls, ks with
  | l :: ls', k :: ks' =>
    let js := joints ls' ks' in Joint l (l + match js with [] => 0 | j :: _ => dist j end) k :: js
  | _, _ => []
  end.

Definition lawful (js : list joint) : bool :=
  forallb (fun j => (0 <? len j) && (0 <=? stiff j)) js
  && (Nat.leb 2 (length js)) && (Nat.leb (length (filter (fun j => stiff j =? 0) js)) 1).

(* The first interior passive joint behind the base; the last joint where there is none. *)
Fixpoint cut_in (rest : list joint) : nat :=
  match rest with
  | [] => 0
  | [_] => 1
  | j :: rest' => if stiff j =? 0 then 1 else S (cut_in rest')
  end.
Definition cut (js : list joint) : nat := cut_in (tl js).
Definition first_part (js : list joint) : list joint := firstn (S (cut js)) js.
Definition second_part (js : list joint) : list joint := skipn (cut js) js.

(* The recursion for the force P / D: sign changes, where a zero takes the sign before it. *)
Fixpoint sweep (P D : Z) (j : joint) (rest : list joint) (h m : Z) (count : nat) (negative : bool) : nat :=
  match rest with
  | [] => count
  | j' :: rest' =>
    let t := D * dist j' * m - P * len j * h in
    let h' := D * dist j * stiff j' * h + dist j' * t in
    let now := if h' =? 0 then negative else h' <? 0 in
    sweep P D j' rest' h' (stiff j' * t) (if Bool.eqb now negative then count else S count) now
  end.
Definition changes (P D : Z) (js : list joint) : nat :=
  match js with [] => 0%nat | j :: rest => sweep P D j rest (dist j) (stiff j) 0 false end.
Definition both_changes (P D : Z) (js : list joint) : nat :=
  (changes P D (first_part js) + changes P D (second_part js))%nat.

Section Chain.

(* Lengths times dL, stiffnesses times dk: a force times dk / dL. *)
Variables (dL dk : Z) (js : list joint).

Definition count_at (x : rational) : Z := Z.of_nat (both_changes (num x * dk) (den x * dL) js).
Definition count_part (part : list joint) (x : rational) : Z := Z.of_nat (changes (num x * dk) (den x * dL) part).

Definition bounds (f : force) : bool :=
  proper (low f) && proper (high f) && less (Rational 0 1) (low f) && less (low f) (high f)
  && (count_at (low f) =? below_low f) && (count_at (high f) =? below_high f)
  && (below_low f <? number f) && (number f <=? below_high f).

(* 2 (high - low) is less than one unit in the last of the digits of low *)
Definition precise (f : force) : bool :=
  sane_digits (digits f) && in_decade (low f) (exponent f) && (Z.abs (exponent f) <=? 100000)
  && less (Rational (2 * (num (high f) * den (low f) - num (low f) * den (high f))) (den (low f) * den (high f)))
          (power_of_ten (exponent f - digits f)).

(* Polynomials in the force, coefficients from the constant up. *)
Fixpoint plus (p q : list Z) : list Z :=
  match p, q with [], _ => q | _, [] => p | a :: p', b :: q' => a + b :: plus p' q' end.
Definition scale (c : Z) (p : list Z) : list Z := map (Z.mul c) p.
Fixpoint times (p q : list Z) : list Z := match p with [] => [] | a :: p' => plus (scale a q) (0 :: times p' q) end.
Fixpoint sweep_polynomial (j : joint) (rest : list joint) (h m : list Z) : list Z :=
  match rest with
  | [] => h
  | j' :: rest' =>
    let t := plus (scale (dist j') m) (0 :: scale (- len j) h) in
    sweep_polynomial j' rest' (plus (scale (dist j * stiff j') h) (scale (dist j') t)) (scale (stiff j') t)
  end.
Definition polynomial (part : list joint) : list Z :=
  match part with [] => [] | j :: rest => sweep_polynomial j rest [dist j] [stiff j] end.

(* p_i a^i b = q_i c^i d for all i *)
Fixpoint proportional (p q : list Z) (a b c d : Z) : bool :=
  match p, q with
  | [], _ => forallb (Z.eqb 0) q
  | _, [] => forallb (Z.eqb 0) p
  | x :: p', y :: q' => (x * b =? y * d) && proportional p' q' a (a * b) c (c * d)
  end.

(* Sign of a polynomial at a fraction with positive denominator: sum of p_i P^i D^(length - i). *)
Fixpoint homogeneous (p : list Z) (P D : Z) : Z * Z :=
  match p with
  | [] => (0, 1)
  | a :: p' => let (v, d) := homogeneous p' P D in (a * d * D + P * v, d * D)
  end.
Definition sign_at (p : list Z) (x : rational) : Z := Z.sgn (fst (homogeneous p (num x) (den x))).

Definition divides_part (factor cofactor : list rational) (part : list joint) : bool :=
  let df := common factor in let f := cleared df factor in
  let dc := common cofactor in let c := cleared dc cofactor in
  let h := polynomial part in
  clears df factor f && clears dc cofactor c && (0 <? df) && (0 <? dc)
  && negb (hd 0 h =? 0) && proportional (times f c) h dL (hd 0 h) dk (df * dc).

Definition tied (t : tie) : bool :=
  let f := cleared (common (factor t)) (factor t) in
  proper (tie_low t) && proper (tie_high t) && less (Rational 0 1) (tie_low t) && less (tie_low t) (tie_high t)
  && (count_at (tie_low t) =? tie_number t - 1) && (count_at (tie_high t) =? tie_number t + 1)
  && (sign_at f (tie_low t) * sign_at f (tie_high t) =? -1)
  && Nat.ltb 1 (length (second_part js))
  && match cofactors t with
     | [c1; c2] => divides_part (factor t) c1 (first_part js) && divides_part (factor t) c2 (second_part js)
     | _ => false
     end.

(* Shapes: the recursion for all forces from P1 / D to P2 / D, in intervals of integers. *)
Record span := Span { lower : Z; upper : Z; over : Z }.
Definition negated (x : span) : span := Span (- upper x) (- lower x) (over x).

Fixpoint sweep_shape (P1 P2 D : Z) (j : joint) (rest : list joint) (hl hu ml mu sigma : Z) : list span :=
  match rest with
  | [] => []
  | j' :: rest' =>
    let tl := D * dist j' * ml - len j * (if 0 <=? hu then P2 * hu else P1 * hu) in
    let tu := D * dist j' * mu - len j * (if 0 <=? hl then P1 * hl else P2 * hl) in
    let a := D * dist j * stiff j' in
    let q := if stiff j' =? 0 then Span (- hu) (- hl) (dist j' * sigma) else Span tl tu (a * sigma) in
    q :: sweep_shape P1 P2 D j' rest' (a * hl + dist j' * tl) (a * hu + dist j' * tu) (stiff j' * tl) (stiff j' * tu)
                     (a * sigma)
  end.
Definition part_shape (part : list joint) (x y : rational) : list span :=
  match part with
  | [] => []
  | j :: rest => Span 1 1 1 :: sweep_shape (num x * den y * dk) (num y * den x * dk) (den x * den y * dL) j rest
                                         (dist j) (dist j) (stiff j) (stiff j) 1
  end.

(* lo <= q_i / q_one <= hi for a positive q_one; lo and hi over one denominator d *)
Definition within (q one : span) (lo hi d : Z) : bool :=
  (lo * lower one * over q <=? lower q * d * over one) && (lo * upper one * over q <=? lower q * d * over one)
  && (upper q * d * over one <=? hi * lower one * over q) && (upper q * d * over one <=? hi * upper one * over q).

(* One unit in the last digit: of an angle of zero, in that place behind the point. *)
Definition angle_within (one q : span) (d : Z) (angle : rational * Z) : bool :=
  let (v, e) := angle in
  let u := power_of_ten (e - d) in
  proper v && (if num v =? 0 then e =? 0 else in_decade v e) && (Z.abs e <=? 100000)
  && (Z.abs (num v) <=? den v)
  && within q one (num v * den u - num u * den v) (num v * den u + num u * den v) (den v * den u).

Fixpoint all_within (one : span) (qs : list span) (d : Z) (vs : list (rational * Z)) : bool :=
  match qs, vs with
  | [], [] => true
  | q :: qs', v :: vs' => angle_within one q d v && all_within one qs' d vs'
  | _, _ => false
  end.

Fixpoint place_of_one (qs : list span) (vs : list (rational * Z)) : option span :=
  match qs, vs with
  | q :: qs', v :: vs' => if (num (fst v) =? den (fst v)) then Some q else place_of_one qs' vs'
  | _, _ => None
  end.

(* Either this is the only force within the bounds, or a tie says that both are equal. *)
Definition single_or_tied (f : force) (ts : list tie) : bool :=
  (below_high f =? below_low f + 1)
  || ((below_high f =? below_low f + 2) && existsb (fun t => tie_number t =? below_low f + 1) ts).

Definition shaped (f : force) (ts : list tie) (s : shape) : bool :=
  let c := Z.of_nat (cut js) in let n := Z.of_nat (length js) in
  let zeros m := repeat (Span 0 0 1) m in
  let check part qs :=
    (count_part part (high f) =? count_part part (low f) + 1)
    && match place_of_one qs (angles s) with
       | None => false
       | Some one =>
         let flip := if 0 <? lower one then fun x => x else negated in
         (0 <? lower (flip one)) && all_within (flip one) (map flip qs) (shape_digits s) (angles s)
       end in
  sane_digits (shape_digits s) && (2 <=? shape_digits s) && single_or_tied f ts
  && (if (first s =? 1) && (last s =? c + 1) then
        check (first_part js) (part_shape (first_part js) (low f) (high f) ++ zeros (length js - S (cut js))%nat)
      else if (first s =? c + 1) && (last s =? n) then
        check (second_part js) (zeros (cut js) ++ part_shape (second_part js) (low f) (high f))
      else false).

(* det(lambda B - A) = lambda^(n+1) D(-1/lambda), and D is the polynomial of the whole chain up to the factor that the
   recursion in integers has gathered. *)
Fixpoint alternated (s : Z) (p : list Z) : list Z := match p with [] => [] | a :: p' => s * a :: alternated (- s) p' end.

Definition gathered : Z :=
  fold_right Z.mul (dL * dL) (map (fun j => dist j * dk) (removelast (tl js))) * dk.

Definition matrices_hold (m : matrices) : bool :=
  let n := Z.of_nat (length js) in
  let d := common (characteristic m) in let c := cleared d (characteristic m) in
  (rank_A m =? n) && (rank_B m =? n + 1) && (zero_algebraic m =? 2) && (zero_geometric m =? 1)
  && Nat.eqb (length (characteristic m)) (length js + 2)
  && clears d (characteristic m) c && (0 <? d)
  && proportional (rev c) (alternated (-1) (polynomial js)) dL gathered dk d.

End Chain.

(* Entry (i, j) of A and of B of (33), and the coefficient of F^i in D(F) = det(A F + B), as fractions: not part of the
   checker, but of the comparison with other programs. *)
Section Matrices.

Variables (dL dk : Z) (js : list joint).

Definition joint_at (i : nat) : joint := nth i js (Joint 0 0 0).
Definition inside (i : nat) : bool := Nat.ltb i (length js).

Definition entry_A (i j : nat) : rational :=
  if inside i && inside j then Rational (- dist (joint_at (Nat.max i j))) dL else Rational 0 1.
Definition entry_B (i j : nat) : rational :=
  if inside i then
    if inside j then (if Nat.eqb i j then Rational (stiff (joint_at i)) dk else Rational 0 1)
    else Rational (dist (joint_at i)) dL
  else if inside j then Rational (dist (joint_at j)) dL else Rational 0 1.
Definition coefficient (i : nat) : rational :=
  match js with
  | [j] => if Nat.eqb i 0 then Rational (- (dist j * dist j)) (dL * dL) else Rational 0 1
  | _ => Rational (- nth i (polynomial js) 0 * dk ^ Z.of_nat i) (gathered dL dk js * dL ^ Z.of_nat i)
  end.

End Matrices.

Fixpoint ascending (before : Z) (fs : list force) : bool :=
  match fs with [] => true | f :: fs' => (before <? number f) && ascending (number f) fs' end.

Definition option_forall {X} (p : X -> bool) (x : option X) : bool := match x with None => true | Some y => p y end.

Definition holds (c : certificate) : bool :=
  let dL := common (lengths c) in let ls := cleared dL (lengths c) in
  let dk := common (stiffness c) in let ks := cleared dk (stiffness c) in
  let js := joints ls ks in
  clears dL (lengths c) ls && clears dk (stiffness c) ks && (0 <? dL) && (0 <? dk)
  && Nat.eqb (length (lengths c)) (length (stiffness c))
  && lawful js && ascending 0 (forces c)
  && forallb (fun f => bounds dL dk js f && precise f) (forces c)
  && forallb (tied dL dk js) (ties c)
  && forallb (fun f => option_forall (shaped dL dk js f (ties c)) (force_shape f)) (forces c)
  && option_forall (matrices_hold dL dk js) (chain_matrices c).
