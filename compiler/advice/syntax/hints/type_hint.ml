open Syntax
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

(* Is the token in a signature, after `Array` and the first word of a size? *)
let is_in_a_size found =
  let line = between found found.token.start.pos_bol found.token.start.pos_cnum in
  let words = String.split_on_char ' ' (String.concat " " (String.split_on_char '(' line)) in
  List.mem "::" words
  && (not (List.mem "=" words))
  && match List.filter (( <> ) "") (List.rev words) with _ :: "Array" :: _ -> true | _ -> false

(* `vector<float>`, as in C++ *)
let with_parameters found =
  match (found.token.token, found.before) with
  | (OPERATOR "<" | DOUBLE_COLON), Some { token = UPPER _ | LOWER _; start; _ }
    when Other_type.in_angles found.text start.pos_cnum <> None ->
      let text, _ = Option.get (Other_type.in_angles found.text start.pos_cnum) in
      Some
        ("separate type arguments with spaces, without `<>`: write "
        ^ Option.value
            (Other_type.of_signature found.text found.token.start.pos_cnum)
            ~default:(Printf.sprintf "`%s`" text))
  | OPERATOR "<", Some { token = LOWER ("vector" | "array" | "list" | "deque"); _ } ->
      Some "write the size and the type of the elements of an array, as in `Array 4 Float`"
  | _ -> None

(* `Float m/s`, a unit without brackets *)
let unit_without_brackets found =
  match (found.token.token, found.before) with
  | SLASH, Some ({ token = LOWER unit_; _ } as before)
    when Lexer.is_unit unit_
         && List.mem
              (word_before found before.start.pos_cnum)
              [ "Float"; "Int"; "Double"; "Integer" ] ->
      let is_part c = Basis.Character.is_name c || List.mem c [ '/'; '^'; '*' ] in
      let rec last i = if is_part (char_at found i) then last (i + 1) else i in
      let first = before.start.pos_cnum in
      Some
        (Printf.sprintf "a unit in a type needs brackets: `%s[%s]`" (word_before found first)
           (String.sub found.text first (last first - first)))
  | _ -> None

(* `event float`, with a lower-case letter, or `float[]` *)
let in_another_notation found =
  match (found.token.token, found.before) with
  | (UPPER _ | LOWER _ | NUMBER _ | LPAREN), Some { token = LOWER name; _ }
    when Other_type.known name <> None || Other_type.is_of_elements name ->
      Option.map
        (fun signature -> "start the name of a type with a capital letter: write " ^ signature)
        (Other_type.changed found.text found.token.start.pos_cnum)
  | RBRACKET, Some { token = UNIT_BRACKET; _ } ->
      Option.map
        (fun signature -> "for an array, write " ^ signature)
        (Other_type.changed found.text found.token.start.pos_cnum)
  | _ -> None

(* `HasSonar i => DiffDrive o => SF i o`, as in Haskell *)
let contexts found =
  match found.token.token with
  | DOUBLE_ARROW -> (
      let line = between found found.token.start.pos_bol found.token.start.pos_cnum in
      let is_closed text = not (String.contains text '(' || String.contains text '=') in
      match String.split_on_char '=' line with
      | [ before; second ] when String.starts_with ~prefix:">" second -> (
          let second = String.trim (String.sub second 1 (String.length second - 1)) in
          match String.split_on_char ':' before with
          | [ _; ""; first ] when is_closed first && is_closed second ->
              Some (Printf.sprintf "write one context: `(%s, %s) =>`" (String.trim first) second)
          | _ -> None)
      | _ -> None)
  | _ -> None

(* `type Row = [Distance]` *)
let list found =
  match (found.token.token, found.before) with
  | LBRACKET, Some { token = EQUAL; _ } when first_word found = "type" ->
      let inside =
        between found found.token.stop.pos_cnum (end_of_line found found.token.start.pos_cnum)
      in
      Some
        (match String.split_on_char ']' inside with
        | [ element; "" ] when element <> "" && String.for_all Basis.Character.is_name element ->
            Printf.sprintf
              "Frob has arrays with a fixed number of elements: write `Array 5 %s`, and replace 5 \
               with your number"
              element
        | _ -> "Frob has arrays with a fixed number of elements, as in `Array 5 Float`")
  | _ -> None

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
  | DOUBLE_COLON, Some ({ token = UPPER _; _ } as before)
    when not (is_adjacent found before && Basis.Character.is_lower (after found)) ->
      Some "start the name of a value with a lower-case letter"
  | _ -> None

let pointer found =
  match (found.token.token, found.before) with
  | STAR, Some _ when first_word found = "foreign" ->
      Some "remove the `*`: arrays and records are always passed to C by address"
  | _ -> None

let size found =
  match (found.token.token, found.before) with
  | SLASH, Some _ when is_in_a_size found ->
      Some
        "a size can contain only the operators `+`, `-` and `*`: write the result as a number, or \
         name it, as in `type Half = 8`"
  | (STAR | MINUS | OPERATOR ("+" | "-")), Some _ when is_in_a_size found ->
      Some "put arithmetic on sizes in parentheses, as in `Array (N - 1) Float`"
  | _ -> None

(* `top-speed :: Velocity` *)
let hyphenated line =
  let is_a_word text =
    text <> "" && Basis.Character.is_lower text.[0] && String.for_all Basis.Character.is_name text
  in
  match String.split_on_char '-' (String.trim line) with
  | first :: (_ :: _ as others) when List.for_all is_a_word (first :: others) ->
      Some (String.concat "" (first :: List.map String.capitalize_ascii others))
  | _ -> None

(* `max 0 x` for `std::max(0, x)`, where the token is the `::` *)
let of_a_namespace found (before : Layout.token) =
  let text = found.text and first = before.start.pos_cnum in
  let is_of_a_name c = Basis.Character.is_name c || c = ':' in
  let rec forward i = if is_of_a_name (char_at found i) then forward (i + 1) else i in
  let rec close i depth =
    match char_at found i with
    | '(' -> close (i + 1) (depth + 1)
    | ')' -> if depth = 1 then i + 1 else close (i + 1) (depth - 1)
    | '\n' -> i
    | _ -> close (i + 1) depth
  in
  let name = forward first in
  let stop = if char_at found name = '(' then close name 0 else name in
  match Other_notation.expression (String.sub text first (stop - first)) with
  | Some text when not (Other_type.mentions "::" text) -> Some text
  | Some _ | None -> None

let misplaced found =
  let general = "put the expression and its type in parentheses: `(e :: T)`" in
  let at = found.token.start.pos_cnum in
  let line = between found found.token.start.pos_bol at in
  let ty = between found found.token.stop.pos_cnum (end_of_line found at) in
  let words = List.filter (( <> ) "") (String.split_on_char ' ' line) in
  match found.before with
  | Some { token = LOWER _; _ } when hyphenated line <> None ->
      Printf.sprintf "a name cannot contain `-`: write `%s`" (Option.get (hyphenated line))
  | Some ({ token = LOWER _ | UPPER _; _ } as before)
    when is_adjacent found before && Basis.Character.is_lower (after found) ->
      let prefix = written found before in
      Option.fold (of_a_namespace found before)
        ~none:
          (if Basis.Character.is_upper prefix.[0] then
             Printf.sprintf "write a name from a module as `%s.name`, or just `name`" prefix
           else Printf.sprintf "remove `%s::`: write a name from a module as `Module.name`" prefix)
        ~some:(fun text ->
          Printf.sprintf "write `%s`, without `%s::`%s" text prefix
            (if String.starts_with ~prefix:"clamp " text then "; it needs `import Control`" else ""))
  | _ when String.length line + String.length ty > 70 || String.contains ty '=' -> (
      match words with
      | name :: _ when (not (List.mem "=" words)) && Basis.Character.is_lower name.[0] ->
          "write a signature on the line above, with only the name before the `::`: `f :: Float -> \
           Float`"
      | _ -> general)
  | _ -> (
      match (words, found.before) with
      | [ name; "=" ], Some { token = EQUAL; _ } ->
          Printf.sprintf "remove the `=`: `%s :: %s`" name ty
      | name :: _ :: _, _
        when String.for_all Basis.Character.is_name name
             && Basis.Character.is_lower name.[0]
             && not (List.mem "=" words || List.mem "->" words) ->
          Printf.sprintf "write only the name before the `::` of a signature: `%s :: %s`" name ty
      | _, Some { token = LOWER _ | NUMBER _ | RPAREN | RBRACKET | FIELD _; _ } -> (
          match List.rev (String.split_on_char '=' line) with
          | value :: _ :: _ when not (List.mem "->" words || String.contains value '(') ->
              Printf.sprintf "put the expression and its type in parentheses: `(%s :: %s)`"
                (String.trim value) ty
          | _ -> general)
      | _ -> general)
