let char_at text i = if i >= 0 && i < String.length text then text.[i] else '\n'

let rec line_start text i =
  if i <= 0 || char_at text (i - 1) = '\n' then max 0 i else line_start text (i - 1)

let rec line_stop text i = if char_at text i = '\n' then i else line_stop text (i + 1)
let rec blanks text i = if char_at text i = ' ' then blanks text (i + 1) else i

(* {1 The array of a loop} *)

(* Splits a text into names and symbols; a number counts as a name. *)
let tokens text =
  let rec from i taken =
    if i >= String.length text then List.rev taken
    else if text.[i] = ' ' || text.[i] = '\n' then from (i + 1) taken
    else if not (Basis.Character.is_name text.[i]) then
      from (i + 1) (String.make 1 text.[i] :: taken)
    else
      let rec stop j = if Basis.Character.is_name (char_at text j) then stop (j + 1) else j in
      from (stop i) (String.sub text i (stop i - i) :: taken)
  in
  from 0 []

let is_name word = Basis.Character.is_lower word.[0]

let is_type word =
  List.mem word
    [ "int"; "auto"; "const"; "let"; "var"; "size_t"; "unsigned"; "long"; "double"; "float" ]

(* The end of the block that begins on the line at this offset: the lines below it that are indented
   further. *)
let block_stop text first =
  let indentation i = blanks text (line_start text i) - line_start text i in
  let own = indentation first in
  let rec go stop =
    let next = stop + 1 in
    if next >= String.length text then String.length text
    else if char_at text (blanks text next) = '\n' || indentation next > own then
      go (line_stop text next)
    else stop
  in
  go (line_stop text first)

(* The array that is indexed by this variable. *)
let rec indexed by = function
  | xs :: "[" :: i :: "]" :: _ when is_name xs && i = by -> Some xs
  | xs :: "!" :: i :: _ when is_name xs && i = by -> Some xs
  | xs :: "(" :: i :: ")" :: _ when is_name xs && i = by -> Some xs
  | _ :: rest -> indexed by rest
  | [] -> None

let rec array_of = function
  | ("(" | "&") :: rest -> array_of rest
  | word :: rest when is_type word || not (is_name word) -> array_of rest
  | _ :: ("in" | "of" | ":") :: xs :: ([] | [ _ ]) when is_name xs -> Some xs
  | _ :: ("in" | "of" | ":") :: xs :: next :: _ when is_name xs && next <> "(" && next <> "." ->
      Some xs
  | x :: rest -> indexed x rest
  | [] -> None

(* The variable and the array of a loop header such as `for s in sonars i:`. The array may be the
   result of a function. *)
let rec header = function
  | ("for" | "foreach") :: x :: "in" :: xs :: rest when is_name x && is_name xs -> (
      let rec arguments taken = function
        | word :: rest when Basis.Character.is_name word.[0] -> arguments (word :: taken) rest
        | rest -> (List.rev taken, rest)
      in
      match arguments [] rest with
      | _, ("(" | "." | "[") :: _ -> None
      | [], _ -> Some (x, xs)
      | words, _ -> Some (x, "(" ^ String.concat " " (xs :: words) ^ ")"))
  | _ :: rest -> header rest
  | [] -> None

let first_line text first = tokens (String.sub text first (line_stop text first - first))

(* The array of the `for` at this offset or later on its line. *)
let array text first =
  let rec after = function
    | ("for" | "foreach") :: rest -> array_of rest
    | _ :: rest -> after rest
    | [] -> None
  in
  match header (first_line text first) with
  | Some (_, xs) -> Some xs
  | None -> after (tokens (String.sub text first (block_stop text first - first)))

(* {1 A loop that counts} *)

(* The condition of the only line below the header, in `if c then n = n + 1`, or of the first of two
   lines, and the name of the counter. *)
let counted text first =
  let start = line_stop text first in
  let body = String.sub text start (block_stop text first - start) in
  let increments code =
    match tokens code with
    | [ n; "+"; "="; "1" ] | [ n; "+"; "+" ] -> Some n
    | [ n; "="; m; "+"; "1" ] when String.equal n m -> Some n
    | _ -> None
  in
  let lines = String.split_on_char '\n' body |> List.map String.trim in
  let rest_from prefix line =
    let n = String.length prefix in
    String.trim (String.sub line n (String.length line - n))
  in
  let rec find sign text i =
    if i + String.length sign > String.length text then None
    else if String.equal (String.sub text i (String.length sign)) sign then Some i
    else find sign text (i + 1)
  in
  let split sign line =
    Option.map
      (fun i ->
        let after = i + String.length sign in
        (String.trim (String.sub line 0 i), String.sub line after (String.length line - after)))
      (find sign line 0)
  in
  let named n code = Option.map (fun counter -> (n, counter)) (increments code) in
  match List.filter (( <> ) "") lines with
  | line :: others when String.starts_with ~prefix:"if " line -> (
      let test = rest_from "if" line in
      match (split " then " test, split ":" test, others) with
      | Some (condition, code), _, [] -> named condition code
      | None, Some (condition, ""), [ code ] -> named condition code
      | None, Some (condition, code), [] -> named condition code
      | _ -> None)
  | _ -> None

let over_array text first =
  let xs = Option.value (array text first) ~default:"xs" in
  match (header (first_line text first), counted text first) with
  | Some (x, xs), Some (condition, counter) ->
      (* the counter itself is defined by the equation *)
      let n = if String.equal counter "count" then "n" else "count" in
      Printf.sprintf
        "Frob has no `for` loops: to count the elements for which a condition holds, write `foldl \
         (\\%s %s -> if %s then %s + 1 else %s) 0 %s`"
        n x condition n n xs
  | _ ->
      Printf.sprintf
        "Frob has no loops: write `map f %s` or `foldl (+) 0 %s` for an array, or `forEachT %s f` \
         to run a task for each element"
        xs xs xs

(* {1 Loops as values} *)

type t = { word : string; first : int; hint : string }

let hint text word first =
  if word = "while" then
    "an equation has one value at every instant: for a value that changes over time, write, for \
     example, `n = delay 0 (n + 1)`; to repeat a task, write `whileT condition t`"
  else
    let xs = Option.value (array text first) ~default:"xs" in
    Printf.sprintf
      "write `foldl (+) 0 %s` for the sum of an array, or `map f %s` to compute a value for each \
       element"
      xs xs

(* Is this a loop header rather than a call to a function with this name? *)
let is_head text word first =
  let head = tokens (String.sub text first (line_stop text first - first)) in
  word = "while" || List.exists (fun sign -> List.mem sign head) [ "in"; "of"; "="; ";"; ":" ]

let is_sign c = String.contains "=<>!+-*/|&:" c

(* The loop after the first `=` of the line that starts here, even if the loop starts on the next
   line. *)
let on_line text start =
  let stop = line_stop text start in
  let rec equal i =
    if i >= stop then None
    else if text.[i] = '=' && not (is_sign (char_at text (i - 1)) || is_sign (char_at text (i + 1)))
    then Some i
    else equal (i + 1)
  in
  Option.bind (equal start) (fun equal ->
      let first = blanks text (equal + 1) in
      let first = if first = stop then blanks text (stop + 1) else first in
      let first = min first (String.length text) in
      let rec last i = if Basis.Character.is_name (char_at text i) then last (i + 1) else i in
      let word = String.sub text first (last first - first) in
      if List.mem word [ "for"; "while" ] && is_head text word first then
        Some { word; first; hint = hint text word first }
      else None)

let as_value text at =
  let on_line start =
    match on_line text start with Some loop when loop.first <= at -> Some loop | _ -> None
  in
  let rec around start indentation =
    if start = 0 || indentation = 0 then None
    else
      let start = line_start text (start - 1) in
      let first = blanks text start in
      if char_at text first = '\n' || first - start >= indentation then around start indentation
      else match on_line start with Some loop -> Some loop | None -> around start (first - start)
  in
  let start = line_start text at in
  match on_line start with
  | Some loop -> Some loop
  | None ->
      let first = blanks text start in
      around start (if char_at text first = '}' then first - start + 1 else first - start)
