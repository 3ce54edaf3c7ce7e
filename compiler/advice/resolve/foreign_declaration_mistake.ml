open Basis

let is_not (text : Syntax.Ir.name) ~wanted ~hint =
  let what = if text.text = "" then "an empty string" else Printf.sprintf "`%s`" text.text in
  Diagnostic.error ~code:"E0232" ~at:text.span "%s is not %s in C" what wanted
  |> Diagnostic.hint "%s" hint

let needs_header (name : Syntax.Ir.name) what =
  Diagnostic.error ~code:"E0233" ~at:name.span "no included C header defines %s" what
  |> Diagnostic.note "it is part of the program's state, so the C compiler must know its size"
  |> Diagnostic.hint "include the header in this module, as in `foreign include \"blob.h\"`"

let meaning : Resolve.Fact.c_meaning -> string = function
  | Reserved_by_c -> "reserved by the C standard"
  | In_c_headers -> "a keyword, or a macro or type in a C header"
  | Of_generated_c -> "used by the generated C code and its runtime"
  | Main_function -> "reserved for the entry point of a C program"

let diagnostic : Resolve.Fact.in_foreign_code -> Diagnostic.t = function
  | Not_a_name text ->
      is_not text ~wanted:"a name" ~hint:"write only the name of the function, as in `\"cbrt\"`"
  | Not_a_type text ->
      is_not text ~wanted:"the name of a type"
        ~hint:"write a struct, as in `\"struct frame\"`, or the name of a `typedef`"
  | Not_a_header text ->
      is_not text ~wanted:"the name of a header"
        ~hint:"write the path relative to this file's folder, as in `\"blob.h\"`"
  | Reserved_name { name; meaning = of_c } ->
      Diagnostic.error ~code:"E0232" ~at:name.span
        "`%s` cannot be the C name of your function: it is %s" name.text (meaning of_c)
      |> Diagnostic.hint "give the function another name in C"
  | Header_elsewhere text ->
      Diagnostic.error ~code:"E0232" ~at:text.span "`%s` is outside this module's folder" text.text
      |> Diagnostic.hint "move the header to the folder of this module, or to a folder inside it"
  | State_without_header { name; symbol } ->
      needs_header name (Printf.sprintf "`struct %s_state`" symbol)
  | Type_without_header { name; c_type } -> needs_header name (Printf.sprintf "`%s`" c_type)
