open Basis
open Interface

type import = {
  module_ : string;
  qualifiers : string list;
  unqualified : bool;
  names : Interface.names;
}

type of_library = { module_ : string; names : Interface.names; gathers : bool }

type t = {
  text : string;
  syntax : Syntax.Ir.program;
  module_ : string;
  own : Interface.names;
  imports : import list;
  elsewhere : of_library list Lazy.t;
  records : tycon list String_map.t Lazy.t;
}

let same_global (a : Ir.Global.t) (b : Ir.Global.t) =
  String.equal a.name b.name && String.equal a.module_ b.module_

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

let unqualified t space name = imported t space (fun import -> import.unqualified) name

let is_known t space name =
  String_table.mem (space.table t.own) name || unqualified t space name <> []

let size_named t name =
  if is_known t constructors name then None
  else
    match (String_table.find_opt t.own.tycons name, unqualified t tycons name) with
    | Some alias, _ | None, (_, alias) :: _ -> alias.size
    | None, [] -> None

let names_of table rest = List.rev_append (in_order table) rest

let names t space locals =
  let add names (import : import) =
    if import.unqualified then names_of (space.table import.names) names else names
  in
  List.fold_left add (names_of (space.table t.own) (Lazy.force locals)) t.imports

let is_implied (i : import) = i.qualifiers = [ Labels.qualifier ]

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

let create ~text ~module_ ~own ~imports ~elsewhere ~syntax =
  let records = lazy (records_by_field own imports) in
  { text; syntax; module_; own; imports; elsewhere; records }
