(* Reads certificate files and hands them to the checker that sound.v proves. Exit status 0 when every statement holds.
   usage: check FILE...   Only the shape of the JSON is judged here: members, types, no member twice. *)
module Integer = Z
open Checker

exception Bad of string

let bad fmt = Printf.ksprintf (fun s -> raise (Bad s)) fmt

let members required optional = function
  | `Assoc all ->
    let names = List.map fst all in
    if List.length (List.sort_uniq compare names) <> List.length names then bad "a member twice";
    List.iter (fun r -> if not (List.mem r names) then bad "%s is missing" r) required;
    List.iter (fun x -> if not (List.mem x (required @ optional)) then bad "unknown member %s" x) names;
    fun name -> List.assoc_opt name all
  | _ -> bad "no object"

let get find name = match find name with Some x -> x | None -> bad "%s is missing" name
let small = function
  | `Int i -> Integer.of_int i
  | `Intlit s -> Integer.of_string s
  | _ -> bad "no integer"
let text = function `String s -> s | _ -> bad "no text"
let list f = function `List l -> List.map f l | _ -> bad "no list"

(* An exact decimal or fraction. *)
let decimal = Str.regexp {|^\(-?\)\([0-9]+\)\(\.\([0-9]+\)\)?\(e\([+-]?[0-9][0-9]?[0-9]?[0-9]?\)\)?$|}
let fraction = Str.regexp {|^\(-?[0-9]+\)/\([0-9]+\)$|}
let matches pattern s = Str.string_match pattern s 0 && Str.match_end () = String.length s  (* "$" stops before a line's end *)
let group i s = try Str.matched_group i s with Not_found -> ""
let rational s =
  if matches fraction s then
    let n = group 1 s and d = group 2 s in { num = Integer.of_string n; den = Integer.of_string d }
  else if matches decimal s then begin
    let sign = group 1 s and whole = group 2 s and behind = group 4 s and power = group 6 s in
    let power = if power = "" then 0
      else int_of_string (if power.[0] = '+' then String.sub power 1 (String.length power - 1) else power) in
    let n = Integer.of_string (sign ^ whole ^ behind) and e = power - String.length behind in
    if e >= 0 then { num = Integer.mul n (Integer.pow (Integer.of_int 10) e); den = Integer.one }
    else { num = n; den = Integer.pow (Integer.of_int 10) (-e) }
  end else bad "%S where a decimal or a fraction is expected" s
let number j = rational (text j)

(* The e with 10^(e-1) <= |x| < 10^e: a hint, the checker tries it. *)
let exponent x =
  if Integer.sign x.num = 0 then Integer.zero
  else begin
    let a = Integer.abs x.num in
    let e = String.length (Integer.to_string a) - String.length (Integer.to_string x.den) in
    let ten = Integer.pow (Integer.of_int 10) (abs e) in
    let at_least = if e >= 0 then Integer.geq a (Integer.mul ten x.den) else Integer.geq (Integer.mul a ten) x.den in
    Integer.of_int (if at_least then e + 1 else e)
  end

let shape j =
  let f = members [ "first"; "last"; "digits"; "q" ] [] j in
  { first = small (get f "first"); last = small (get f "last"); shape_digits = small (get f "digits");
    angles = list (fun x -> let v = number x in (v, exponent v)) (get f "q") }

let force j =
  let f = members [ "mode"; "digits"; "low"; "high"; "below_low"; "below_high" ] [ "shape" ] j in
  let low = number (get f "low") in
  { number = small (get f "mode"); low; high = number (get f "high"); exponent = exponent low;
    digits = small (get f "digits"); below_low = small (get f "below_low"); below_high = small (get f "below_high");
    force_shape = Option.map shape (f "shape") }

let tie j =
  let f = members [ "mode"; "low"; "high"; "factor"; "cofactors" ] [] j in
  { tie_number = small (get f "mode"); tie_low = number (get f "low"); tie_high = number (get f "high");
    factor = list number (get f "factor"); cofactors = list (list number) (get f "cofactors") }

let matrices j =
  let f = members [ "rank_A"; "rank_B"; "zero_algebraic"; "zero_geometric"; "characteristic" ] [] j in
  { rank_A = small (get f "rank_A"); rank_B = small (get f "rank_B");
    zero_algebraic = small (get f "zero_algebraic"); zero_geometric = small (get f "zero_geometric");
    characteristic = list number (get f "characteristic") }

let certificate j =
  let f = members [ "chain"; "lengths"; "stiffness"; "forces" ] [ "ties"; "matrices" ] j in
  ( text (get f "chain"),
    { lengths = list number (get f "lengths"); stiffness = list number (get f "stiffness");
      forces = list force (get f "forces"); ties = (match f "ties" with None -> [] | Some t -> list tie t);
      chain_matrices = Option.map matrices (f "matrices") } )

let document j =
  let f = members [ "format"; "version"; "licence"; "provenance"; "certificates"; "sha256" ] [] j in
  if text (get f "format") <> "plumbline-certificates" || not (Integer.equal (small (get f "version")) Integer.one) then
    bad "format or version";
  ignore (text (get f "licence"));
  ignore (text (get f "sha256"));
  let p = members [ "command"; "program"; "seed" ] [] (get f "provenance") in
  List.iter (fun name -> ignore (text (get p name))) [ "command"; "program"; "seed" ];
  list certificate (get f "certificates")

(* Two shapes of equal forces lie in different parts of the chain: one shape does not stand for both. *)
let apart c =
  let tie f =
    let is_of t = Integer.equal f.number t.tie_number || Integer.equal f.number (Integer.succ t.tie_number) in
    List.find_opt is_of (List.rev c.ties) in
  let part f = match tie f, f.force_shape with
    | Some t, Some s -> [ (Integer.to_string t.tie_number, Integer.to_string s.first) ]
    | _ -> [] in
  let parts = List.concat_map part c.forces in
  List.length (List.sort_uniq compare parts) = List.length parts

let accepted c = apart c && holds c

let check name j =
  let chains = document j in
  List.iter (fun (chain, c) -> if not (accepted c) then bad "chain %s: a statement does not hold" chain) chains;
  Printf.printf "%s: %d chains, every statement holds\n%!" name (List.length chains)

(* With --each, every line of a file is a document, and one word a line says what became of it. *)
let each file =
  let channel = open_in file in
  try
    while true do
      let line = input_line channel in
      let verdict =
        match List.for_all (fun (_, c) -> accepted c) (document (Yojson.Safe.from_string line)) with
        | true -> "holds"
        | false -> "refused"
        | exception (Bad _ | Yojson.Json_error _) -> "refused" in
      print_endline verdict
    done
  with End_of_file -> close_in channel

let () =
  match Array.to_list Sys.argv with
  | [ _; "--each"; file ] -> each file
  | _ :: (_ :: _ as files) ->
    List.iter
      (fun name ->
        try check name (Yojson.Safe.from_file name) with
        | Bad what | Yojson.Json_error what | Sys_error what ->
          prerr_endline (name ^ ": " ^ what);
          exit 1)
      files
  | _ -> prerr_endline "usage: check FILE..."; exit 2
