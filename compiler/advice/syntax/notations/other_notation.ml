open Basis

(* {1 Tokens} *)

type token = Word of string | Number of string | Symbol of string | Open of char | Close of char
type located = { token : token; adjacent : bool  (** no space before the token *) }

exception Unknown

let symbols =
  [ "==="; "&&"; "||"; "=="; "!="; "~="; "/="; "<>"; "<="; ">="; "**" ]
  @ [ "+"; "-"; "*"; "/"; "^"; "<"; ">"; "!"; "?"; ":"; "," ]

let tokens text =
  let length = String.length text in
  let char i = if i < length then text.[i] else '\000' in
  let rec while_ accepts i = if i < length && accepts text.[i] then while_ accepts (i + 1) else i in
  let is_digit = Character.is_digit in
  let rec word i =
    let i = while_ Character.is_name i in
    let is_name c = Character.is_lower c || Character.is_upper c in
    if char i = '.' && is_name (char (i + 1)) then word (i + 1)
    else if char i = ':' && char (i + 1) = ':' && is_name (char (i + 2)) then word (i + 2)
    else i
  in
  let number i =
    let j = while_ is_digit i in
    let j = if char j = '.' && is_digit (char (j + 1)) then while_ is_digit (j + 1) else j in
    let digits = String.sub text i (j - i) in
    let j = match char j with 'f' | 'F' -> j + 1 | _ -> j in
    if Character.is_name (char j) || char j = '.' then raise Unknown;
    if char j <> '[' then (digits, j)
    else
      match String.index_from_opt text j ']' with
      | Some stop -> (digits ^ String.sub text j (stop + 1 - j), stop + 1)
      | None -> raise Unknown
  in
  let starts i symbol =
    let n = String.length symbol in
    i + n <= length && String.equal (String.sub text i n) symbol
  in
  let rec from i adjacent found =
    if i >= length then List.rev found
    else
      let add token j = from j true ({ token; adjacent } :: found) in
      match text.[i] with
      | ' ' | '\n' -> from (i + 1) false found
      | c when is_digit c ->
          let digits, stop = number i in
          add (Number digits) stop
      | c when Character.is_lower c || Character.is_upper c ->
          let stop = word i in
          add (Word (String.sub text i (stop - i))) stop
      | ('(' | '[') as c -> add (Open c) (i + 1)
      | (')' | ']') as c -> add (Close c) (i + 1)
      | _ -> (
          match List.find_opt (starts i) symbols with
          | Some symbol -> add (Symbol symbol) (i + String.length symbol)
          | None -> raise Unknown)
  in
  from 0 false []

(* {1 Expressions} *)

(* A part of an expression, already translated into Frob. *)
type part = Operand of string | Operator of string

let operator = function
  | "and" -> Some "&&"
  | "or" -> Some "||"
  | "if" | "then" | "else" -> None
  | _ -> None

let symbol = function "!=" | "~=" | "<>" -> "/=" | "===" -> "==" | other -> other

let function_ = function
  | ("fabs" | "fabsf" | "fmin" | "fminf" | "fmax" | "fmaxf" | "sqrtf" | "sinf" | "cosf") as name ->
      Option.value (Other_function.alone name) ~default:name
  | "len" -> "length"
  | name -> name

let constant = function
  | "true" | "TRUE" -> "True"
  | "false" | "FALSE" -> "False"
  | "PI" | "M_PI" -> "pi"
  | "None" | "null" | "NULL" | "nullptr" | "nil" -> "Nothing"
  | name -> name

let is_comparison op = List.mem op [ "=="; "/="; "<"; ">"; "<="; ">=" ]

(* Raises [Unknown] for chained comparisons, which Frob does not allow. *)
let check_comparisons parts =
  let count found = function
    | Operator ("&&" | "||" | "if" | "then" | "else") -> 0
    | Operator op when is_comparison op -> if found > 0 then raise Unknown else 1
    | Operator _ | Operand _ -> found
  in
  ignore (List.fold_left count 0 parts)

let rec written = function
  | [] -> raise Unknown
  | Operator "-" :: Operand text :: rest -> written (Operand ("-" ^ Source.grouped text) :: rest)
  | Operator ("if" as word) :: rest -> word ^ " " ^ written rest
  | Operator _ :: _ -> raise Unknown
  | Operand text :: rest -> text ^ following rest

and following = function
  | [] -> ""
  | Operator op :: Operator "-" :: Operand text :: rest
    when not (List.mem op [ "then"; "else"; "if"; "&&"; "||" ] || is_comparison op) ->
      Printf.sprintf " %s (-%s)%s" op (Source.grouped text) (following rest)
  | Operator op :: rest -> Printf.sprintf " %s %s" op (written rest)
  | Operand text :: rest -> " " ^ text ^ following rest

(* Splits at the first part that satisfies the predicate. *)
let split_at is parts =
  let rec go before = function
    | part :: rest when is part -> Some (List.rev before, rest)
    | part :: rest -> go (part :: before) rest
    | [] -> None
  in
  go [] parts

let is_op op = function Operator o -> String.equal o op | Operand _ -> false

(* `c ? a : b`, and Python's `a if c else b`. *)
let rec choice parts =
  match split_at (is_op "?") parts with
  | Some (condition, rest) -> (
      match split_at (is_op ":") rest with
      | Some (a, b) ->
          Printf.sprintf "if %s then %s else %s" (choice condition) (choice a) (choice b)
      | None -> raise Unknown)
  | None -> (
      match split_at (is_op "if") parts with
      | Some ((_ :: _ as a), rest) when not (List.exists (is_op "then") parts) -> (
          match split_at (is_op "else") rest with
          | Some (condition, b) ->
              Printf.sprintf "if %s then %s else %s" (choice condition) (choice a) (choice b)
          | None -> raise Unknown)
      | _ ->
          if List.exists (is_op ":") parts then raise Unknown;
          check_comparisons parts;
          written parts)

let power base exponent =
  Printf.sprintf "%s %s %s" (Source.grouped base)
    (if String.for_all Character.is_digit exponent then "^" else "**")
    (Source.grouped exponent)

(* `x * 5 / 1023` for Arduino's `map(x, 0, 1023, 0, 5)`. *)
let mapped x low high from to_ =
  let whole text =
    if String.for_all Character.is_digit text then int_of_string_opt text else None
  in
  let minus a b =
    match (whole a, whole b) with
    | _, Some 0 -> a
    | Some a, Some b when a >= b -> string_of_int (a - b)
    | _ -> Printf.sprintf "(%s - %s)" (Source.grouped a) (Source.grouped b)
  in
  let scaled =
    Printf.sprintf "%s * %s / %s"
      (Source.grouped (minus x low))
      (Source.grouped (minus to_ from))
      (Source.grouped (minus high low))
  in
  if whole from = Some 0 then scaled else Printf.sprintf "%s + %s" from scaled

let call name arguments =
  match (name, arguments) with
  | "map", [ x; low; high; from; to_ ] -> mapped x low high from to_
  | ("constrain" | "clip" | "saturate"), [ x; low; high ] ->
      String.concat " " ("clamp" :: List.map Source.grouped [ low; high; x ])
  | ("pow" | "powf"), [ base; exponent ] -> power base exponent
  | ("sq" | "square"), [ base ] -> power base "2"
  | _ -> String.concat " " (function_ name :: List.map Source.grouped arguments)

let element array index =
  if String.for_all Character.is_digit index then Printf.sprintf "(%s ! %s)" array index
  else Printf.sprintf "(at %s 0 %s)" (Source.grouped index) array

(* The elements up to the closing bracket, and the tokens after it. *)
let rec elements closing = function
  | { token = Close c; _ } :: rest when c = closing -> ([], rest)
  | tokens -> (
      let first, rest = parts [] tokens in
      let first = choice first in
      match rest with
      | { token = Symbol ","; _ } :: rest ->
          let others, rest = elements closing rest in
          if others = [] then raise Unknown;
          (first :: others, rest)
      | { token = Close c; _ } :: rest when c = closing -> ([ first ], rest)
      | _ -> raise Unknown)

(* The operand with the calls and indices directly after it, as in `f(x)(y)` and `a[i]`. *)
and with_brackets text = function
  | { token = Open '('; adjacent = true } :: rest ->
      let arguments, rest = elements ')' rest in
      with_brackets (call text arguments) rest
  | { token = Open '['; adjacent = true } :: rest -> (
      match elements ']' rest with
      | [ index ], rest -> with_brackets (element text index) rest
      | _ -> raise Unknown)
  | rest -> (text, rest)

(* `math.cos(a)` and `std::max(a, b)` *)
and of_a_module name = function
  | { token = Open '('; adjacent = true } :: rest -> (
      let arguments, rest = elements ')' rest in
      match Other_function.applied name arguments with
      | Some text -> with_brackets text rest
      | None -> raise Unknown)
  | rest -> (
      match (Other_function.constant name, Other_function.alone name) with
      | Some text, _ | None, Some text -> (text, rest)
      | None, None -> raise Unknown)

and bracketed closing rest =
  let inside, rest = elements closing rest in
  let opening = if closing = ')' then "(" else "[" in
  (opening ^ String.concat ", " inside ^ String.make 1 closing, rest)

and negated found rest =
  (* comparisons bind more loosely than `not` in Frob, so the operand of `not` must not be part of a
     comparison *)
  match parts [] rest with
  | Operand text :: Operator op :: _, _ when is_comparison op && text <> "" -> raise Unknown
  | Operand text :: others, rest ->
      (List.rev_append found (Operand ("not " ^ Source.grouped text) :: others), rest)
  | _ -> raise Unknown

(* The parts of an expression up to a comma or a closing bracket. *)
and parts found = function
  | ([] | { token = Symbol "," | Close _; _ } :: _) as rest -> (List.rev found, rest)
  | { token = Symbol "!"; _ } :: rest -> (
      match found with Operand _ :: _ -> raise Unknown | _ -> negated found rest)
  | { token = Word "not"; _ } :: rest -> negated found rest
  | { token = Symbol text; _ } :: rest -> parts (Operator (symbol text) :: found) rest
  | { token = Word (("if" | "then" | "else") as word); _ } :: rest ->
      parts (Operator word :: found) rest
  | { token = Word ("return" | "lambda" | "let" | "in" | "for" | "case" | "of" | "do"); _ } :: _ ->
      raise Unknown
  | { token = Word word; _ } :: rest -> (
      match operator word with
      | Some op -> parts (Operator op :: found) rest
      | None ->
          let text, rest =
            match Other_function.without_module word with
            | Some name -> of_a_module name rest
            | None -> with_brackets (constant word) rest
          in
          parts (Operand text :: found) rest)
  | { token = Number digits; _ } :: rest -> parts (Operand digits :: found) rest
  | { token = Open bracket; _ } :: rest ->
      let text, rest = bracketed (if bracket = '(' then ')' else ']') rest in
      parts (Operand text :: found) rest

(* {1 Texts} *)

let most_characters = 120

let attempt text read =
  if String.length text > most_characters then None
  else match read (tokens text) with result -> Some result | exception Unknown -> None

let expression text =
  attempt text (fun tokens ->
      match parts [] tokens with found, [] -> choice found | _ -> raise Unknown)

let arguments text =
  if String.trim text = "" then Some []
  else
    attempt text (fun tokens ->
        match elements ')' (tokens @ [ { token = Close ')'; adjacent = true } ]) with
        | found, [] -> found
        | _ -> raise Unknown)
