open Basis
module Global_table = Resolve.Global_table

type data = { declaration : Ir.data; count : int }

type t = {
  mutable last : int;
  data : data Global_table.t;
  instances : Instance.table;
  foreign : Primitive.foreign Global_table.t;
  mutable newest_first : Ir.definition list;
}

let create data instances (foreign : Ir.foreign) =
  let table = Global_table.create 64 in
  let add (d : Ir.data) =
    Global_table.replace table d.tycon { declaration = d; count = List.length d.constructors }
  in
  List.iter add data;
  let values = Global_table.create 8 in
  let add_value ((f : Primitive.foreign), _) =
    Global_table.replace values { Ir.Global.module_ = f.module_; name = f.foreign_name } f
  in
  List.iter add_value foreign.values;
  let instances = Instance.table instances in
  { last = 0; data = table; instances; foreign = values; newest_first = [] }

let primitive t (g : Ir.Global.t) : Primitive.t =
  match (Global_table.find_opt t.foreign g, Primitive_table.of_name g.name) with
  | Some foreign, _ -> Foreign foreign
  | None, Some p -> p
  | None, None ->
      Diagnostic.bug ~stage:"Core.Context" "the library declares an unknown primitive `%s`" g.name

let fresh t name span : Ir.Local.t =
  t.last <- t.last - 1;
  { id = t.last; name; span }

let define t definition = t.newest_first <- definition :: t.newest_first
let definitions t = List.rev t.newest_first
let instances t = t.instances

let data t (tycon : Ir.Global.t) =
  match Global_table.find_opt t.data tycon with
  | Some d -> d
  | None ->
      Diagnostic.bug ~stage:"Core.Context" "`%s.%s` is not a data type" tycon.module_ tycon.name

let constructors t tycon = (data t tycon).count

let field_types t (ty : Ir.ty) ~constructor =
  match ty with
  | Data (tycon, arguments) ->
      let d = (data t tycon).declaration in
      let by = List.combine d.parameters arguments in
      List.map
        (fun (_, field) -> Erasure.substitute by field)
        (List.nth d.constructors constructor).fields
  | Variable _ | Bool | Int | Float | String | Tuple _ | Function _ | Signal_function _ | Array _
  | Size _ ->
      Diagnostic.bug ~stage:"Core.Context" "a type that is not a data type has no fields"
