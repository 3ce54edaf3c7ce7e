open Basis
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
    when stands_after found "proc" constructor ->
      Some "put parentheses around a pattern such as `(Just x)`"
  | _ -> None

let list_comprehension found =
  match (found.token.token, found.before) with BAR, _ -> comprehension found | _ -> None
