(* Reads lines of bridge.cpp, keeps lengths, stiffnesses and force, and prints the rest anew by functions extracted from
   checker.v: A, B and D(F), which are those of chain.v by bridge.v, and the count, by integers.changes_stands. *)
module Integer = Z
open Checker

let rational q = { num = Q.num q; den = Q.den q }
let fraction x = Q.make x.num x.den
let fractions text = List.map Q.of_string (String.split_on_char ' ' text)
let line values = String.concat " " (List.map Q.to_string values)

let answer lengths stiffness force =
  let ls = List.map rational (fractions lengths) and ks = List.map rational (fractions stiffness) in
  let f = Q.of_string force and dL = common ls and dk = common ks in
  let js = joints (cleared dL ls) (cleared dk ks) in
  let n = List.length js in
  let matrix entry = line (List.concat (List.init (n + 1) (fun i -> List.init (n + 1) (fun j -> fraction (entry i j))))) in
  let d = List.init n (fun i -> fraction (coefficient dL dk js i)) in
  let count = both_changes (Integer.mul (Q.num f) dk) (Integer.mul (Q.den f) dL) js in
  Printf.sprintf "%s;%s;%s;%s;%s;%s;%d" lengths stiffness force (matrix (entry_A dL js)) (matrix (entry_B dL dk js)) (line d)
    count

let () =
  let lines = ref 0 and wrong = ref 0 in
  (try
    while true do
      let given = input_line stdin in
      match String.split_on_char ';' given with
      | lengths :: stiffness :: force :: _ ->
        incr lines;
        let ours = answer lengths stiffness force in
        if ours <> given then (incr wrong; Printf.printf "core: %s\ncoq:  %s\n" given ours)
      | _ -> incr wrong
    done
  with End_of_file -> ());
  Printf.printf "%d chains and forces, %d differ\n" !lines !wrong;
  exit (if !wrong = 0 && !lines > 250 then 0 else 1)
