open Grammar
open Found

(* Is this a field of a record value, directly after `{` or `,`, rather than of a declaration? *)
let field_of_a_value found (field : Layout.token) =
  let rec back i = if is_blank (char_at found i) && i >= 0 then back (i - 1) else char_at found i in
  match back (field.start.pos_cnum - 1) with '{' | ',' -> true | _ -> false

let is_a_unit : Layout.context -> bool = function
  | (Bracket, { by = { token = UNIT_BRACKET; _ }; _ }) :: _ -> true
  | _ -> false

let without_names found =
  match (found.token.token, found.before) with
  | (NUMBER _ | MINUS | STRING _ | LPAREN), Some { token = LBRACE | COMMA; _ }
    when opens_with Layout.Brace found.context ->
      Some "each value stands behind the name of its field: `Pose { heading = 0 }`"
  | _ -> None

let in_a_unit found =
  match (found.token.token, found.before) with
  | FIELD _, Some _ when is_a_unit found.context ->
      Some "a blank or `*` multiplies units, as in `kg m^2`"
  | _ -> None

let without_comma found =
  match (found.token.token, found.before) with
  | EQUAL, Some _ when opens_with Layout.Brace found.context ->
      Some "there is a `,` between two fields"
  | _ -> None

let typed found =
  match (found.token.token, found.before) with
  | DOUBLE_COLON, Some field when opens_with Layout.Brace found.context ->
      if field_of_a_value found field then Some "a field gets its value with `=`"
      else Some "there is a `,` between two fields"
  | _ -> None

let block_in_braces found =
  match (found.token.token, found.before) with
  | LBRACE, Some { token = OPEN; _ } -> Some Indentation_hint.by_indentation
  | _ -> None

let without_equation found =
  match (found.token.token, found.before) with
  | (LOWER _ | UPPER _ | NUMBER _ | LPAREN), Some { token = LOWER _; _ }
    when opens_with Layout.Brace found.context ->
      Some "a field gets its value with `=`; if a block was meant, it is made by indentation"
  | _ -> None

let changed found =
  match (found.token.token, found.before) with
  | (OPERATOR _ | MINUS | STAR | SLASH | CARET), Some ({ token = LOWER _; _ } as field)
    when opens_with Layout.Brace found.context && field_of_a_value found field ->
      let name = written found field in
      Some
        (Printf.sprintf "a field gets its value with `=`, also from its own: `r { %s = r.%s + 1 }`"
           name name)
  | _ -> None

let strict found =
  match (found.token.token, found.before) with
  | OPERATOR "!", _ when first_word found = "data" ->
      Some "a field always has its value: leave out the `!`"
  | _ -> None

let capital found =
  match (found.token.token, found.before) with
  | UPPER _, Some { token = LBRACE | COMMA; _ } when opens_with Layout.Brace found.context ->
      Some
        (Printf.sprintf "the name of a field starts with a small letter: `%s`"
           (String.uncapitalize_ascii (written found found.token)))
  | _ -> None
