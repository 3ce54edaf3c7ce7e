open Basis
module Global_table = Resolve.Global_table

type unit_ = { measure : Units.t; scale : Exact.t }
type parameters = { units : Units.rigid list; types : Type.rigid list }
type definition = Alias of Type.t | Data of Ir.data | Builtin | Foreign
type type_ = { parameters : parameters; definition : definition }
type class_ = { superclasses : Ir.class_ list; place : Span.t }
type instance = { context : (Ir.class_ * int) list; place : Span.t }

type constructor = {
  ir : Ir.constructor;
  tycon : Ir.Global.t;
  scheme : Type.scheme;
  positions : int String_table.t Lazy.t;
  own_types : Type.t array option Lazy.t;
}

let positions (ir : Ir.constructor) =
  let table = String_table.create 16 in
  List.iteri
    (fun i (field, _) -> if not (String_table.mem table field) then String_table.add table field i)
    ir.fields;
  table

let parameters count ty =
  let rec split fields count ty =
    match (count, Type.expand ty) with
    | 0, _ -> Some (List.rev fields, ty)
    | _, Type.Function (field, rest) -> split (field :: fields) (count - 1) rest
    | _, _ -> None
  in
  split [] count ty

let own_types (ir : Ir.constructor) (scheme : Type.scheme) =
  match scheme with
  | { types = []; representations = []; units = []; context = []; body } ->
      Option.map (fun (fields, _) -> Array.of_list fields) (parameters (List.length ir.fields) body)
  | _ -> None

let make_constructor ir ~tycon scheme =
  { ir; tycon; scheme; positions = lazy (positions ir); own_types = lazy (own_types ir scheme) }

let own_type constructor index =
  Option.map (fun types -> types.(index)) (Lazy.force constructor.own_types)

let position constructor field = String_table.find_opt (Lazy.force constructor.positions) field

type t = {
  units : unit_ Global_table.t;
  named : (Ir.unit_, string) Hashtbl.t;
  types : type_ Global_table.t;
  constructors : constructor Global_table.t;
  classes : class_ Global_table.t;
  instances : (Ir.Global.t * Head.t, instance) Hashtbl.t;
}

let create () =
  {
    units = Global_table.create 64;
    named = Hashtbl.create 16;
    types = Global_table.create 64;
    constructors = Global_table.create 64;
    classes = Global_table.create 16;
    instances = Hashtbl.create 64;
  }

let found what table (name : Ir.Global.t) =
  match Global_table.find_opt table name with
  | Some entry -> entry
  | None -> Diagnostic.bug ~stage:"Typing.Environment" "no %s %s.%s" what name.module_ name.name

let add_unit t (name : Ir.Global.t) unit_ =
  Global_table.replace t.units name unit_;
  let measure = Units.to_ir unit_.measure in
  if
    Exact.equal unit_.scale Exact.one
    && List.length measure.base >= 3
    && not (Hashtbl.mem t.named measure)
  then Hashtbl.replace t.named measure name.name

let unit_ t name = found "unit" t.units name

let named_unit t measure =
  if Units.is_open measure then None else Hashtbl.find_opt t.named (Units.to_ir measure)

let add_type t name type_ = Global_table.replace t.types name type_
let type_ t name = found "type" t.types name
let built_in name : Ir.Global.t = { module_ = "Prelude"; name }
let array = built_in "Array"

let array_of size element : Type.t =
  Data { tycon = array; units = []; arguments = [ size; element ] }

let task = built_in "Task"

let task_of input output result : Type.t =
  Data { tycon = task; units = []; arguments = [ input; output; result ] }

let as_task t =
  match Type.expand t with
  | Data { tycon; arguments = [ input; output; result ]; _ } when tycon = task ->
      Some (input, output, result)
  | _ -> None

let is_task t = as_task t <> None

let is_event t =
  match Type.expand t with Data { tycon; _ } -> tycon = built_in "Event" | _ -> false

let sequence = built_in "do"
let add_constructor t c = Global_table.replace t.constructors c.ir.constructor c
let constructor t name = found "constructor" t.constructors name
let add_class t name c = Global_table.replace t.classes name c
let class_ t name = found "class" t.classes name

let superclasses t : Ir.class_ -> Ir.class_ list = function
  | Eq -> []
  | Ord -> [ Eq ]
  | Declared c -> (class_ t c).superclasses

let add_instance t class_ head i = Hashtbl.replace t.instances (class_, head) i
let instance t class_ head = Hashtbl.find_opt t.instances (class_, head)

let heads t class_ =
  let add (c, head) _ found = if c = class_ then head :: found else found in
  List.sort compare (Hashtbl.fold add t.instances [])

let record_of t tycon =
  match (type_ t tycon).definition with
  | Data { constructors = [ { record = true; constructor = name; _ } ]; _ } ->
      Some (constructor t name)
  | Data _ | Alias _ | Builtin | Foreign -> None

let field_names t =
  let of_constructor _ c names = List.rev_append (List.rev_map fst c.ir.fields) names in
  List.sort_uniq String.compare (Global_table.fold of_constructor t.constructors [])

let fields constructor ty =
  match parameters (List.length constructor.ir.fields) ty with
  | Some split -> split
  | None ->
      Diagnostic.bug ~stage:"Typing.Environment" "constructor %s has too few fields"
        constructor.ir.constructor.name
