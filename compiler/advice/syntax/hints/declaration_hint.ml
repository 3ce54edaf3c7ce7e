open Syntax
open Grammar
open Found

let reserved_word = Printf.sprintf "`%s` is a reserved word, so it cannot be a name"

(* The first line of the definition, up to the error. *)
let head_of_definition found =
  let start = start_of_definition found in
  if found.token.start.pos_bol = start then between found start found.token.start.pos_cnum
  else String.trim (first_line_of_definition found)

let lacks_where found =
  match String.split_on_char ' ' (first_line_of_definition found) with
  | ("class" | "instance") :: words -> not (List.mem "where" words)
  | _ -> false

let opens_block : Layout.token option -> bool = function
  | Some { token = OPEN; _ } -> true
  | Some _ | None -> false

let is_local : Layout.block -> bool = function Where | Let | Do | Rec -> true | Top | Of -> false

(* `param speed :: Velocity` without its default value, or `foreign cbrt :: Float -> Float` without
   its C name. *)
let lacks_a_value found =
  let line = String.trim (first_line_of_definition found) in
  let words = String.split_on_char ' ' line in
  match words with
  | ("param" | "foreign") :: rest
    when String.length line > 50 || String.contains line '=' || not (List.mem "::" rest) ->
      None
  | "param" :: _ -> Some (Printf.sprintf "add its default value: `%s = …`" line)
  | "foreign" :: ("type" | "include" | "sf") :: _ -> None
  | "foreign" :: name :: _ -> Some (Printf.sprintf "add its C name: `%s = \"%s\"`" line name)
  | _ -> None

let choices found =
  match (found.token.token, found.before) with
  | LOWER _, Some _ -> Lacking.choices found
  | _ -> None

let defined_word found =
  match (found.token.token, found.before) with
  | ( (EQUAL | DOUBLE_COLON),
      Some
        ({
           token =
             ( UNIT | PRIMITIVE | FOREIGN | PARAM | CLASS | INSTANCE | DATA | TYPE | MODULE | IMPORT
             | REC );
           _;
         } as word) ) ->
      Some (reserved_word (written found word))
  | _ -> None

let without_where found =
  match found.token.token with
  | (EQUAL | BAR | DOUBLE_COLON) when lacks_where found ->
      Some
        (Printf.sprintf "add `where`, and write the methods below it: `%s where`"
           (head_of_definition found))
  | _ -> None

let type_of_choices found =
  match (found.token.token, found.before) with
  | BAR, Some { token = UPPER _ | LOWER _; _ } when first_word found = "type" ->
      let start = found.token.start.pos_bol + 4 in
      Some
        (Printf.sprintf "to declare a type with several constructors, use `data`: `data %s`"
           (between found start (end_of_line found start)))
  | _ -> None

let foreign_import found =
  match (found.token.token, found.before) with
  | IMPORT, Some { token = FOREIGN; _ } ->
      Some "write the C name at the end: `foreign cubeRoot :: Float -> Float = \"cbrt\"`"
  | _ -> None

let without_value found =
  match (found.token.token, found.before) with
  | (END | SEMICOLON), Some _ -> lacks_a_value found
  | _ -> None

(* `type alias`, as in Elm *)
let alias found =
  match (found.token.token, found.before) with
  | LOWER "alias", Some { token = TYPE; _ } ->
      Some
        (match Other_definition.record found.text (start_of_definition found) with
        | Some declaration -> Beginnings.declare_a_record declaration
        | None ->
            Syntax_topic.text
              "remove `alias`: `type` by itself declares an alias, as in `type Speed = Float[m/s]`")
  | _ -> None

let capital found =
  match (found.token.token, found.before) with
  | LOWER _, Some { token = DATA | TYPE | CLASS; _ } ->
      Some
        (Printf.sprintf "start the name of a type or class with a capital letter: `%s`"
           (String.capitalize_ascii (written found found.token)))
  | _ -> None

let local found =
  match (found.token.token, found.before) with
  | (PARAM | DATA | TYPE | IMPORT | CLASS | INSTANCE | UNIT | FOREIGN), before
    when between found found.token.start.pos_bol found.token.start.pos_cnum = ""
         && (is_local (innermost_block found.context) || opens_block before) ->
      Some
        (Printf.sprintf "move the `%s` to the top level, without indentation"
           (written found found.token))
  | _ -> None

let word_as_name found =
  let word = written found found.token in
  match (found.token.token, found.before) with
  | (UNIT | TYPE), Some { token = UNIT_BRACKET | SLASH | STAR; _ }
    when Unit_variable.advice found.text found.token.start.pos_cnum word <> None ->
      Option.map
        (fun (_, advice) -> Printf.sprintf "`%s` is a keyword: %s" word advice)
        (Unit_variable.advice found.text found.token.start.pos_cnum word)
  | ( (UNIT | PRIMITIVE | FOREIGN | PARAM | CLASS | INSTANCE | DATA | TYPE | MODULE | IMPORT | REC),
      Some _ ) ->
      Some (reserved_word word)
  | _ -> None
