open Basis
open Syntax
open Grammar
open Found

(* [2 * x | x <- xs], a Haskell list comprehension. *)
let comprehension found =
  match found.context with
  | (Bracket, { by; _ }) :: _ -> (
      let end_ = end_of_line found found.token.start.pos_cnum in
      let rest = between found found.token.stop.pos_cnum end_ in
      let element = between found by.stop.pos_cnum found.token.start.pos_cnum in
      match String.split_on_char '<' rest with
      | [ x; source ] when source <> "" && source.[0] = '-' -> (
          let x = String.trim x in
          match String.split_on_char ']' (String.sub source 1 (String.length source - 1)) with
          | xs :: _ :: _ when x <> "" && not (String.contains xs ',') ->
              Some
                (Printf.sprintf "use `map (\\%s -> %s) %s` to compute each element" x element
                   (Source.grouped (String.trim xs)))
          | _ -> Some "use `map (\\x -> x + 1) xs` to compute each element")
      | _ -> None)
  | _ -> None

let do_argument found =
  match (found.token.token, found.before) with
  | ( DO,
      Some
        {
          token = LOWER _ | UPPER _ | NUMBER _ | RPAREN | RBRACKET | QUALIFIED_LOWER _ | FIELD _;
          _;
        } ) ->
      Some "put the `do` in parentheses, or write `$` before it"
  | _ -> None

let lambda_argument found =
  match (found.token.token, found.before) with
  | ( (BACKSLASH | LAMBDA_CASE),
      Some
        {
          token = LOWER _ | UPPER _ | NUMBER _ | RPAREN | RBRACKET | QUALIFIED_LOWER _ | FIELD _;
          _;
        } ) ->
      Some "put the lambda in parentheses: `f (\\x -> …)`"
  | _ -> None

let pattern_of_proc found =
  match (found.token.token, found.before) with
  | (LOWER _ | NUMBER _ | UNDERSCORE | LPAREN), Some ({ token = UPPER _; _ } as constructor)
    when stands_after found "proc" constructor -> (
      match (found.token.token, constructor.token) with
      | LOWER x, UPPER type_
        when Other_type.known type_ <> None || String.ends_with ~suffix:"Input" type_ ->
          Some (Printf.sprintf "write the input without its type: `proc %s -> …`" x)
      | _ -> Some "put the pattern in parentheses, as in `(Just x)`")
  | _ -> None

(* `proc v => do` or `\\x => x + 1` *)
let fat_arrow found =
  let bol = found.token.start.pos_bol and at = found.token.start.pos_cnum in
  let line = between found bol at in
  let rec last = function
    | word :: _ when word = "proc" || String.ends_with ~suffix:"(proc" word -> Some "proc "
    | word :: _ when String.contains word '\\' -> Some "\\"
    | ("->" | "=>") :: _ | [] -> None
    | _ :: rest -> last rest
  in
  match found.token.token with
  | DOUBLE_ARROW -> (
      match last (List.rev (String.split_on_char ' ' line)) with
      | Some "proc " -> Some "write `->` between the input of a `proc` and its output"
      | Some _ -> Some "write `->` between the parameters of a function and its result"
      | None -> None)
  | _ -> None

(* `@(x) x * 2`, as in MATLAB *)
let function_handle found =
  let first = found.token.stop.pos_cnum in
  match found.token.token with
  | AT when after found = '(' -> (
      match String.index_from_opt found.text first ')' with
      | Some closing when closing < end_of_line found first ->
          let names =
            String.split_on_char ',' (String.sub found.text (first + 1) (closing - first - 1))
          in
          let body = Other_definition.body_of_lambda found.text (closing + 1) in
          Some
            (Printf.sprintf "write an anonymous function as `\\%s -> %s`"
               (String.concat " " (List.map String.trim names))
               (Option.value body ~default:"…"))
      | _ -> None)
  | _ -> None

let list_comprehension found =
  match (found.token.token, found.before) with BAR, _ -> comprehension found | _ -> None

(* The parameters before the arrow, as in `x ->` or `(x, y) ->`. They start after the innermost open
   `(`, or after an `=` or `,`. *)
let parameters_before found =
  let stop = found.token.start.pos_cnum in
  let bol = found.token.start.pos_bol in
  let rec start i depth =
    if i <= bol then bol
    else
      match found.text.[i - 1] with
      | ')' -> start (i - 1) (depth + 1)
      | '(' when depth > 0 -> start (i - 1) (depth - 1)
      | ('(' | '=' | ',') when depth = 0 -> i
      | _ -> start (i - 1) depth
  in
  let text = between found (start stop 0) stop in
  let blank = function '(' | ')' | ',' -> ' ' | c -> c in
  let names = List.filter (( <> ) "") (String.split_on_char ' ' (String.map blank text)) in
  let is_name w = String.for_all Character.is_name w && w <> "" && Character.is_lower w.[0] in
  if names <> [] && List.for_all is_name names then Some (String.concat " " names)
  else
    (* `Float x -> x / 2` *)
    match Typed_equation.pairs names with
    | Some (_ :: _ as pairs) -> Some (String.concat " " (List.map snd pairs))
    | Some [] | None -> None

let arrow_function found =
  let general =
    "write an anonymous function as `\\x -> …`, or a signal function as `proc x -> …`"
  in
  match parameters_before found with
  | None -> general
  | Some parameters ->
      let body =
        match Other_definition.body_of_lambda found.text found.token.stop.pos_cnum with
        | Some body when String.length body <= 60 -> body
        | Some _ | None -> "…"
      in
      Printf.sprintf "write an anonymous function as `\\%s -> %s`%s" parameters body
        (if String.contains parameters ' ' then ""
         else Printf.sprintf ", or a signal function as `proc %s -> …`" parameters)
