open Basis
open Resolve

type found = {
  suggestions : Suggestion.t;
  module_ : Module_syntax.t;
  mutable count : int;
  mutable diagnostics : Diagnostic.t list;  (** newest first *)
  mutable absent : Imports.absent list;
  mutable class_lines : int list;  (** lines where classes are used as types *)
}

(* {1 One name} *)

let add found diagnostic =
  found.count <- found.count + 1;
  found.diagnostics <- diagnostic :: found.diagnostics

let add_class found (name : Syntax.Ir.name) =
  let line = Span.line name.span.start in
  if not (List.mem line found.class_lines) then (
    found.class_lines <- line :: found.class_lines;
    add found (Unknown_name.class_as_type name))

(* Number of errors after which the rest are reported without advice. Finding advice takes time, and
   no user reads that much of it. *)
let most_advice = 1_000

let add_unknown found unknown =
  if found.count >= most_advice then add found (Unknown.diagnostic unknown)
  else
    match Unknown_name.outcome found.suggestions unknown with
    | Report diagnostic -> add found diagnostic
    | Import absent -> found.absent <- absent :: found.absent
    | Class_as_type -> add_class found unknown.name
    | Silent -> ()

let add_name found (fact : Fact.unresolved) =
  let suggestions = found.suggestions and visible = found.module_.visible in
  match fact with
  | Unknown { space; name; locals; around } ->
      add_unknown found (Unknown.create found.module_ space name ~locals ~around)
  | Unknown_qualifier { qualifier; name } ->
      add found (Qualified_name.unknown_qualifier suggestions visible qualifier name)
  | Unknown_in_module { space = Any space; qualifier; name; known } ->
      add found
        (Qualified_name.unknown_in_module suggestions space.namespace ~qualifier ~known name)
  | Variable_for_unit name -> add found (Unknown_unit.of_variable visible name)
  | Size_as_value { size; name } -> add found (Misused.size size name)
  | Unit_of_a_value { head; unit_; at } -> add found (Misused.unit_of_a_value ~head ~unit_ ~at)
  | Unit_apart { head; unit_; at } -> add found (Misused.unit_apart ~head ~unit_ ~at)
  | Field_as_function { whole; field; record } -> add found (Misused.field ~whole ~field ~record)
  | Not_exported { name; module_; known } ->
      add found (Qualified_name.absent suggestions ~module_ ~known ~to_:"export" name)
  | Not_in_import { name; module_; known } ->
      add found (Qualified_name.absent suggestions ~module_ ~known ~to_:"import" name)

(* {1 All occurrences of a name} *)

let most_places = 4

(* Merges diagnostics with the same wording: the first one also shows the places of the others, and
   its fix includes their edits. *)
let also_there (first : Diagnostic.t) (others : Diagnostic.t list) =
  let label d (other : Diagnostic.t) = Diagnostic.label ~at:other.at "and here" d in
  let shown = List.filteri (fun i _ -> i < most_places) others in
  let more = List.length others - List.length shown in
  let everywhere (fix : Diagnostic.fix) =
    let of_other (d : Diagnostic.t) =
      Option.fold
        (List.find_opt (Diagnostic.has_same_effect fix) d.fixes)
        ~none:[]
        ~some:(fun (f : Diagnostic.fix) -> f.edits)
    in
    { fix with edits = fix.edits @ List.concat_map of_other others }
  in
  List.fold_left label { first with fixes = List.map everywhere first.fixes } shown
  |>
  if more = 0 then Fun.id
  else Diagnostic.note "and in %d more place%s" more (if more = 1 then "" else "s")

let is_of code (d : Diagnostic.t) = String.equal d.code code

(* Merges consecutive diagnostics on the same line if one is about an unknown name and the other
   about an unknown constructor, because both probably come from the same library. *)
let rec neighbours : Diagnostic.t list -> Diagnostic.t list = function
  | a :: b :: rest
    when a.code <> b.code
         && Span.line a.at.start = Span.line b.at.start
         && List.for_all
              (fun (d : Diagnostic.t) ->
                (is_of "E0205" d || is_of "E0206" d) && d.hints = [] && d.notes = [])
              [ a; b ] ->
      ({ a with labels = a.labels @ [ { at = b.at; text = b.message } ] }
      |> Diagnostic.hint "define both, or `import` the module that defines them")
      :: neighbours rest
  | d :: rest -> d :: neighbours rest
  | [] -> []

let merged diagnostics =
  let by_place (a : Diagnostic.t) (b : Diagnostic.t) = Span.compare a.at b.at in
  let told = Hashtbl.create 16 in
  (* the hint for an unknown unit may contain the number before the unit *)
  let key d = Diagnostic.wording ~without_hints:(is_of (Namespace.unknown Units) d) d in
  let all = List.sort_uniq by_place diagnostics in
  let add d =
    match Hashtbl.find_opt told (key d) with
    | Some later -> later := d :: !later
    | None -> Hashtbl.replace told (key d) (ref [ d ])
  in
  List.iter add (List.rev all);
  let once d =
    match !(Hashtbl.find told (key d)) with
    | first :: others when first == d -> Some (also_there first others)
    | _ -> None
  in
  neighbours (List.filter_map once all)

let diagnostics suggestions (visible : Visible.t) names =
  let found =
    {
      suggestions;
      module_ = Module_syntax.create visible;
      count = 0;
      diagnostics = [];
      absent = [];
      class_lines = [];
    }
  in
  List.iter (add_name found) names;
  List.iter (add found) (Imports.missing visible.syntax found.absent);
  let classes, others = List.partition (is_of (Namespace.unknown Classes)) found.diagnostics in
  List.rev classes @ merged others
