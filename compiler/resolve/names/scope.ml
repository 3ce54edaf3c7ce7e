open Basis
open Interface

type t = {
  context : Context.t;
  visible : Visible.t;
  library : bool;
  complete : bool;
  used : unit String_table.t;
  records_of : Ir.Global.t list String_map.t Lazy.t;
  params : Syntax.Ir.name list Lazy.t;
}

let choose t space (name : Syntax.Ir.name) = function
  | [] -> None
  | (_, entry) :: others as candidates ->
      let candidate ((import : Visible.import), entry) : Fact.candidate =
        let qualifier = match import.qualifiers with q :: _ -> q | [] -> import.module_ in
        { module_ = import.module_; qualifier; place = space.place entry }
      in
      if others <> [] then
        Context.report_definition t.context
          (Ambiguous
             { namespace = space.namespace; name; candidates = List.map candidate candidates });
      String_table.replace t.used name.text ();
      Some entry

let look t space (name : Syntax.Ir.name) =
  match String_table.find_opt (space.table t.visible.own) name.text with
  | Some entry -> Some entry
  | None ->
      choose t space name
        (Visible.imported t.visible space (fun import -> import.unqualified) name.text)

let size_named t (name : Syntax.Ir.name) =
  if Visible.is_known t.visible constructors name.text then None
  else if not (Visible.is_known t.visible tycons name.text) then None
  else Option.bind (look t tycons name) (fun (alias : tycon) -> alias.size)

let use_records t records =
  List.iter (fun (g : Ir.Global.t) -> String_table.replace t.used g.name ()) records;
  records

let records_with t fields =
  let records_of field =
    Option.value (String_map.find_opt field (Lazy.force t.visible.records)) ~default:[]
  in
  use_records t
  @@
  match fields with
  | [] -> []
  | [ field ] -> Option.value (String_map.find_opt field (Lazy.force t.records_of)) ~default:[]
  | field :: others ->
      let complete (record : tycon) =
        let has = String_table.create 16 in
        List.iter (fun field -> String_table.replace has field ()) record.record_fields;
        List.for_all (String_table.mem has) others
      in
      List.filter_map
        (fun (record : tycon) -> if complete record then Some record.global else None)
        (records_of field)

let params (program : Syntax.Ir.program) =
  List.filter_map
    (fun (d : Syntax.Ir.declaration) ->
      match d.desc with Parameter { name; _ } -> Some name | _ -> None)
    program.declarations

let create context ~library ~complete (visible : Visible.t) =
  let names = Long_list.map (fun (record : tycon) -> record.global) in
  {
    context;
    visible;
    library;
    complete;
    used = String_table.create 16;
    records_of = lazy (String_map.map names (Lazy.force visible.records));
    params = lazy (params visible.syntax);
  }
