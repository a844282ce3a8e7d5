(* Reads lines of bridge.cpp, keeps lengths, stiffnesses and force, and prints the rest anew: distances, D(F) and the
   count by the functions extracted from checker.v, whose meaning integers.v proves; A and B as chain.v arranges them. *)
module Integer = Z
open Checker

let rational q = { num = Q.num q; den = Q.den q }
let fractions text = List.map Q.of_string (String.split_on_char ' ' text)
let line values = String.concat " " (List.map Q.to_string values)

let answer lengths stiffness force =
  let ls = fractions lengths and ks = fractions stiffness and f = Q.of_string force in
  let dL = common (List.map rational ls) and dk = common (List.map rational ks) in
  let js = joints (cleared dL (List.map rational ls)) (cleared dk (List.map rational ks)) in
  let n = List.length js in
  let over d x = Q.make x d in
  let z = Array.of_list (List.map (fun j -> over dL j.dist) js) in
  let k = Array.of_list (List.map (fun j -> over dk j.stiff) js) in
  let matrix entry = line (List.concat (List.init (n + 1) (fun i -> List.init (n + 1) (entry i)))) in
  let a = matrix (fun i j -> if i < n && j < n then Q.neg z.(max i j) else Q.zero) in
  let b = matrix (fun i j ->
    if i < n && j < n then (if i = j then k.(i) else Q.zero)
    else if i < n then z.(i) else if j < n then z.(j) else Q.zero) in
  (* H of the chain is that of the integers over what the recursion has gathered, at the force times dk / dL *)
  let ratio = Q.make dk dL in
  let rec power x i = if i = 0 then Q.one else Q.mul x (power x (i - 1)) in
  let d = List.mapi (fun i h -> Q.neg (Q.mul (Q.div (Q.of_bigint h) (Q.of_bigint (gathered dL dk js))) (power ratio i)))
            (polynomial js) in
  let count = both_changes (Integer.mul (Q.num f) dk) (Integer.mul (Q.den f) dL) js in
  Printf.sprintf "%s;%s;%s;%s;%s;%s;%d" lengths stiffness force a b (line d) count

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
