open Basis
module String_map = Map.Make (String)
module String_set = Set.Make (String)

type value = { global : Ir.Global.t; signed : bool; class_ : Ir.Global.t option; span : Span.t }

type constructor = {
  global : Ir.Global.t;
  tycon : Ir.Global.t;
  arity : int;
  fields : string list option;
  span : Span.t;
}

type tycon = {
  global : Ir.Global.t;
  unit_arity : int;
  units_optional : bool;
  type_arity : int;
  record_fields : string list;
  size : int option;
  span : Span.t;
}

type unit_name = { global : Ir.Global.t; span : Span.t }
type class_ = { global : Ir.Global.t; methods : string list; span : Span.t }

type names = {
  values : value String_table.t;
  constructors : constructor String_table.t;
  tycons : tycon String_table.t;
  units : unit_name String_table.t;
  classes : class_ String_table.t;
}

type namespace = Values | Constructors | Types | Units | Classes

type 'a space = {
  namespace : namespace;
  table : names -> 'a String_table.t;
  global : 'a -> Ir.Global.t;
  place : 'a -> Span.t;
}

let values =
  {
    namespace = Values;
    table = (fun names -> names.values);
    global = (fun (v : value) -> v.global);
    place = (fun (v : value) -> v.span);
  }

let constructors =
  {
    namespace = Constructors;
    table = (fun names -> names.constructors);
    global = (fun (c : constructor) -> c.global);
    place = (fun (c : constructor) -> c.span);
  }

let tycons =
  {
    namespace = Types;
    table = (fun names -> names.tycons);
    global = (fun (t : tycon) -> t.global);
    place = (fun (t : tycon) -> t.span);
  }

let units =
  {
    namespace = Units;
    table = (fun names -> names.units);
    global = (fun (u : unit_name) -> u.global);
    place = (fun (u : unit_name) -> u.span);
  }

let classes =
  {
    namespace = Classes;
    table = (fun names -> names.classes);
    global = (fun (c : class_) -> c.global);
    place = (fun (c : class_) -> c.span);
  }

type any_space = Any : 'a space -> any_space

let none () =
  {
    values = String_table.create 16;
    constructors = String_table.create 16;
    tycons = String_table.create 16;
    units = String_table.create 16;
    classes = String_table.create 16;
  }

let is_operator text = match text.[0] with 'a' .. 'z' | 'A' .. 'Z' | '_' -> false | _ -> true
let prelude = "Prelude"

let builtin_types ~file =
  let span = Span.start_of_file file in
  let builtin name ?(unit_arity = 0) type_arity =
    let global : Ir.Global.t = { module_ = prelude; name } in
    let units_optional = unit_arity > 0 in
    (name, { global; unit_arity; units_optional; type_arity; record_fields = []; size = None; span })
  in
  [
    builtin "Bool" 0;
    builtin "Int" ~unit_arity:1 0;
    builtin "Float" ~unit_arity:1 0;
    builtin "String" 0;
    builtin "Array" 2;
    builtin "SF" 2;
    builtin "Program" 2;
    builtin "Task" 3;
  ]

let is_builtin (t : tycon) =
  String.equal t.global.module_ prelude
  && List.mem t.global.name [ "Bool"; "Int"; "Float"; "String"; "Array"; "SF"; "Program"; "Task" ]

let builtin_class_names = [ "Eq"; "Ord" ]

let is_builtin_class (c : class_) =
  String.equal c.global.module_ prelude && List.mem c.global.name builtin_class_names

let builtin_names ~file =
  let span = Span.start_of_file file in
  let truth name =
    let global : Ir.Global.t = { module_ = prelude; name } in
    let tycon : Ir.Global.t = { module_ = prelude; name = "Bool" } in
    (name, { global; tycon; arity = 0; fields = None; span })
  in
  let class_ name : string * class_ =
    (name, { global = { module_ = prelude; name }; methods = []; span })
  in
  {
    (none ()) with
    tycons = String_table.of_seq (List.to_seq (builtin_types ~file));
    constructors = String_table.of_seq (List.to_seq [ truth "False"; truth "True" ]);
    classes = String_table.of_seq (List.to_seq (List.map class_ builtin_class_names));
  }

let size_operation (operator : Syntax.Ir.size_operator) left right =
  (* larger numbers are not valid sizes; clamping them avoids overflow *)
  let bounded n = max (-0x40000000) (min 0x40000000 n) in
  match operator with
  | Plus_sizes -> bounded (left + right)
  | Minus_sizes -> bounded (left - right)
  | Times_sizes -> bounded (left * right)

let method_names members =
  let names (d : Syntax.Ir.declaration) =
    match d.desc with
    | Signature { names; _ } -> names
    | Binding _ | Type_alias _ | Data _ | Base_unit _ | Scaled_unit _ | Class _ | Instance _
    | Primitive _ | Foreign _ | Parameter _ | Claim _ | Check _ ->
        []
  in
  List.concat_map names members

let filter wanted table =
  let found = String_table.create 16 in
  String_table.iter
    (fun name entry -> if wanted name entry then String_table.add found name entry)
    table;
  found

let select names wanted =
  let named name _ = String_set.mem name wanted in
  let of_type name (c : constructor) =
    named name c
    || (String_set.mem c.tycon.name wanted && String_table.mem names.tycons c.tycon.name)
  in
  let of_class name (v : value) =
    named name v
    ||
    match v.class_ with
    | Some c -> String_set.mem c.name wanted && String_table.mem names.classes c.name
    | None -> false
  in
  {
    values = filter of_class names.values;
    constructors = filter of_type names.constructors;
    tycons = filter named names.tycons;
    units = filter named names.units;
    classes = filter named names.classes;
  }

let mem names name =
  String_table.mem names.values name
  || String_table.mem names.constructors name
  || String_table.mem names.tycons name
  || String_table.mem names.units name
  || String_table.mem names.classes name

let union a b =
  let first a b =
    let both = String_table.copy b in
    String_table.iter (String_table.replace both) a;
    both
  in
  {
    values = first a.values b.values;
    constructors = first a.constructors b.constructors;
    tycons = first a.tycons b.tycons;
    units = first a.units b.units;
    classes = first a.classes b.classes;
  }

let in_order table =
  String_table.fold (fun name _ names -> name :: names) table [] |> List.sort String.compare

let all names =
  let add table rest = List.rev_append (in_order table) rest in
  add names.values
    (add names.constructors (add names.tycons (add names.units (add names.classes []))))
