(* OCaml of the checker. Integers become those of Zarith, lists and pairs those of OCaml. *)
Require Import checker.
From Coq Require Import ExtrOcamlBasic ExtrOcamlZBigInt ExtrOcamlNatInt.
Extraction Language OCaml.
Extraction "checker.ml" holds entry_A entry_B coefficient.
