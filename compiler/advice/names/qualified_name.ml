open Basis
open Resolve

(* {1 Qualifiers} *)

type rule = Visible.t -> Syntax.Ir.name -> Syntax.Ir.name -> (Diagnostic.t -> Diagnostic.t) option

let of_the_library : rule =
 fun visible qualifier _ ->
  let is_it (m : Visible.of_library) = String.equal m.module_ qualifier.text in
  if List.exists is_it (Lazy.force visible.elsewhere) then
    let import = Printf.sprintf "import qualified %s" qualifier.text in
    Some
      (fun d ->
        Diagnostic.hint "the library has this module: add `%s`" import d
        |> Imports.add visible.syntax import)
  else None

(* `Mode.Drive`, where `Mode` is a type and not a module. *)
let of_a_type : rule =
 fun visible qualifier name ->
  if
    Visible.is_known visible Interface.tycons qualifier.text
    && Visible.is_known visible Interface.constructors name.text
  then
    let title = Printf.sprintf "remove `%s.`" qualifier.text in
    Some
      (fun d ->
        Diagnostic.hint "`%s` is a type, not a module, so it cannot qualify a constructor: %s"
          qualifier.text title d
        |> Diagnostic.fix title [ ({ qualifier.span with stop = name.span.start }, "") ])
  else None

let of_another_language : rule =
 fun visible qualifier _ ->
  Option.map
    (fun row ->
      match Rewritten.of_a_module ~text:visible.text qualifier with
      | Some (at, text) ->
          fun d ->
            Diagnostic.hint "mathematical functions are built in: write `%s`" text d
            |> Diagnostic.write at (Source.grouped text)
      | None -> Diagnostic.hint "%s" (Phrasebook.hint row))
    (Phrasebook.find Qualifier qualifier.text)

let similar suggestions (visible : Visible.t) (qualifier : Syntax.Ir.name) =
  let imported =
    lazy
      (List.filter (fun i -> not (Visible.is_implied i)) visible.imports
      |> List.concat_map (fun (i : Visible.import) -> i.qualifiers))
  in
  Suggestion.add suggestions qualifier.text imported

let unknown_qualifier suggestions visible (qualifier : Syntax.Ir.name) name =
  let rules = [ of_the_library; of_a_type; of_another_language ] in
  let explain =
    match List.find_map (fun (rule : rule) -> rule visible qualifier name) rules with
    | Some explain -> explain
    | None -> similar suggestions visible qualifier
  in
  Diagnostic.error ~code:"E0215" ~at:qualifier.span "no module `%s` is imported here" qualifier.text
  |> explain

(* {1 Names} *)

let unknown_in_module suggestions namespace ~(qualifier : Syntax.Ir.name) ~known
    (name : Syntax.Ir.name) =
  Diagnostic.error ~code:(Namespace.unknown namespace) ~at:name.span "module `%s` has no %s `%s`"
    qualifier.text (Namespace.noun namespace) name.text
  |> Suggestion.add suggestions name.text known

let absent suggestions ~module_ ~known ~to_ (name : Syntax.Ir.name) =
  Diagnostic.error ~code:"E0215" ~at:name.span "module `%s` has no `%s` to %s" module_ name.text to_
  |> Suggestion.add suggestions name.text known
