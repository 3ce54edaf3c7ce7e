open Basis

let is_name text =
  text <> ""
  && (match text.[0] with 'a' .. 'z' | 'A' .. 'Z' | '_' -> true | _ -> false)
  && String.for_all
       (function 'a' .. 'z' | 'A' .. 'Z' | '0' .. '9' | '_' -> true | _ -> false)
       text
  && not (C_names.is_keyword text)

let report (scope : Scope.t) = Context.report_foreign scope.context

(* The meaning that the name already has in C, in C headers or in generated code, if any. If
   generated code declared such a name again, the code would be invalid or the name would refer to
   something else. *)
let meaning (scope : Scope.t) ~(kind : Syntax.Ir.foreign_kind) text : Fact.c_meaning option =
  let starts prefix = String.starts_with ~prefix text in
  let is_reserved =
    starts "__" || (starts "_" && String.length text > 1 && text.[1] = Char.uppercase_ascii text.[1])
  in
  if is_reserved then Some Reserved_by_c
  else if C_names.is_taken text then Some In_c_headers
  else if starts "frob_" && not scope.library then Some Of_generated_c
  else if kind = Foreign_function && text = "main" then Some Main_function
  else None

let check_symbol (scope : Scope.t) ~kind (name : Syntax.Ir.name) =
  if not (is_name name.text) then report scope (Not_a_name name)
  else
    Option.iter
      (fun meaning -> report scope (Reserved_name { name; meaning }))
      (meaning scope ~kind name.text)

let check_type scope (text : Syntax.Ir.name) =
  let is_type =
    match String.split_on_char ' ' text.text with
    | [ name ] | [ ("struct" | "union" | "enum"); name ] -> is_name name
    | _ -> false
  in
  if not is_type then report scope (Not_a_type text)

let check_header scope (text : Syntax.Ir.name) =
  let is_plain = function '"' | '\\' | '\n' | '\r' | '\000' -> false | _ -> true in
  if text.text = "" || not (String.for_all is_plain text.text) then report scope (Not_a_header text)
  else if
    (not (Filename.is_relative text.text)) || List.mem ".." (String.split_on_char '/' text.text)
  then report scope (Header_elsewhere text)

let check_includes (scope : Scope.t) (program : Syntax.Ir.program) =
  let is_include (d : Syntax.Ir.declaration) =
    match d.desc with Foreign (Foreign_include _) -> true | _ -> false
  in
  let declaration (d : Syntax.Ir.declaration) =
    match d.desc with
    | Foreign (Foreign_value { kind = Foreign_signal_function; name; symbol; _ }) ->
        report scope (State_without_header { name; symbol = symbol.text })
    | Foreign (Foreign_type { name; c_type; copyable = true }) ->
        report scope (Type_without_header { name; c_type = c_type.text })
    | _ -> ()
  in
  if not (List.exists is_include program.declarations) then
    List.iter declaration program.declarations
