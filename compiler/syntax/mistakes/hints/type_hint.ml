open Grammar
open Found

(* `Float - > Float`, with a space inside the arrow. *)
let splits_an_arrow found =
  let stop = found.token.stop.pos_cnum in
  is_blank (char_at found stop)
  && char_at found (stop + 1) = '>'
  && is_blank (char_at found (stop + 2))

(* `f :: Float, Float -> Float`, with a comma instead of an arrow. *)
let lists_parameters found =
  let line = between found found.token.start.pos_bol found.token.start.pos_cnum in
  List.mem "::" (String.split_on_char ' ' line)
  && (not (String.contains line '='))
  && not (in_brackets found.context)

(* Is this inside a signature, directly after `Array`? *)
let is_in_a_size found =
  let line = between found found.token.start.pos_bol found.token.start.pos_cnum in
  let words = String.split_on_char ' ' (String.concat " " (String.split_on_char '(' line)) in
  List.mem "::" words
  && (not (List.mem "=" words))
  && match List.filter (( <> ) "") (List.rev words) with _ :: "Array" :: _ -> true | _ -> false

let split_arrow found =
  match (found.token.token, found.before) with
  | MINUS, Some { token = UPPER _ | LOWER _ | RPAREN | RBRACKET; _ } when splits_an_arrow found ->
      Some "remove the space from the arrow: `->`"
  | _ -> None

let parameters found =
  match (found.token.token, found.before) with
  | COMMA, Some _ when lists_parameters found ->
      Some
        "put `->` after each parameter, as in `Float -> Float -> Float`; put a tuple in parentheses"
  | _ -> None

let capital found =
  match (found.token.token, found.before) with
  | DOUBLE_COLON, Some { token = UPPER _; _ } ->
      Some "start the name of a value with a lower-case letter"
  | _ -> None

let pointer found =
  match (found.token.token, found.before) with
  | STAR, Some _ when first_word found = "foreign" ->
      Some "remove the `*`: C receives the address of an array or a record anyway"
  | _ -> None

let size found =
  match (found.token.token, found.before) with
  | (STAR | SLASH | MINUS | OPERATOR ("+" | "-")), Some _ when is_in_a_size found ->
      Some
        "sizes cannot be computed: use a variable for any size, as in `Array m Float`, or a name \
         for a number, as in `type Twice = 16`"
  | _ -> None
