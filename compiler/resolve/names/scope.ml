open Basis
open Interface

type import = {
  module_ : string;
  qualifiers : string list;
  unqualified : bool;
  names : Interface.names;
  span : Span.t;
}

type of_library = { module_ : string; names : Interface.names; gathers : bool }

type t = {
  context : Context.t;
  text : string;
  syntax : Syntax.Ir.program;
  module_ : string;
  library : bool;
  own : Interface.names;
  imports : import list;
  complete : bool;
  elsewhere : of_library list Lazy.t;
  used : unit String_table.t;
  records : tycon list String_map.t Lazy.t;
  records_of : Ir.Global.t list String_map.t Lazy.t;
  signals : Proc_signals.t list Lazy.t;
  c_declarations : Proc_signals.c_declaration list Lazy.t;
  in_capitals : string list Lazy.t;
  params : Syntax.Ir.name list Lazy.t;
  without_definition : string list Lazy.t;
}

let same_global (a : Ir.Global.t) (b : Ir.Global.t) =
  String.equal a.name b.name && String.equal a.module_ b.module_

(* The distinct meanings that a name has through the imports that satisfy [visible]. *)
let imported t space visible name =
  let add found (import : import) =
    if not (visible import) then found
    else
      match String_table.find_opt (space.table import.names) name with
      | None -> found
      | Some entry ->
          let same (_, other) = same_global (space.global entry) (space.global other) in
          if List.exists same found then found else (import, entry) :: found
  in
  List.rev (List.fold_left add [] t.imports)

let report_ambiguous t space (name : Syntax.Ir.name) (candidates : (import * _) list) =
  let place diagnostic ((import : import), entry) =
    let text = Printf.sprintf "the one in `%s`" import.module_ in
    let at = space.place entry in
    Diagnostic.label ~at text diagnostic
  in
  let qualified ((import : import), _) =
    Printf.sprintf "%s.%s"
      (match import.qualifiers with q :: _ -> q | [] -> import.module_)
      name.text
  in
  let qualified = List.map qualified candidates in
  List.fold_left place
    (Diagnostic.error ~code:"E0210" ~at:name.span "the %s `%s` is ambiguous" space.noun name.text)
    candidates
  |> Diagnostic.hint ("write " ^ String.concat " or " (List.map (Printf.sprintf "`%s`") qualified))
  |> List.fold_right (Diagnostic.write name.span) (List.rev qualified)
  |> Context.emit t.context

let choose t space (name : Syntax.Ir.name) = function
  | [] -> None
  | (_, entry) :: others as candidates ->
      if others <> [] then report_ambiguous t space name candidates;
      String_table.replace t.used name.text ();
      Some entry

let look t space (name : Syntax.Ir.name) =
  match String_table.find_opt (space.table t.own) name.text with
  | Some entry -> Some entry
  | None -> choose t space name (imported t space (fun import -> import.unqualified) name.text)

let is_known t space name =
  String_table.mem (space.table t.own) name
  || imported t space (fun import -> import.unqualified) name <> []

let names_of table rest = List.rev_append (in_order table) rest

let visible_names t space locals =
  let add names (import : import) =
    if import.unqualified then names_of (space.table import.names) names else names
  in
  List.fold_left add (names_of (space.table t.own) (Lazy.force locals)) t.imports

(* Is this the import that the tests of the module imply? *)
let is_implied (i : import) = i.qualifiers = [ Labels.qualifier ]

let size_named t (name : Syntax.Ir.name) =
  if is_known t constructors name.text || not (is_known t tycons name.text) then None
  else Option.bind (look t tycons name) (fun (alias : tycon) -> alias.size)

let use_records t records =
  List.iter (fun (g : Ir.Global.t) -> String_table.replace t.used g.name ()) records;
  records

let records_with t fields =
  use_records t
  @@
  match fields with
  | [] -> []
  | [ field ] -> Option.value (String_map.find_opt field (Lazy.force t.records_of)) ~default:[]
  | field :: others ->
      let records = Option.value (String_map.find_opt field (Lazy.force t.records)) ~default:[] in
      let complete (record : tycon) =
        let has = String_table.create 16 in
        List.iter (fun field -> String_table.replace has field ()) record.record_fields;
        List.for_all (String_table.mem has) others
      in
      List.filter_map
        (fun (record : tycon) -> if complete record then Some record.global else None)
        records

let compare_records (a : tycon) (b : tycon) =
  match String.compare a.global.name b.global.name with
  | 0 -> String.compare a.global.module_ b.global.module_
  | order -> order

let records_by_field own (imports : import list) =
  let add_record (record : tycon) fields =
    let add fields field =
      let add records = Some (record :: Option.value records ~default:[]) in
      String_map.update field add fields
    in
    List.fold_left add fields record.record_fields
  in
  let add fields names =
    String_table.fold (fun _ record fields -> add_record record fields) names.tycons fields
  in
  let all =
    List.fold_left (fun fields (i : import) -> add fields i.names) String_map.empty imports
  in
  String_map.map (List.sort_uniq compare_records) (add all own)

let create context ~text ~module_ ~library ~own ~imports ~complete ~elsewhere ~syntax =
  let records = lazy (records_by_field own imports) in
  let names = Long_list.map (fun (record : tycon) -> record.global) in
  let records_of = lazy (String_map.map names (Lazy.force records)) in
  let used = String_table.create 16 in
  {
    context;
    text;
    syntax;
    module_;
    library;
    own;
    imports;
    complete;
    elsewhere;
    used;
    records;
    records_of;
    signals = lazy (Proc_signals.of_module syntax);
    c_declarations = lazy (Proc_signals.c_declarations syntax);
    in_capitals = lazy (Proc_signals.in_capitals syntax);
    params = lazy (Proc_signals.params syntax);
    without_definition = lazy (Proc_signals.without_definition syntax);
  }
