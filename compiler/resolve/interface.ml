open Basis
module String_map = Map.Make (String)
module String_set = Set.Make (String)

type value = {
  global : Ir.Global.t;
  signed : bool;
  class_ : Ir.Global.t option;
  span : Span.t;
}

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
  span : Span.t;
}

type unit_name = { global : Ir.Global.t; span : Span.t }

type class_ = { global : Ir.Global.t; methods : string list; span : Span.t }

type names = {
  values : value String_map.t;
  constructors : constructor String_map.t;
  tycons : tycon String_map.t;
  units : unit_name String_map.t;
  classes : class_ String_map.t;
}

type 'a space = {
  noun : string;
  unknown : string;
  table : names -> 'a String_map.t;
  global : 'a -> Ir.Global.t;
  place : 'a -> Span.t;
}

let values =
  {
    noun = "name";
    unknown = "E0205";
    table = (fun names -> names.values);
    global = (fun (v : value) -> v.global);
    place = (fun (v : value) -> v.span);
  }

let constructors =
  {
    noun = "constructor";
    unknown = "E0206";
    table = (fun names -> names.constructors);
    global = (fun (c : constructor) -> c.global);
    place = (fun (c : constructor) -> c.span);
  }

let tycons =
  {
    noun = "type";
    unknown = "E0207";
    table = (fun names -> names.tycons);
    global = (fun (t : tycon) -> t.global);
    place = (fun (t : tycon) -> t.span);
  }

let units =
  {
    noun = "unit";
    unknown = "E0208";
    table = (fun names -> names.units);
    global = (fun (u : unit_name) -> u.global);
    place = (fun (u : unit_name) -> u.span);
  }

let classes =
  {
    noun = "type class";
    unknown = "E0223";
    table = (fun names -> names.classes);
    global = (fun (c : class_) -> c.global);
    place = (fun (c : class_) -> c.span);
  }

let empty =
  {
    values = String_map.empty;
    constructors = String_map.empty;
    tycons = String_map.empty;
    units = String_map.empty;
    classes = String_map.empty;
  }

let is_operator text =
  match text.[0] with 'a' .. 'z' | 'A' .. 'Z' | '_' -> false | _ -> true

let prelude = "Prelude"

let builtin_types ~file =
  let span = Span.start_of_file file in
  let builtin name ?(unit_arity = 0) type_arity =
    let global : Ir.Global.t = { module_ = prelude; name } in
    let units_optional = unit_arity > 0 in
    (name, { global; unit_arity; units_optional; type_arity; record_fields = []; span })
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
    empty with
    tycons = String_map.of_seq (List.to_seq (builtin_types ~file));
    constructors = String_map.of_seq (List.to_seq [ truth "False"; truth "True" ]);
    classes = String_map.of_seq (List.to_seq (List.map class_ builtin_class_names));
  }

(* Adds to one name space, unless the name is taken. *)
let add context space ?(hint = Fun.id) table (name : Syntax.Ir.name) entry =
  match String_map.find_opt name.text table with
  | None -> String_map.add name.text entry table
  | Some earlier ->
      Diagnostic.error ~code:"E0211" ~at:name.span "the %s `%s` is defined twice" space.noun
        name.text
      |> Diagnostic.label ~at:(space.place earlier) "first defined here"
      |> hint |> Context.emit context;
      table

let signed_names declarations =
  let add names (d : Syntax.Ir.declaration) =
    match d.desc with
    | Signature { names = signed; _ } ->
        List.fold_left
          (fun names (n : Syntax.Ir.name) -> String_set.add n.text names)
          names signed
    | Binding _ | Type_alias _ | Data _ | Base_unit _ | Scaled_unit _ | Class _ | Instance _
    | Primitive _ | Foreign _ ->
        names
  in
  List.fold_left add String_set.empty declarations

let field_names : Syntax.Ir.fields -> string list option = function
  | Positional _ -> None
  | Named fields ->
      Some (Long_list.map (fun ((f : Syntax.Ir.name), _) -> f.text) fields)

let arity : Syntax.Ir.fields -> int = function
  | Positional fields -> List.length fields
  | Named fields -> List.length fields

(* `type Double[u] = Float[u]` stands without brackets where `Float` does. *)
let names_a_number (parameters : Syntax.Ir.type_parameters) (body : Syntax.Ir.ty) =
  match (parameters, body.desc) with
  | ( { units = [ u ]; types = [] },
      Type { name; units = Some [ { desc = Unit_name v; _ } ]; arguments = [] } ) ->
      String.equal u.text v.text && List.mem name.name.text [ "Float"; "Int" ]
  | _ -> false

let method_names members =
  let names (d : Syntax.Ir.declaration) =
    match d.desc with
    | Signature { names; _ } -> names
    | Binding _ | Type_alias _ | Data _ | Base_unit _ | Scaled_unit _ | Class _ | Instance _
    | Primitive _ | Foreign _ ->
        []
  in
  List.concat_map names members

let declared context ~module_ (program : Syntax.Ir.program) =
  let signed = signed_names program.declarations in
  let global name : Ir.Global.t = { module_; name } in
  let value ?hint ?class_ names (name : Syntax.Ir.name) ~signed =
    let entry : value = { global = global name.text; signed; class_; span = name.span } in
    { names with values = add context values ?hint names.values name entry }
  in
  let tycon names ?(units_optional = false) (name : Syntax.Ir.name)
      (parameters : Syntax.Ir.type_parameters) record_fields =
    let entry =
      {
        global = global name.text;
        unit_arity = List.length parameters.units;
        units_optional;
        type_arity = List.length parameters.types;
        record_fields;
        span = name.span;
      }
    in
    { names with tycons = add context tycons names.tycons name entry }
  in
  let constructor owner names (c : Syntax.Ir.constructor) =
    let entry =
      {
        global = global c.name.text;
        tycon = owner;
        arity = arity c.fields;
        fields = field_names c.fields;
        span = c.name.span;
      }
    in
    { names with constructors = add context constructors names.constructors c.name entry }
  in
  let unit_name names (name : Syntax.Ir.name) =
    let entry = { global = global name.text; span = name.span } in
    { names with units = add context units names.units name entry }
  in
  let declaration names (d : Syntax.Ir.declaration) =
    match d.desc with
    | Signature _ -> names
    | Binding { left = Name name; _ } ->
        value names name ~signed:(String_set.mem name.text signed)
    | Binding { left = Function_name { name; _ }; _ } ->
        value names name
          ~hint:(Diagnostic.hint "a function has one clause; distinguish its arguments with `case`")
          ~signed:(String_set.mem name.text signed)
    | Binding { left = Pattern _; _ } -> names
    | Primitive { names = primitives; _ } ->
        List.fold_left (fun names name -> value names name ~signed:true) names primitives
    | Foreign (Foreign_value { name; _ }) -> value names name ~signed:true
    | Foreign (Foreign_type { name; _ }) -> tycon names name { units = []; types = [] } []
    | Foreign (Foreign_include _) -> names
    | Type_alias { name; parameters; body } ->
        tycon names ~units_optional:(names_a_number parameters body) name parameters []
    | Data { name; parameters; constructors } ->
        let fields =
          match constructors with
          | [ { fields; _ } ] -> Option.value (field_names fields) ~default:[]
          | _ -> []
        in
        let names = tycon names name parameters fields in
        List.fold_left (constructor (global name.text)) names constructors
    | Base_unit name | Scaled_unit { name; _ } -> unit_name names name
    | Class { name; members; _ } ->
        let methods = method_names members in
        let texts = Long_list.map (fun (m : Syntax.Ir.name) -> m.text) methods in
        let entry : class_ = { global = global name.text; methods = texts; span = name.span } in
        let names = { names with classes = add context classes names.classes name entry } in
        let class_ = global name.text in
        List.fold_left (fun names m -> value names m ~class_ ~signed:true) names methods
    | Instance _ -> names
  in
  let start = if String.equal module_ prelude then builtin_names ~file:program.file else empty in
  List.fold_left declaration start program.declarations

let select names wanted =
  let named name _ = String_set.mem name wanted in
  let of_type name (c : constructor) =
    named name c || (String_set.mem c.tycon.name wanted && String_map.mem c.tycon.name names.tycons)
  in
  let of_class name (v : value) =
    named name v
    ||
    match v.class_ with
    | Some c -> String_set.mem c.name wanted && String_map.mem c.name names.classes
    | None -> false
  in
  {
    values = String_map.filter of_class names.values;
    constructors = String_map.filter of_type names.constructors;
    tycons = String_map.filter named names.tycons;
    units = String_map.filter named names.units;
    classes = String_map.filter named names.classes;
  }

let mem names name =
  String_map.mem name names.values
  || String_map.mem name names.constructors
  || String_map.mem name names.tycons
  || String_map.mem name names.units
  || String_map.mem name names.classes

let union a b =
  let first _ x _ = Some x in
  {
    values = String_map.union first a.values b.values;
    constructors = String_map.union first a.constructors b.constructors;
    tycons = String_map.union first a.tycons b.tycons;
    units = String_map.union first a.units b.units;
    classes = String_map.union first a.classes b.classes;
  }

let all names =
  let add table rest = String_map.fold (fun name _ rest -> name :: rest) table rest in
  add names.values (add names.constructors (add names.tycons (add names.units (add names.classes []))))
