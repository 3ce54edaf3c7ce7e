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
      Some "`->` is always one symbol"
  | _ -> None

let parameters found =
  match (found.token.token, found.before) with
  | COMMA, Some _ when lists_parameters found ->
      Some
        "each parameter is followed by `->`, as in `Float -> Float -> Float`; a tuple stands in \
         parentheses"
  | _ -> None

let capital found =
  match (found.token.token, found.before) with
  | DOUBLE_COLON, Some { token = UPPER _; _ } ->
      Some "the name of a value starts with a small letter"
  | _ -> None

let pointer found =
  match (found.token.token, found.before) with
  | STAR, Some _ when first_word found = "foreign" ->
      Some "C is given the address of an array or a record anyway: leave out the `*`"
  | _ -> None

let size found =
  match (found.token.token, found.before) with
  | (STAR | SLASH | MINUS | OPERATOR ("+" | "-")), Some _ when is_in_a_size found ->
      Some
        "sizes are not computed: a name of its own, as `m` in `Array m Float`, is any size, and \
         `type Twice = 16` names one"
  | _ -> None
