open Grammar
open Found

let assigns found =
  match found.before with
  | Some { token = OPERATOR "!"; _ } -> Some "`/=` says that two values differ"
  | Some { token = OPERATOR "+" | MINUS | STAR | SLASH; _ } ->
      Some
        "nothing is assigned: an equation says what holds at every instant, as in `n = delay 0 n + \
         1`"
  | Some _ | None -> None

(* A `//` at the start of a line. *)
let starts_a_comment found =
  found.token.token = SLASH
  && after found = '/'
  && between found found.token.start.pos_bol found.token.start.pos_cnum = ""

let own_operator =
  "programs define no operators; a function stands between in backticks: ``a `f` b``"

(* An operator of another language that starts with a Frob operator. *)
let foreign_operator found (before : Layout.token) =
  if not (is_adjacent found before) then None
  else
    match written found before ^ written found found.token with
    | "<$" | "<*" ->
        Some "`mapE f e` applies a function to an event's value, `map f xs` to each of an array"
    | ".^" | ".*" | "./" ->
        Some
          "operators are of numbers: `map (\\x -> x ^ 2) xs` computes with each of an array, \
           `zipWith (*) xs ys` with those of two"
    | "<>" -> Some "`/=` says that two values differ"
    | text when String.length text > 1 && text.[0] = '|' && is_symbol text.[1] -> Some own_operator
    | ">>" | ">>=" -> Some "tasks follow one another in a `do`, each on a line of its own"
    | "++" when after found = ' ' ->
        Some "nothing is joined: a text is a label, and an array has a fixed size"
    | "++" ->
        Some
          "nothing is counted up: an equation says what holds at every instant, as in `n = delay 0 \
           n + 1`"
    | "!!" ->
        Some "an element of an array is written `xs ! 0`, and `at i default xs` takes any index"
    | "/*" -> Some "a comment is written `{- … -}`, or `--` up to the end of the line"
    | "//" -> Some "a comment starts with `--`; whole numbers are divided by `div`"
    | ".." when names_before found "seeds" -> Some "they are ``1 `to` 20``, both included"
    | ".." ->
        Some
          "there are no ranges: a few elements are written out, `[1, 2, 3]`; many are made by the \
           index, `generate (\\i -> i + 1)`, as many as the type says"
    | _ -> None

let foreign found = Option.bind found.before (foreign_operator found)

let row found =
  match (found.token.token, found.before) with
  | COMMA, Some { token = NUMBER _; _ } when names_before found "!" ->
      Some "an element of a row is reached by one `!` after the other: `m ! 0 ! 1`"
  | _ -> None

let member found =
  match (found.token.token, found.before) with
  | ARROW, Some ({ token = LOWER _; _ } as name)
    when is_adjacent found name && not (is_blank (after found)) ->
      Some
        "nothing is reached by `->`: a field is `r.speed`, and what a robot senses is a signal \
         function, `frontSonar i`"
  | _ -> None

let negation found =
  match (found.token.token, found.before) with
  | OPERATOR "!", Some { token = OPERATOR "!"; _ } -> None
  | OPERATOR "!", _ -> Some "the opposite of `b` is `not b`"
  | _ -> None

let before_point found =
  match found.token.token with
  | OPERATOR "." when Basis.Character.is_digit (after found) ->
      Some "a number starts with a digit: `0` before the point"
  | _ -> None

let after_point found =
  match found.before with
  | Some { token = OPERATOR "."; start; _ }
    when Basis.Character.is_digit (char_at found (start.pos_cnum - 1)) ->
      Some "a number ends with a digit: `0` after the point"
  | _ -> None

let comment found =
  match found.token.token with
  | SLASH when starts_a_comment found -> Some "write `--` to start a comment"
  | _ -> None

let own found =
  match found.token.token with
  | BAR when is_symbol (after found) && after found <> '>' -> Some own_operator
  | _ -> None

let pipe found =
  match found.token.token with
  | BAR when after found = '>' -> Some "a function stands before its argument: `f x`"
  | _ -> None
