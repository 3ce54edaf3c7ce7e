open Basis
module Ir = Typing.Ir
module Types = Probe.Signal_types

type t = {
  sink : Diagnostic.sink;
  resolved : Resolve.Ir.program;
  typed : Ir.program;
  types : Types.t;
  entry : Ir.definition;
}

let in_ros name : Ir.Global.t = { module_ = "Ros"; name }
let in_prelude name : Ir.Global.t = { module_ = "Prelude"; name }

let instance c class_ tycon =
  List.find_opt
    (fun (i : Ir.instance) ->
      i.class_ = in_ros class_ && match i.head with Data d -> d.tycon = tycon | _ -> false)
    c.typed.instances

let method_ c (i : Ir.instance) =
  match i.methods with
  | [ (_, Given name) ] -> (
      let is_it (d : Ir.definition) = d.name = name in
      match List.find_opt is_it c.typed.definitions with
      | Some { value = { desc = Lambda ([ parameter ], body); _ }; _ } -> Some (parameter, body)
      | Some _ | None -> None)
  | _ -> None

let data c tycon = List.find_opt (fun (d : Ir.data) -> d.tycon = tycon) c.typed.data

let fields c tycon =
  match data c tycon with
  | Some { constructors = [ { record = true; fields; _ } ]; _ } -> Some (List.map fst fields)
  | Some _ | None -> None

let declared c tycon field =
  let of_declaration (d : Resolve.Ir.type_declaration) =
    match d.definition with
    | Data [ only ] when d.tycon = tycon ->
        List.find_opt (fun (f : Resolve.Ir.field) -> f.field_name = field) only.fields
    | Data _ | Alias _ | Builtin | Foreign _ -> None
  in
  List.find_map of_declaration c.resolved.types

let place c tycon field =
  Option.fold (declared c tycon field) ~none:c.entry.span ~some:(fun (f : Resolve.Ir.field) ->
      f.ty.span)

let name_place c tycon field =
  Option.fold (declared c tycon field) ~none:c.entry.span ~some:(fun (f : Resolve.Ir.field) ->
      f.span)

let refuse c ?(code = "E0509") ~at text hint =
  Diagnostic.error ~code ~at "%s" text |> Diagnostic.hint "%s" hint |> Diagnostic.emit c.sink
