open Basis
open Syntax
open Grammar
open Found

let line found =
  let bol = found.token.start.pos_bol in
  (bol, end_of_line found bol)

(* The span between these offsets on the token's line. *)
let span_of found (first, last) =
  let at offset = { found.token.start with pos_cnum = offset } in
  Build.span (at first, at last)

let error found ~at format = Diagnostic.error ~code:"E0110" ~at:(span_of found at) format

let instead found ~at text d =
  Diagnostic.hint "write `%s`" text d |> Diagnostic.write (span_of found at) text

let is_short text = String.length text <= 90

(* Splits the text into the part before a string literal, the literal, and the part after it. *)
let split_at_text text =
  match (String.index_opt text '"', String.rindex_opt text '"') with
  | Some first, Some last when first < last ->
      let before = String.trim (String.sub text 0 first) in
      let label = String.sub text first (last - first + 1) in
      let behind = String.trim (String.sub text (last + 1) (String.length text - last - 1)) in
      Some (before, label, behind)
  | _ -> None

(* The code between two offsets, up to the first comment, with the offsets of its start and end. *)
let code_between found first last =
  let text = String.sub found.text first (max 0 (last - first)) in
  let code = Kept_comments.code text in
  let rec blanks k = if k < String.length text && is_blank text.[k] then blanks (k + 1) else k in
  let start = first + blanks 0 in
  (code, (start, start + String.length code))

(* an assertion in another notation: `assert (x > 0)`, `assert (x > 0) "above"`, `assert "above" = x
   > 0` *)
let claim found =
  match first_word_of_line found with
  | ("assert" | "assume") as word
    when match found.token.token with END | SEMICOLON | CLOSE | EQUAL | COMMA -> true | _ -> false
    -> (
      let ((_, stop) as at) = first_word_from found (fst (line found)) in
      let ends = found.token.start.pos_cnum in
      let last = match found.token.token with EQUAL | COMMA -> snd (line found) | _ -> ends in
      let text, (_, behind) = code_between found stop last in
      let whole = (fst at, behind) in
      let written condition label =
        Printf.sprintf "%s %s %s" word label (Source.grouped condition)
      in
      let balanced text =
        let count c = List.length (String.split_on_char c text) in
        count '(' = count ')'
      in
      let with_fix found text d =
        if is_short text && balanced text then instead found ~at:whole text d
        else Diagnostic.hint "write, for example, `%s \"keeps off the wall\" (x > 0)`" word d
      in
      let without_sign behind =
        let is_sign c = c = '=' || c = ':' || c = ',' in
        let rec skip i =
          if i < String.length behind && (is_sign behind.[i] || is_blank behind.[i]) then
            skip (i + 1)
          else i
        in
        let i = skip 0 in
        String.sub behind i (String.length behind - i)
      in
      match split_at_text text with
      | Some ("", label, behind) when found.token.token = EQUAL ->
          Some
            (error found
               ~at:(found.token.start.pos_cnum, found.token.stop.pos_cnum)
               "the condition must directly follow the label"
            |> with_fix found (written (without_sign behind) label))
      | Some ("", _, _) -> None
      | Some (condition, label, "") ->
          let condition =
            let n = String.length condition in
            if n > 0 && condition.[n - 1] = ',' then String.sub condition 0 (n - 1) else condition
          in
          Some
            (error found ~at "the label of an `%s` must come first" word
            |> with_fix found (written (String.trim (without_sign condition)) label))
      | Some _ -> None
      | None when text = "" -> None
      | None ->
          Some
            (error found ~at "an `%s` needs a label that describes its condition" word
            |> with_fix found (written text "\"keeps off the wall\"")))
  | _ -> None

(* `param gain = 0.5`, without a type *)
let param found =
  match (first_word found, found.token.token, found.before) with
  | "param", EQUAL, Some { token = LOWER name; _ } ->
      let value, (_, stop) = code_between found found.token.stop.pos_cnum (snd (line found)) in
      if value = "" || not (is_short value) then None
      else
        let text = Other_parameter.declaration ~name value in
        Some
          (error found
             ~at:(found.token.start.pos_cnum, found.token.stop.pos_cnum)
             "a parameter needs a type before its value"
          |> instead found ~at:(fst (line found), stop) text)
  | _ -> None

(* `param "speed" :: Velocity = 0.3[m/s]`, `param Velocity speed = 0.3[m/s]` and `param Speed …` *)
let param_name found =
  let first, _ = line found in
  let text, (_, stop) = code_between found found.token.start.pos_cnum (snd (line found)) in
  let rest after = String.trim (String.sub text after (String.length text - after)) in
  let typed name rest =
    if String.starts_with ~prefix:"::" rest then Some (Printf.sprintf "%s %s" name rest)
    else
      match String.index_opt rest '=' with
      | Some 0 ->
          let value = String.trim (String.sub rest 1 (String.length rest - 1)) in
          Some (Printf.sprintf "%s :: %s = %s" name (Other_parameter.type_of value) value)
      | Some _ | None -> None
  in
  let written =
    match (found.token.token, found.before) with
    | STRING _, Some { token = PARAM; _ } -> (
        match split_at_text text with
        | Some ("", label, rest) ->
            let name = String.sub label 1 (String.length label - 2) in
            let is_name = name <> "" && String.for_all Basis.Character.is_name name in
            if is_name then
              Option.map
                (fun it -> ("the name of a parameter must be written without quotes", it))
                (typed (String.uncapitalize_ascii name) rest)
            else None
        | Some _ | None -> None)
    | UPPER name, Some { token = PARAM; _ } -> (
        match Typed_equation.of_line text with
        | Some { name; type_; value; _ } ->
            Some
              ( "the name of a parameter must come before its type",
                Printf.sprintf "%s :: %s = %s" name type_ value )
        | None ->
            Option.map
              (fun it -> ("the name of a parameter must start with a lower-case letter", it))
              (typed (String.uncapitalize_ascii name) (rest (String.length name))))
    | _ -> None
  in
  Option.map
    (fun (what, text) ->
      error found ~at:(found.token.start.pos_cnum, found.token.stop.pos_cnum) "%s" what
      |> instead found ~at:(first, stop) ("param " ^ text))
    written

(* `param("speed", 0.3[m/s])` in an expression *)
let param_call found =
  match (found.token.token, found.before) with
  | PARAM, Some _ when first_word_of_line found <> "param" ->
      let bol = found.token.start.pos_bol and stop = found.token.stop.pos_cnum in
      Option.map
        (fun (name, declaration) ->
          let d =
            error found
              ~at:(found.token.start.pos_cnum, stop)
              "a parameter must be declared at the top level"
          in
          let at = found.token.start.pos_cnum in
          if Other_parameter.is_its_definition found.text at name then
            instead found ~at:(bol, end_of_line found stop) declaration d
          else Diagnostic.hint "%s" (Other_parameter.hint found.text at (name, declaration)) d)
        (Other_parameter.of_arguments found.text stop)
  | _ -> None

(* `let d = e` among the equations of a `where` *)
let let_equation found =
  let rec in_where : Layout.context -> bool = function
    | (Block Let, _) :: rest -> in_where rest
    | (Block Where, _) :: _ -> true
    | (Paren, _) :: rest -> in_where rest
    | _ -> false
  in
  match found.token.token with
  | (END | SEMICOLON | CLOSE) when first_word_of_line found = "let" && in_where found.context ->
      let first, last = first_word_from found (fst (line found)) in
      let equation = between found last found.token.start.pos_cnum in
      let start = fst (first_word_from found last) in
      if equation = "" then None
      else
        Some
          (error found ~at:(first, last) "the equations of a `where` cannot start with `let`"
          |> (if is_short equation then Diagnostic.hint "write `%s`" equation
              else Diagnostic.hint "remove it")
          |> Diagnostic.fix "remove it" [ (span_of found (first, start), "") ])
  | _ -> None

(* `HasSonar i, DiffDrive o => SF i o`, without parentheses around the constraints *)
let constraints found =
  let bol, stop = line found in
  let text = String.sub found.text bol (stop - bol) in
  let find sub from =
    let n = String.length sub in
    let rec go i =
      if i + n > String.length text then None
      else if String.sub text i n = sub then Some i
      else go (i + 1)
    in
    go from
  in
  match (found.token.token, find "::" 0) with
  | COMMA, Some colons when not (in_brackets found.context) -> (
      match find "=>" colons with
      | Some arrow when arrow > found.token.start.pos_cnum - bol ->
          let first = bol + colons + 2 and last = bol + arrow in
          let given = between found first last in
          let first = first + if char_at found first = ' ' then 1 else 0 in
          Some
            (error found
               ~at:(first, first + String.length given)
               "several constraints need parentheses"
            |> instead found ~at:(first, first + String.length given) (Printf.sprintf "(%s)" given)
            )
      | _ -> None)
  | _ -> None

(* `foreign import ccall "math.h sin" c_sin :: T`, as in Haskell *)
let foreign_import found =
  match (found.token.token, found.before) with
  | IMPORT, Some { token = FOREIGN; _ } -> (
      let bol, stop = line found in
      match split_at_text (between found found.token.stop.pos_cnum stop) with
      | Some (_, label, behind) when behind <> "" && is_short behind ->
          let inside = String.sub label 1 (String.length label - 2) in
          let symbol = List.hd (List.rev (String.split_on_char ' ' inside)) in
          Some
            (error found
               ~at:(found.token.start.pos_cnum, found.token.stop.pos_cnum)
               "`foreign` must not be followed by `import`, and the C name must come last"
            |> instead found ~at:(bol, stop) (Printf.sprintf "foreign %s = \"%s\"" behind symbol))
      | _ -> None)
  | _ -> None

(* `module Pilot`, without `where` *)
let module_head found =
  match (found.token.token, found.before) with
  | (END | SEMICOLON), Some ({ token = UPPER name; _ } as before)
    when first_word_of_line found = "module" && stands_after found "module" before ->
      Some
        (error found
           ~at:(found.token.start.pos_cnum, found.token.start.pos_cnum + 1)
           "a module header must end with `where`"
        |> Diagnostic.hint
             "write `module %s where`; a module that exports everything needs no header" name
        |> Diagnostic.fix "write `where`"
             [ (span_of found (before.stop.pos_cnum, before.stop.pos_cnum), " where") ])
  | _ -> None

(* `when (d < 1) (v = 0)`: an equation used as a conditional action *)
let equation_in_parentheses found =
  match (found.token.token, found.before, found.context) with
  | EQUAL, Some { token = LOWER name; start; _ }, (Paren, { by; _ }) :: _
    when between found by.stop.pos_cnum start.pos_cnum = ""
         && innermost_block found.context <> Do
         && List.mem (first_word_of_line found) [ "when"; "unless"; "if" ] ->
      let stop = end_of_line found found.token.stop.pos_cnum in
      let rest = between found found.token.stop.pos_cnum stop in
      let value =
        match String.index_opt rest ')' with
        | Some i when i > 0 && is_short rest -> String.trim (String.sub rest 0 i)
        | _ -> "…"
      in
      let behind_word = snd (first_word_from found (fst (line found))) in
      let condition = between found behind_word by.start.pos_cnum in
      let condition =
        let n = String.length condition in
        if n > 2 && condition.[0] = '(' && condition.[n - 1] = ')' then
          String.sub condition 1 (n - 2)
        else if n > 0 && is_short condition then condition
        else "…"
      in
      Some
        (error found ~at:(by.start.pos_cnum, stop)
           "an equation cannot be conditional: it holds at every instant"
        |> Diagnostic.hint "choose the value in one equation: `%s = if %s then %s else …`" name
             condition value)
  | _ -> None

let diagnostic found =
  List.find_map
    (fun mistake -> mistake found)
    [
      claim;
      param;
      param_name;
      param_call;
      let_equation;
      constraints;
      foreign_import;
      module_head;
      equation_in_parentheses;
    ]

(* {1 Hints} *)

let path found =
  let stop = end_of_line found found.token.start.pos_cnum in
  let text = between found found.token.start.pos_cnum stop in
  let text = List.hd (String.split_on_char ' ' text) in
  if not (String.exists (fun c -> c = '/' || c = '"' || c = '\\') text) then None
  else
    let unquoted = String.concat "" (String.split_on_char '"' text) in
    let base = Filename.remove_extension (Filename.basename unquoted) in
    if base = "" then None
    else
      Some
        (Printf.sprintf
           "name the module without its folder: `import %s`; its file must be in the same folder \
            as this one, or in the library"
           (String.capitalize_ascii base))

let choices found =
  match (found.token.token, found.before) with
  | LOWER _, Some { token = EQUAL | BAR; _ } when first_word found = "data" -> (
      let bol, stop = line found in
      let is_name = function
        | 'a' .. 'z' | 'A' .. 'Z' | '0' .. '9' | '_' | ' ' | '|' -> true
        | _ -> false
      in
      match String.split_on_char '=' (between found bol stop) with
      | [ head; all ] when String.for_all is_name all ->
          let capital part = String.capitalize_ascii (String.trim part) in
          let all = List.map capital (String.split_on_char '|' all) in
          Some
            (Printf.sprintf "start a constructor with a capital letter: `%s= %s`" head
               (String.concat " | " all))
      | _ -> None)
  | _ -> None
