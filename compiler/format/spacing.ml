open Syntax.Grammar

(* Whether there is a space inside a bracket. In lists whose lines start with commas, this aligns
   the elements: [( a], [, b]. *)
let within (w : Word.t) =
  match w.token.token with LBRACE | RBRACE -> 1 | _ -> if w.commas_first then 1 else 0

let is_sign = function SLASH | STAR | CARET | MINUS -> true | _ -> false

(* Units are written without spaces around operators: [m/s^2], [1/(m s)]. *)
let in_unit (a : Word.t) (b : Word.t) =
  match (a.token.token, b.token.token) with
  | (EQUAL | COMMA), _ | _, EQUAL -> 1
  | a, b -> if is_sign a || is_sign b then 0 else 1

let between (a : Word.t) (b : Word.t) =
  match (a.token.token, b.token.token) with
  | COMMA, RPAREN | _, (COMMA | SEMICOLON | UNIT_BRACKET | FIELD _ | AT) -> 0
  | (LPAREN | LBRACKET | UNIT_BRACKET | LBRACE), _ -> within a
  | _, (RPAREN | RBRACKET | RBRACE) -> within b
  | (AT | BACKSLASH), _ -> 0
  | BACKTICK, _ when not a.in_quotes -> 0
  | _, BACKTICK when b.in_quotes -> 0
  (* without a space, they would start a comment *)
  | MINUS, MINUS -> 1
  | MINUS, _ when a.prefix -> 0
  | _ when a.in_unit && b.in_unit -> in_unit a b
  | _ -> 1

let set (words : Word.t array) =
  for i = 1 to Array.length words - 1 do
    words.(i).gap <- between words.(i - 1) words.(i)
  done
