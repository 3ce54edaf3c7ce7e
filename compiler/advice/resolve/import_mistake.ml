open Basis
open Resolve

let file_of name = name ^ ".frob"

(* {1 Missing modules} *)

type missing = { target : Syntax.Ir.name; imported : string list; known : string list }
type rule = missing -> (Diagnostic.t -> Diagnostic.t) option

let is_module name = name <> "" && Character.is_upper name.[0]

let lower_case : rule =
 fun { target; known; _ } ->
  let same name =
    (not (is_module name)) && String.equal (String.capitalize_ascii name) target.text
  in
  Option.map
    (fun file ->
      Diagnostic.hint
        "the file name of a module must start with a capital letter, too: rename `%s` to `%s`"
        (file_of file) (file_of target.text))
    (List.find_opt same known)

let of_another_language : rule =
 fun { target; _ } ->
  Option.map
    (fun row -> Diagnostic.hint "%s" (Phrasebook.hint row))
    (Phrasebook.find Module target.text)

let similar : rule =
 fun { target; known; _ } ->
  Option.map
    (fun near d -> Diagnostic.hint "did you mean `%s`?" near d |> Diagnostic.write target.span near)
    (Suggest.closest target.text (List.filter is_module known))

(* The contents of the module are in a library module with a different name. *)
let in_library : rule =
 fun { target; imported; _ } ->
  let named (row : Phrase.t) =
    match row with
    | { hint = Some what; replacement = Some module_; _ } -> Some (what, module_)
    | _ -> None
  in
  Option.map
    (fun (what, module_) ->
      if List.mem module_ imported then
        Diagnostic.hint "remove this line: %s in `%s`, which is already imported" what module_
      else fun d ->
        Diagnostic.hint "%s in `%s`: write `import %s`" what module_ module_ d
        |> Diagnostic.write target.span module_)
    (Option.bind (Phrasebook.find Library target.text) named)

let missing_module (missing : missing) =
  let rules = [ lower_case; of_another_language; similar; in_library ] in
  Diagnostic.error ~code:"E0201" ~at:missing.target.span "there is no module `%s`"
    missing.target.text
  |> Diagnostic.note "frobc looked for `%s` in the folder of this file and in the library"
       (file_of missing.target.text)
  |> Option.value (List.find_map (fun rule -> rule missing) rules) ~default:Fun.id

(* {1 Other mistakes} *)

let unreadable ~at file reason =
  Diagnostic.error ~code:"E0201" ~at "cannot read `%s`: %s" file reason

let cycle (target : Syntax.Ir.name) places =
  let names =
    List.map (fun (place : Fact.import_place) -> Printf.sprintf "`%s`" place.importer) places
  in
  let path = String.concat " → " (names @ [ Printf.sprintf "`%s`" target.text ]) in
  let label diagnostic (place : Fact.import_place) =
    if Span.compare place.at target.span = 0 then diagnostic
    else
      Diagnostic.label ~at:place.at "`%s` imports `%s`" place.importer place.target.text diagnostic
  in
  List.fold_left label
    (Diagnostic.error ~code:"E0202" ~at:target.span "modules import each other: %s" path)
    places

let no_program ~tests ~program reason =
  let why =
    match reason with Some reason -> "cannot be read: " ^ reason | None -> "does not exist"
  in
  Diagnostic.error ~code:"E0236" ~at:(Span.start_of_file tests)
    "this is a test file, but the program `%s` %s" (Filename.basename program) why
  |> Diagnostic.hint "put the tests of `NAME.frob` into `NAME.test.frob` in the same folder"

let in_tests ~at what hint =
  Diagnostic.error ~code:"E0237" ~at "a test file cannot %s" what |> Diagnostic.hint "%s" hint

let diagnostic : Fact.in_modules -> Diagnostic.t = function
  | Missing_module { target; imported; known } -> missing_module { target; imported; known }
  | Missing_file { at; file } -> unreadable ~at file "there is no such file"
  | Unreadable_file { at; file; reason } -> unreadable ~at file reason
  | Import_cycle { target; places } -> cycle target places
  | Other_file_name { module_; file } ->
      Diagnostic.error ~code:"E0203" ~at:module_.span "the module `%s` is in a file named `%s`"
        module_.text (file_of file)
      |> Diagnostic.hint "rename the module to `%s` or the file to `%s`" file (file_of module_.text)
  | Two_files { target; earlier; later } ->
      Diagnostic.error ~code:"E0203" ~at:target.span "two modules are named `%s`: `%s` and `%s`"
        target.text earlier later
      |> Diagnostic.hint "give your own module another name"
  | No_program { tests; program; reason } -> no_program ~tests ~program reason
  | Header_in_tests at ->
      in_tests ~at "have a `module` header"
        "remove the header: the tests belong to the program's module"
  | Main_in_tests at ->
      in_tests ~at "define `main`"
        "a program is compiled without its test file: define `main` in the program, or give this \
         definition another name"
  | Primitive_outside_library name ->
      Diagnostic.error ~code:"E0204" ~at:name.span
        "only the standard library can declare primitives"
