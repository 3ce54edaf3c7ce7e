open Basis

(* Of C99 and C++17: generated C is both. *)
let keywords =
  String.split_on_char ' '
    "alignas alignof and and_eq asm auto bitand bitor bool break case catch char char16_t char32_t \
     class compl const const_cast constexpr continue decltype default delete do double \
     dynamic_cast else enum explicit export extern false float for friend goto if inline int long \
     mutable namespace new noexcept not not_eq nullptr operator or or_eq private protected public \
     register reinterpret_cast restrict return short signed sizeof static static_assert \
     static_cast struct switch template this thread_local throw true try typedef typeid typename \
     union unsigned using virtual void volatile wchar_t while xor xor_eq _Bool _Complex _Imaginary"

let is_name text =
  text <> ""
  && (match text.[0] with 'a' .. 'z' | 'A' .. 'Z' | '_' -> true | _ -> false)
  && String.for_all
       (function 'a' .. 'z' | 'A' .. 'Z' | '0' .. '9' | '_' -> true | _ -> false)
       text
  && not (List.mem text keywords)

let refuse (scope : Scope.t) (text : Syntax.Ir.name) ~wanted ~hint =
  let what = if text.text = "" then "an empty text" else Printf.sprintf "`%s`" text.text in
  Diagnostic.error ~code:"E0232" ~at:text.span "%s is not %s in C" what wanted
  |> Diagnostic.hint hint
  |> Context.emit scope.context

let check_symbol scope (text : Syntax.Ir.name) =
  if not (is_name text.text) then
    refuse scope text ~wanted:"a name" ~hint:"write the name of the function alone, as in `\"cbrt\"`"

let check_type scope (text : Syntax.Ir.name) =
  let is_type =
    match String.split_on_char ' ' text.text with
    | [ name ] | [ ("struct" | "union" | "enum"); name ] -> is_name name
    | _ -> false
  in
  if not is_type then
    refuse scope text ~wanted:"the name of a type"
      ~hint:"write a struct as in `\"struct frame\"`, or the name of a `typedef`"

let check_header scope (text : Syntax.Ir.name) =
  let is_plain = function '"' | '\\' | '\n' | '\r' | '\000' -> false | _ -> true in
  if text.text = "" || not (String.for_all is_plain text.text) then
    refuse scope text ~wanted:"the name of a header"
      ~hint:"write the path from this file's folder, as in `\"blob.h\"`"

let check_includes (scope : Scope.t) (program : Syntax.Ir.program) =
  let is_include (d : Syntax.Ir.declaration) =
    match d.desc with Foreign (Foreign_include _) -> true | _ -> false
  in
  let require (name : Syntax.Ir.name) what =
    Diagnostic.error ~code:"E0233" ~at:name.span "no C header says what %s is" what
    |> Diagnostic.note "the state of a program has room for it, so C compilers must know its size"
    |> Diagnostic.hint "name the header in this module, as in `foreign include \"blob.h\"`"
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
