open Basis

let is_name text =
  text <> ""
  && (match text.[0] with 'a' .. 'z' | 'A' .. 'Z' | '_' -> true | _ -> false)
  && String.for_all
       (function 'a' .. 'z' | 'A' .. 'Z' | '0' .. '9' | '_' -> true | _ -> false)
       text
  && not (C_names.is_keyword text)

let refuse (scope : Scope.t) (text : Syntax.Ir.name) ~wanted ~hint =
  let what = if text.text = "" then "an empty text" else Printf.sprintf "`%s`" text.text in
  Diagnostic.error ~code:"E0232" ~at:text.span "%s is not %s in C" what wanted
  |> Diagnostic.hint hint |> Context.emit scope.context

(* The meaning that C or its headers may give to the name. If generated C declared the name, the C
   would be invalid or refer to something else. *)
let meaning (scope : Scope.t) ~(kind : Syntax.Ir.foreign_kind) text =
  let starts prefix = String.starts_with ~prefix text in
  let is_reserved =
    starts "__" || (starts "_" && String.length text > 1 && text.[1] = Char.uppercase_ascii text.[1])
  in
  if is_reserved then Some "reserved by the C standard"
  else if C_names.is_taken text then Some "a macro or a type in C's headers"
  else if starts "frob_" && not scope.library then Some "used by generated C and its runtime"
  else if kind = Foreign_function && text = "main" then
    Some "the function that a C program starts with"
  else None

let check_symbol (scope : Scope.t) ~kind (text : Syntax.Ir.name) =
  if not (is_name text.text) then
    refuse scope text ~wanted:"a name" ~hint:"write only the name of the function, as in `\"cbrt\"`"
  else
    match meaning scope ~kind text.text with
    | None -> ()
    | Some meaning ->
        Diagnostic.error ~code:"E0232" ~at:text.span
          "your function cannot be called `%s` in C: that name is %s" text.text meaning
        |> Diagnostic.hint "give the function another name in C"
        |> Context.emit scope.context

let check_type scope (text : Syntax.Ir.name) =
  let is_type =
    match String.split_on_char ' ' text.text with
    | [ name ] | [ ("struct" | "union" | "enum"); name ] -> is_name name
    | _ -> false
  in
  if not is_type then
    refuse scope text ~wanted:"the name of a type"
      ~hint:"write a struct, as in `\"struct frame\"`, or the name of a `typedef`"

let check_header scope (text : Syntax.Ir.name) =
  let is_plain = function '"' | '\\' | '\n' | '\r' | '\000' -> false | _ -> true in
  if text.text = "" || not (String.for_all is_plain text.text) then
    refuse scope text ~wanted:"the name of a header"
      ~hint:"write the path from this file's folder, as in `\"blob.h\"`"
  else if
    (not (Filename.is_relative text.text)) || List.mem ".." (String.split_on_char '/' text.text)
  then
    Diagnostic.error ~code:"E0232" ~at:text.span "`%s` is outside of this module's folder" text.text
    |> Diagnostic.hint "move the header to the folder of this module, or to a folder inside it"
    |> Context.emit scope.context

let check_includes (scope : Scope.t) (program : Syntax.Ir.program) =
  let is_include (d : Syntax.Ir.declaration) =
    match d.desc with Foreign (Foreign_include _) -> true | _ -> false
  in
  let require (name : Syntax.Ir.name) what =
    Diagnostic.error ~code:"E0233" ~at:name.span "no included C header defines %s" what
    |> Diagnostic.note "it is part of the program's state, so the C compiler must know its size"
    |> Diagnostic.hint "include the header in this module, as in `foreign include \"blob.h\"`"
    |> Context.emit scope.context
  in
  let declaration (d : Syntax.Ir.declaration) =
    match d.desc with
    | Foreign (Foreign_value { kind = Foreign_signal_function; name; symbol; _ }) ->
        require name (Printf.sprintf "`struct %s_state`" symbol.text)
    | Foreign (Foreign_type { name; c_type; copyable = true }) ->
        require name (Printf.sprintf "`%s`" c_type.text)
    | _ -> ()
  in
  if not (List.exists is_include program.declarations) then
    List.iter declaration program.declarations
