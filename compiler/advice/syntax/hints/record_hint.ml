open Syntax
open Grammar
open Found

(* Does the field directly follow `{` or `,`? Then it belongs to a record value, not to a
   declaration. *)
let field_of_a_value found (field : Layout.token) =
  let rec back i = if is_blank (char_at found i) && i >= 0 then back (i - 1) else char_at found i in
  match back (field.start.pos_cnum - 1) with '{' | ',' -> true | _ -> false

let is_a_unit : Layout.context -> bool = function
  | (Bracket, { by = { token = UNIT_BRACKET; _ }; _ }) :: _ -> true
  | _ -> false

(* `P { x = 0, y = 1 }` for `P { 0, 1 }`, if the program declares the fields of `P` on one line. *)
let named_by_declaration found =
  let open Basis.Let_syntax.Option in
  let* brace =
    match found.context with (Brace, { by; _ }) :: _ -> Some by.start.pos_cnum | _ -> None
  in
  let constructor = word_before found brace in
  let* inside, _ = Other_definition.in_braces found.text brace in
  let values = List.map String.trim (String.split_on_char ',' inside) in
  let declares line =
    String.starts_with ~prefix:"data " line
    && List.mem constructor (String.split_on_char ' ' line)
    && String.contains line '{'
  in
  let* line = List.find_opt declares (String.split_on_char '\n' found.text) in
  let* declared, _ = Other_definition.in_braces line (String.index line '{') in
  let field text = List.hd (String.split_on_char ' ' (String.trim text)) in
  let fields = List.map field (String.split_on_char ',' declared) in
  if constructor = "" || List.compare_lengths fields values <> 0 then None
  else
    let pairs = List.map2 (fun f v -> Printf.sprintf "%s = %s" f v) fields values in
    Some (Printf.sprintf "%s { %s }" constructor (String.concat ", " pairs))

let without_names found =
  match (found.token.token, found.before) with
  | (NUMBER _ | MINUS | STRING _ | LPAREN), Some { token = LBRACE | COMMA; _ }
    when opens_with Layout.Brace found.context ->
      Some
        (Printf.sprintf "write the name of the field before each value: `%s`"
           (Option.value (named_by_declaration found) ~default:"Pose { heading = 0 }"))
  | _ -> None

(* `P { .a = x }`, as in C *)
let with_points found =
  match (found.token.token, found.before) with
  | OPERATOR ".", Some { token = LBRACE | COMMA; _ } when opens_with Layout.Brace found.context ->
      Some "write only the name of the field before `=`, without the dot"
  | _ -> None

let in_a_unit found =
  match (found.token.token, found.before) with
  | FIELD _, Some _ when is_a_unit found.context ->
      Some "multiply units with a space or `*`, as in `kg m^2`"
  | MINUS, Some { token = LOWER unit_ | UPPER unit_; _ } when is_a_unit found.context ->
      let last = unit_.[String.length unit_ - 1] in
      Some
        (if last = '1' || Basis.Character.is_digit (after found) then
           Printf.sprintf "write a `^` before an exponent: `%s^-%c`" unit_
             (if Basis.Character.is_digit (after found) then after found else last)
         else "multiply units with a space or `*`, as in `kg m^2`, and divide with `/`")
  | _ -> None

let without_comma found =
  match (found.token.token, found.before) with
  | EQUAL, Some _ when opens_with Layout.Brace found.context ->
      Some "write a `,` between two fields"
  | _ -> None

let typed found =
  match (found.token.token, found.before) with
  | DOUBLE_COLON, Some field when opens_with Layout.Brace found.context ->
      if field_of_a_value found field then Some "set a field with `=`"
      else Some "write a `,` between two fields"
  | _ -> None

(* A type that the program declares and that has this field. *)
let declares found field =
  let has line =
    let blank c = if Basis.Character.is_name c then c else ' ' in
    let words = String.split_on_char ' ' (String.map blank line) in
    String.starts_with ~prefix:"data " line && List.mem field words
  in
  match List.find_opt has (String.split_on_char '\n' found.text) with
  | Some line -> (
      match String.split_on_char ' ' line with _ :: name :: _ -> Some name | _ -> None)
  | None -> None

let without_constructor found =
  let at = found.token.start.pos_cnum in
  match Other_definition.in_braces found.text at with
  | Some (inside, _) when inside <> "" && String.length inside < 80 ->
      let field = String.trim (List.hd (String.split_on_char '=' inside)) in
      let name =
        match (declares found field, field) with
        | Some name, _ -> name
        | None, ("x" | "y") -> "Vec2"
        | None, ("position" | "heading") -> "Pose"
        | None, ("kp" | "ki" | "kd" | "largest") -> "Pid"
        | None, _ -> "Config"
      in
      Printf.sprintf "put the constructor of the type before the braces, as in `%s { %s }`" name
        (String.concat " " (String.split_on_char '\n' inside))
  | Some _ | None -> "write the constructor before the braces, as in `Pose { heading = 0 }`"

(* `Dark | Dim | Bright` for the names in `{ Dark, Dim, Bright }`. *)
let alternatives inside =
  let names = List.map String.trim (String.split_on_char ',' inside) in
  let is_constructor name =
    name <> "" && Basis.Character.is_upper name.[0] && String.for_all Basis.Character.is_name name
  in
  if List.for_all is_constructor names then Some (String.concat " | " names) else None

let constructor_of_data found =
  match (found.token.token, found.before) with
  | LBRACE, Some { token = EQUAL; _ } when first_word found = "data" -> (
      let head = between found found.token.start.pos_bol found.token.start.pos_cnum in
      match
        ( String.split_on_char ' ' head,
          Other_definition.in_braces found.text found.token.start.pos_cnum )
      with
      | _ :: name :: _, Some (inside, _) when String.length inside < 100 ->
          let inside = String.concat " " (String.split_on_char '\n' inside) in
          Some
            (match alternatives inside with
            | Some text ->
                Printf.sprintf "%s: `%s %s`"
                  (if String.contains text '|' then
                     "write `|` between the constructors, without braces"
                   else "remove the braces")
                  (String.trim head) text
            | None ->
                Printf.sprintf "put the constructor before the braces: `data %s = %s { %s }`" name
                  name inside)
      | _ -> None)
  | _ -> None

let type_before_name found =
  match (found.token.token, found.before) with
  | (UPPER _ | LOWER _), Some { token = LBRACE | COMMA; _ }
    when opens_with Layout.Brace found.context && first_word found = "data" -> (
      let at = found.token.start.pos_cnum in
      let rec stop i =
        if List.mem (char_at found i) [ ','; '}'; '\n'; ';' ] then i else stop (i + 1)
      in
      match String.split_on_char ' ' (String.trim (between found at (stop at))) with
      | [ type_; name ] when name <> "" && Basis.Character.is_lower name.[0] ->
          Some (Printf.sprintf "in a field, the type comes after the name: `%s :: %s`" name type_)
      | _ -> None)
  | _ -> None

(* A record update such as `{ p | x = 1 }`. *)
let changed_copy found =
  let brace =
    match (found.token.token, found.context) with
    | LBRACE, _ -> Some found.token.start.pos_cnum
    | _, (Brace, { by; _ }) :: _ -> Some by.start.pos_cnum
    | _ -> None
  in
  Option.bind brace (Other_record.changed_copy found.text)

let block_in_braces found =
  match (found.token.token, found.before) with
  | LBRACE, Some { token = OPEN; _ } -> Some (Indentation_hint.without_braces found)
  | _ -> None

let without_equation found =
  match (found.token.token, found.before) with
  | (LOWER _ | UPPER _ | NUMBER _ | LPAREN), Some { token = LOWER _; _ }
    when opens_with Layout.Brace found.context ->
      Some "set a field with `=`; if you meant a block, indent it instead of using braces"
  | _ -> None

let changed found =
  match (found.token.token, found.before) with
  | (OPERATOR _ | MINUS | STAR | SLASH | CARET), Some ({ token = LOWER _; _ } as field)
    when opens_with Layout.Brace found.context && field_of_a_value found field ->
      let name = written found field in
      Some
        (Printf.sprintf
           "set a field with `=`, even if the value depends on the old one: `r { %s = r.%s + 1 }`"
           name name)
  | _ -> None

let strict found =
  match (found.token.token, found.before) with
  | OPERATOR "!", _ when first_word found = "data" ->
      Some "remove the `!`: fields are always evaluated"
  | _ -> None

let capital found =
  match (found.token.token, found.before) with
  | UPPER _, Some { token = LBRACE | COMMA; _ } when opens_with Layout.Brace found.context ->
      Some
        (Printf.sprintf "start the name of a field with a lower-case letter: `%s`"
           (String.uncapitalize_ascii (written found found.token)))
  | _ -> None
