open Basis

type t = {
  sink : Diagnostic.sink;
  mutable next_local : int;
  mutable depth : int;
  mutable too_deep : bool;  (** has E0106 been reported? *)
  mutable suggestions : int;  (** number of names for which suggestions will still be computed *)
  mutable absent : absent list;  (** newest first *)
  mutable unknown : Diagnostic.t list;  (** diagnostics about unknown names, newest first *)
}

and absent = {
  imports : string list;
  listed : Syntax.Ir.import option;
  code : string;
  noun : string;
  name : Syntax.Ir.name;
}

let create sink =
  {
    sink;
    next_local = 0;
    depth = 0;
    too_deep = false;
    suggestions = 100;
    absent = [];
    unknown = [];
  }

(* Is this a diagnostic about an unknown name? Such diagnostics are merged over all places of the
   name. *)
let is_of_unknown (d : Diagnostic.t) =
  List.mem d.code [ "E0205"; "E0206"; "E0207"; "E0208"; "E0215" ]

let emit t diagnostic =
  if is_of_unknown diagnostic then t.unknown <- diagnostic :: t.unknown
  else Diagnostic.emit t.sink diagnostic

let holds_many t = List.compare_length_with t.unknown 1_000 >= 0
let is_told t is_it = List.exists is_it t.unknown

let fresh t name span : Ir.Local.t =
  let id = t.next_local in
  t.next_local <- id + 1;
  { id; name; span }

let deepest = 10_000

let nested t span ~otherwise f =
  if t.depth >= deepest then (
    if not t.too_deep then (
      t.too_deep <- true;
      Diagnostic.error ~code:"E0106" ~at:span "this is nested more than %d levels deep" deepest
      |> Diagnostic.hint "define the inner parts under their own names"
      |> emit t);
    otherwise)
  else (
    t.depth <- t.depth + 1;
    let result = f () in
    t.depth <- t.depth - 1;
    result)

let suggest t name candidates diagnostic =
  if t.suggestions = 0 then diagnostic
  else (
    t.suggestions <- t.suggestions - 1;
    match Suggest.closest name (Lazy.force candidates) with
    | Some near ->
        Diagnostic.hint (Printf.sprintf "did you mean `%s`?" near) diagnostic
        |> Diagnostic.write diagnostic.Diagnostic.at near
    | None -> diagnostic)

let not_imported t absent = t.absent <- absent :: t.absent

(* A separate line, below the existing imports. *)
let import_place (program : Syntax.Ir.program) : Ir.import_place =
  let below (span : Span.t) = Span.make ~file:span.file ~start:span.stop ~stop:span.stop in
  match (List.rev program.imports, program.header) with
  | last :: _, _ -> { place = below last.span; before = "\n"; after = "" }
  | [], Some header -> { place = below header.span; before = "\n\n"; after = "" }
  | [], None -> { place = Span.start_of_file program.file; before = ""; after = "\n\n" }

let add_import program declaration =
  let { Ir.place; before; after } = import_place program in
  Diagnostic.fix (Printf.sprintf "add `%s`" declaration) [ (place, before ^ declaration ^ after) ]

(* The import with these names added to its list. *)
let with_names (import : Syntax.Ir.import) names =
  let item name =
    if Character.is_lower name.[0] || Character.is_upper name.[0] then name else "(" ^ name ^ ")"
  in
  let listed = List.map (fun (name : Syntax.Ir.name) -> name.text) (Option.get import.items) in
  Printf.sprintf "import %s%s (%s)" import.module_.text
    (match import.alias with Some alias -> " as " ^ alias.text | None -> "")
    (String.concat ", " (List.map item (listed @ names)))

(* Reports each missing import once, with all the names that need it. *)
let tell_imports t program =
  let by_place a b = Span.compare a.name.span b.name.span in
  let rec tell = function
    | [] -> ()
    | ({ imports; listed; code; noun; name } as first) :: rest ->
        let likewise, rest =
          List.partition (fun a -> a.imports = imports && a.listed = listed) rest
        in
        let names =
          List.map (fun a -> a.name.text) (first :: likewise)
          |> List.fold_left (fun all n -> if List.mem n all then all else n :: all) []
          |> List.rev
        in
        let quoted = List.map (Printf.sprintf "`%s`") names in
        let d = Diagnostic.error ~code ~at:name.span "unknown %s `%s`" noun name.text in
        (match listed with
        | Some import ->
            let text = with_names import names in
            Diagnostic.label ~at:import.span
              (Printf.sprintf "this list lacks %s" (Enumeration.all quoted))
              d
            |> Diagnostic.hint (Printf.sprintf "write `%s`" text)
            |> Diagnostic.write import.span text
        | None ->
            Diagnostic.hint
              (Printf.sprintf "%s %s in the library: %s" (Enumeration.all quoted)
                 (if List.compare_length_with names 1 = 0 then "is" else "are")
                 (String.concat " or " (List.map (Printf.sprintf "`%s`") imports)))
              d
            |> List.fold_right (add_import program) (List.rev imports))
        |> emit t;
        tell rest
  in
  tell (List.sort by_place t.absent);
  t.absent <- []

(* {1 Unknown names} *)

let most_places = 4

(* Merges diagnostics with the same text: shows their places in the first one, and applies its fix
   there too. *)
let also_there (first : Diagnostic.t) (others : Diagnostic.t list) =
  let label d (other : Diagnostic.t) = Diagnostic.label ~at:other.at "and here" d in
  let shown = List.filteri (fun i _ -> i < most_places) others in
  let more = List.length others - List.length shown in
  let everywhere (fix : Diagnostic.fix) =
    let same (other : Diagnostic.fix) = String.equal other.title fix.title in
    let of_other (d : Diagnostic.t) =
      Option.fold (List.find_opt same d.fixes) ~none:[] ~some:(fun (f : Diagnostic.fix) -> f.edits)
    in
    { fix with edits = fix.edits @ List.concat_map of_other others }
  in
  List.fold_left label { first with fixes = List.map everywhere first.fixes } shown
  |> if more = 0 then Fun.id else Diagnostic.note (Printf.sprintf "and in %d more places" more)

(* Merges the diagnostics of an unknown name and an unknown constructor next to each other. Both
   probably come from the same library. *)
let rec neighbours : Diagnostic.t list -> Diagnostic.t list = function
  | a :: b :: rest
    when a.code <> b.code
         && Span.line a.at.start = Span.line b.at.start
         && List.for_all
              (fun (d : Diagnostic.t) ->
                List.mem d.code [ "E0205"; "E0206" ] && d.hints = [] && d.notes = [])
              [ a; b ] ->
      (Diagnostic.label ~at:b.at b.message a
      |> Diagnostic.hint "define both, or `import` the module that defines them")
      :: neighbours rest
  | d :: rest -> d :: neighbours rest
  | [] -> []

let tell_unknown t =
  let by_place (a : Diagnostic.t) (b : Diagnostic.t) = Span.compare a.at b.at in
  let told = Hashtbl.create 16 in
  (* the hint for an unknown unit may contain the number before it *)
  let key (d : Diagnostic.t) =
    (d.code, d.message, (if String.equal d.code "E0208" then [] else d.hints), d.notes)
  in
  let all = List.sort_uniq by_place t.unknown in
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
  List.iter (Diagnostic.emit t.sink) (neighbours (List.filter_map once all));
  t.unknown <- []

let tell t program =
  tell_imports t program;
  tell_unknown t
