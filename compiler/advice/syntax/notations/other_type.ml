open Basis

exception Unknown

type t = Name of string | Applied of t * t list | Function of t * t | Tuple of t list

(* {1 Names} *)

let without_namespace name =
  match String.rindex_opt name ':' with
  | Some i -> String.sub name (i + 1) (String.length name - i - 1)
  | None -> name

let is_number text = text <> "" && String.for_all Character.is_digit text
let is_a_variable name = String.length name = 1 && Character.is_lower name.[0]

let known name =
  match String.lowercase_ascii name with
  | "double" | "float" | "float32" | "float64" | "real" -> Some "Float"
  | "int" | "long" | "unsigned" | "size_t" | "int32_t" | "uint8_t" | "integer" -> Some "Int"
  | "bool" | "boolean" -> Some "Bool"
  | "string" | "str" -> Some "String"
  | "void" | "unit" -> Some "()"
  | "sf" -> Some "SF"
  | "angularvelocity" -> Some "AngularVelocity"
  | "robotinput" -> Some "RobotInput"
  | "robotoutput" -> Some "RobotOutput"
  | ( "distance" | "velocity" | "angle" | "time" | "acceleration" | "event" | "maybe" | "either"
    | "task" | "pose" | "vec2" | "vec3" | "point2" ) as name ->
      Some (String.capitalize_ascii name)
  | _ -> None

(* A type without arguments. *)
let simple name =
  match without_namespace name with
  | "" -> raise Unknown
  | name when is_number name || is_a_variable name -> name
  | ("Double" | "Integer") as name -> name
  | name -> Option.value (known name) ~default:(String.capitalize_ascii name)

let plain name = if String.contains name ':' then simple name else name

let is_of_elements name =
  List.mem
    (String.lowercase_ascii (without_namespace name))
    [ "array"; "vector"; "vec"; "list"; "deque"; "sequence"; "seq"; "ndarray"; "iterable" ]

let array size element = Applied (Name "Array", [ size; element ])

let is_size = function
  | Name name -> is_number name || is_a_variable name
  | Applied _ | Function _ | Tuple _ -> false

let applied name arguments =
  match (String.lowercase_ascii (without_namespace name), arguments) with
  | ( ( "function" | "callable" | "unique_ptr" | "shared_ptr" | "ptr" | "dict" | "map" | "set"
      | "unordered_map" | "union" | "literal" | "unit" | "prop" ),
      _ ) ->
      raise Unknown
  | _, [ element ] when is_of_elements name -> array (Name "n") element
  | _, [ a; b ] when is_of_elements name && is_size a -> array a b
  | _, [ a; b ] when is_of_elements name && is_size b -> array b a
  | ("tuple" | "pair"), _ :: _ :: _ -> Tuple arguments
  | ("optional" | "option"), [ element ] -> Applied (Name "Maybe", [ element ])
  | _ -> Applied (Name (simple name), arguments)

(* {1 Writing} *)

let rec written = function
  | Name name -> name
  | Applied (head, arguments) -> String.concat " " (List.map argument (head :: arguments))
  | Function ((Function _ as from), result) ->
      Printf.sprintf "(%s) -> %s" (written from) (written result)
  | Function (from, result) -> Printf.sprintf "%s -> %s" (written from) (written result)
  | Tuple parts -> Printf.sprintf "(%s)" (String.concat ", " (List.map written parts))

and argument t =
  match t with Name _ | Tuple _ -> written t | Applied _ | Function _ -> "(" ^ written t ^ ")"

(* {1 Reading} *)

let char_at = Text_place.char_at
let is_part c = Character.is_name c || c = ':'
let rec blanks text i = if char_at text i = ' ' then blanks text (i + 1) else i

let stop_of_brackets text at =
  match String.index_from_opt text at ']' with Some last -> last + 1 | None -> raise Unknown

(* Do the brackets after this name contain types, rather than a unit? *)
let takes_types name =
  is_of_elements name
  || List.mem
       (String.lowercase_ascii (without_namespace name))
       [ "event"; "maybe"; "optional"; "sf"; "task"; "either"; "tuple"; "pair" ]

(* A name, with any arguments in brackets directly after it. *)
let rec name_at text start =
  let rec last i = if is_part (char_at text i) then last (i + 1) else i in
  let stop = last start in
  let word = String.sub text start (stop - start) in
  if word = "" then raise Unknown;
  match char_at text stop with
  | '<' ->
      let all, stop = several text (stop + 1) '>' in
      (applied word all, stop)
  | '[' when takes_types word ->
      let all, stop = several text (stop + 1) ']' in
      (applied word all, stop)
  | '[' ->
      let after = stop_of_brackets text stop in
      let inside = String.trim (String.sub text (stop + 1) (after - stop - 2)) in
      if inside = "" then (array (Name "n") (Name (simple word)), after)
      else if is_number inside && not (String.equal inside "1") then
        (array (Name inside) (Name (simple word)), after)
      else (Name (simple word ^ String.sub text stop (after - stop)), after)
  | _ when Character.is_upper word.[0] || String.contains word ':' -> (Name (plain word), stop)
  | _ -> (Name (Option.value (known word) ~default:word), stop)

(* The types up to the closing bracket, separated by commas. *)
and several text at closing =
  let first, stop = type_at text at in
  let next = blanks text stop in
  match char_at text next with
  | ',' ->
      let others, stop = several text (next + 1) closing in
      (first :: others, stop)
  | c when c = closing -> ([ first ], next + 1)
  | _ -> raise Unknown

and atom_at text at =
  match char_at text at with
  | '(' when char_at text (blanks text (at + 1)) = ')' -> (Name "()", blanks text (at + 1) + 1)
  | '(' -> (
      match several text (at + 1) ')' with
      | [ t ], stop -> (t, stop)
      | all, stop -> (Tuple all, stop))
  | '[' -> (
      let all, stop = several text (at + 1) ']' in
      match all with [ t ] -> (array (Name "n") t, stop) | _ -> raise Unknown)
  | _ -> name_at text at

(* A type with any arguments, separated by spaces, up to an arrow. *)
and part_at text at =
  let head, stop = atom_at text (blanks text at) in
  let rec arguments found stop =
    let next = blanks text stop in
    match char_at text next with
    | ('(' | '[') when next > stop ->
        let t, stop = atom_at text next in
        arguments (t :: found) stop
    | c when next > stop && Character.is_name c ->
        let t, stop = name_at text next in
        arguments (t :: found) stop
    | _ -> (List.rev found, stop)
  in
  match (head, arguments [] stop) with
  | _, ([], stop) -> (head, stop)
  | Name name, (all, stop) when is_of_elements name || not (Character.is_upper name.[0]) ->
      (applied name all, stop)
  | Name _, (all, stop) -> (Applied (head, all), stop)
  | (Applied _ | Function _ | Tuple _), _ -> raise Unknown

and type_at text at =
  let from, stop = part_at text at in
  let next = blanks text stop in
  match (char_at text next, char_at text (next + 1)) with
  | '-', '>' ->
      let result, stop = type_at text (next + 2) in
      (Function (from, result), stop)
  | _ -> (from, stop)

let in_angles text start =
  match name_at text start with
  | t, stop when char_at text (stop - 1) = '>' -> Some (written t, stop)
  | _ -> None
  | exception Unknown -> None

let most_characters = 100

let of_text text =
  let text = String.trim text in
  if String.length text > most_characters then None
  else
    match type_at text 0 with
    | t, stop when stop = String.length text -> Some (written t)
    | _ -> None
    | exception Unknown -> None

(* {1 Signatures} *)

let without_comment line =
  Option.fold (Text_place.find " --" line) ~none:line ~some:(String.sub line 0) |> String.trim

(* The name and the type in the signature on the line that contains this offset. *)
let declared text at =
  let start = Text_place.line_start text at in
  let stop = Text_place.end_of_line text at in
  let line = String.sub text start (stop - start) in
  let indentation line =
    let rec go i = if i < String.length line && line.[i] = ' ' then go (i + 1) else i in
    go 0
  in
  let next =
    if stop >= String.length text then ""
    else String.sub text (stop + 1) (Text_place.end_of_line text (stop + 1) - stop - 1)
  in
  let goes_on = String.trim next <> "" && indentation next > indentation line in
  let line = without_comment line in
  match String.index_opt line ':' with
  | Some colon when (not goes_on) && not (String.contains line '=') ->
      let name = String.trim (String.sub line 0 colon) in
      let after = if char_at line (colon + 1) = ':' then colon + 2 else colon + 1 in
      let type_ = String.trim (String.sub line after (String.length line - after)) in
      if Text_place.is_a_name name && type_ <> "" then Some (name, type_) else None
  | _ -> None

let signature text at =
  Option.bind (declared text at) (fun (name, type_) ->
      Option.map (Printf.sprintf "%s :: %s" name) (of_text type_))

let mentions part text = Text_place.find part text <> None

let of_signature text at =
  Option.map
    (fun written ->
      let any = "Array n " in
      let result = match String.rindex_opt written '>' with Some i -> i | None -> 0 in
      match Text_place.find any written with
      | Some i when i > result ->
          let rest = i + String.length any in
          Printf.sprintf "`%sArray 4 %s`, if 4 is the number of elements" (String.sub written 0 i)
            (String.sub written rest (String.length written - rest))
      | Some _ -> Printf.sprintf "`%s`, or with a number instead of the size `n`" written
      | None -> Printf.sprintf "`%s`" written)
    (signature text at)

let changed text at =
  let is_whole c = not (String.contains " ()" c) in
  let bare text = String.of_seq (Seq.filter is_whole (String.to_seq text)) in
  match (declared text at, signature text at) with
  | Some (name, type_), Some written
    when not (String.equal (bare (name ^ "::" ^ type_)) (bare written)) ->
      of_signature text at
  | _ -> None
