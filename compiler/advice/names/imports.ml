open Basis
open Resolve

let without_imported (visible : Visible.t) hint =
  let words (import : Visible.import) =
    if import.unqualified then Some (Printf.sprintf ", with `import %s`" import.module_) else None
  in
  let remove hint part =
    let n = String.length part in
    let rec find i =
      if i + n > String.length hint then hint
      else if String.equal (String.sub hint i n) part then
        String.sub hint 0 i ^ String.sub hint (i + n) (String.length hint - i - n)
      else find (i + 1)
    in
    find 0
  in
  List.fold_left remove hint (List.filter_map words visible.imports)

let add program declaration =
  let { Ir.place; before; after } = Context.import_place program in
  Diagnostic.fix (Printf.sprintf "add `%s`" declaration) [ (place, before ^ declaration ^ after) ]

(* {1 Missing imports} *)

type absent = {
  imports : string list;  (** any one of them would bring the name into scope *)
  listed : Syntax.Ir.import option;  (** an import of the name's module whose list lacks the name *)
  unknown : Unknown.t;
}

(* An import whose list lacks the name, although the module exports it. *)
let incomplete_import (t : Unknown.t) =
  let visible = t.module_.visible in
  let lacks (import : Syntax.Ir.import) =
    match import.items with
    | Some _ when not import.qualified ->
        List.exists
          (fun (m : Visible.of_library) ->
            String.equal m.module_ import.module_.text && t.is_in m.names)
          (Lazy.force visible.elsewhere)
    | Some _ | None -> false
  in
  List.find_opt lacks visible.syntax.imports

let absent (t : Unknown.t) =
  let has (m : Visible.of_library) = t.is_in m.names in
  let all = List.filter has (Lazy.force t.module_.visible.elsewhere) in
  let gathering = List.filter (fun (m : Visible.of_library) -> m.gathers) all in
  match if gathering = [] then all else gathering with
  | [] -> None
  | modules ->
      let import (m : Visible.of_library) = Printf.sprintf "import %s" m.module_ in
      Some { imports = List.map import modules; listed = incomplete_import t; unknown = t }

(* The import with these names added to its list. *)
let with_names (import : Syntax.Ir.import) names =
  let item name =
    if Character.is_lower name.[0] || Character.is_upper name.[0] then name else "(" ^ name ^ ")"
  in
  let items = Option.value import.items ~default:[] in
  let listed = List.map (fun (name : Syntax.Ir.name) -> name.text) items in
  Printf.sprintf "import %s%s (%s)" import.module_.text
    (match import.alias with Some alias -> " as " ^ alias.text | None -> "")
    (String.concat ", " (List.map item (listed @ names)))

let diagnostic program first others =
  let name absent = absent.unknown.name.text in
  let names =
    List.map name (first :: others)
    |> List.fold_left (fun all n -> if List.mem n all then all else n :: all) []
    |> List.rev
  in
  let quoted = List.map (Printf.sprintf "`%s`") names in
  let d = Unknown.diagnostic first.unknown in
  match first.listed with
  | Some import ->
      let text = with_names import names in
      Diagnostic.label ~at:import.span "this list lacks %s" (Enumeration.all quoted) d
      |> Diagnostic.hint "write `%s`" text |> Diagnostic.write import.span text
  | None ->
      Diagnostic.hint "%s %s in the library: %s" (Enumeration.all quoted)
        (if List.compare_length_with names 1 = 0 then "is" else "are")
        (String.concat " or " (List.map (Printf.sprintf "`%s`") first.imports))
        d
      |> List.fold_right (add program) (List.rev first.imports)

let missing program absent =
  let by_place a b = Span.compare a.unknown.name.span b.unknown.name.span in
  let rec diagnostics = function
    | [] -> []
    | first :: rest ->
        let likewise, rest =
          List.partition (fun a -> a.imports = first.imports && a.listed = first.listed) rest
        in
        diagnostic program first likewise :: diagnostics rest
  in
  diagnostics (List.sort by_place absent)
