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

type 'a space = {
  noun : string;
  unknown : string;
  table : names -> 'a String_table.t;
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

(* Adds an entry to one namespace. Reports the name if it is already taken. *)
let add context space ?(hint = Fun.id) names (name : Syntax.Ir.name) entry =
  let table = space.table names in
  match String_table.find_opt table name.text with
  | None -> String_table.add table name.text entry
  | Some earlier ->
      let place = space.place earlier in
      let hint =
        if String.equal place.file name.span.file then hint
        else Diagnostic.hint "a test file shares the names of its program: rename this one"
      in
      Diagnostic.error ~code:"E0211" ~at:name.span "the %s `%s` is defined twice" space.noun
        name.text
      |> Diagnostic.label ~at:place "first defined here"
      |> hint
      |> (fun d -> if d.hints = [] then Diagnostic.hint "remove one of them, or rename it" d else d)
      |> Context.emit context

let signed_names declarations =
  let signed = String_table.create 16 in
  let sign (name : Syntax.Ir.name) = String_table.replace signed name.text () in
  let declaration (d : Syntax.Ir.declaration) =
    match d.desc with
    | Signature { names; _ } -> List.iter sign names
    | Binding _ | Type_alias _ | Data _ | Base_unit _ | Scaled_unit _ | Class _ | Instance _
    | Primitive _ | Foreign _ | Parameter _ | Claim _ | Check _ ->
        ()
  in
  List.iter declaration declarations;
  signed

let field_names : Syntax.Ir.fields -> string list option = function
  | Positional _ -> None
  | Named fields -> Some (Long_list.map (fun ((f : Syntax.Ir.name), _) -> f.text) fields)

let arity : Syntax.Ir.fields -> int = function
  | Positional fields -> List.length fields
  | Named fields -> List.length fields

(* An alias such as `type Double[u] = Float[u]` may be used without brackets, like `Float`. *)
let names_a_number (parameters : Syntax.Ir.type_parameters) (body : Syntax.Ir.ty) =
  match (parameters, body.desc) with
  | ( { units = [ u ]; types = [] },
      Type { name; units = Some [ { desc = Unit_name v; _ } ]; arguments = [] } ) ->
      String.equal u.text v.text && List.mem name.name.text [ "Float"; "Int" ]
  | _ -> false

let size_operation (operator : Syntax.Ir.size_operator) left right =
  (* larger numbers are not sizes, and must not overflow *)
  let bounded n = max (-0x40000000) (min 0x40000000 n) in
  match operator with
  | Plus_sizes -> bounded (left + right)
  | Minus_sizes -> bounded (left - right)
  | Times_sizes -> bounded (left * right)

(* The numbers that the module's own aliases represent, such as `type N = 25` and `type M = N`. *)
let sizes (program : Syntax.Ir.program) =
  let aliases =
    lazy
      (let table = String_table.create 16 in
       let add (d : Syntax.Ir.declaration) =
         match d.desc with
         | Type_alias { name; parameters = { units = []; types = [] }; body } ->
             String_table.replace table name.text body
         | _ -> ()
       in
       List.iter add program.declarations;
       table)
  in
  (* The limit stops the search in a cycle of aliases, which is reported elsewhere. *)
  let rec size limit (t : Syntax.Ir.ty) =
    match t.desc with
    | Size n -> Some n
    | Type { name = { qualifier = None; name; _ }; units = None; arguments = [] } when limit > 0 ->
        Option.bind (String_table.find_opt (Lazy.force aliases) name.text) (size (limit - 1))
    | Size_operation { operator; left; right } when limit > 0 -> (
        match (size (limit - 1) left, size (limit - 1) right) with
        | Some left, Some right -> Some (size_operation operator left right)
        | _ -> None)
    | Type _ | Type_variable _ | Representation _ | Function _ | Tuple_type _ | Size_operation _ ->
        None
  in
  size 100

let method_names members =
  let names (d : Syntax.Ir.declaration) =
    match d.desc with
    | Signature { names; _ } -> names
    | Binding _ | Type_alias _ | Data _ | Base_unit _ | Scaled_unit _ | Class _ | Instance _
    | Primitive _ | Foreign _ | Parameter _ | Claim _ | Check _ ->
        []
  in
  List.concat_map names members

let copy names =
  {
    values = String_table.copy names.values;
    constructors = String_table.copy names.constructors;
    tycons = String_table.copy names.tycons;
    units = String_table.copy names.units;
    classes = String_table.copy names.classes;
  }

let declared context ~module_ ?after (program : Syntax.Ir.program) =
  let names =
    match after with
    | Some names -> copy names
    | None when String.equal module_ prelude -> builtin_names ~file:program.file
    | None -> none ()
  in
  let signed = signed_names program.declarations in
  let global name : Ir.Global.t = { module_; name } in
  let value ?hint ?class_ (name : Syntax.Ir.name) ~signed =
    add context values ?hint names name
      { global = global name.text; signed; class_; span = name.span }
  in
  let size_of = sizes program in
  let tycon ?(units_optional = false) ?size (name : Syntax.Ir.name)
      (parameters : Syntax.Ir.type_parameters) record_fields =
    add context tycons names name
      {
        global = global name.text;
        unit_arity = List.length parameters.units;
        units_optional;
        type_arity = List.length parameters.types;
        record_fields;
        size;
        span = name.span;
      }
  in
  let constructor owner (c : Syntax.Ir.constructor) =
    add context constructors names c.name
      {
        global = global c.name.text;
        tycon = owner;
        arity = arity c.fields;
        fields = field_names c.fields;
        span = c.name.span;
      }
  in
  let declaration (d : Syntax.Ir.declaration) =
    match d.desc with
    | Signature _ -> ()
    | Binding { left = Name name; _ } -> value name ~signed:(String_table.mem signed name.text)
    | Binding { left = Function_name { name; _ }; _ } ->
        value name
          ~hint:
            (Diagnostic.hint
               "write one equation for the function, and distinguish its arguments with `case`")
          ~signed:(String_table.mem signed name.text)
    | Binding { left = Pattern _; _ } -> ()
    | Primitive { names = primitives; _ } ->
        List.iter (fun name -> value name ~signed:true) primitives
    | Foreign (Foreign_value { name; _ }) | Parameter { name; _ } -> value name ~signed:true
    | Foreign (Foreign_type { name; _ }) -> tycon name { units = []; types = [] } []
    | Foreign (Foreign_include _) -> ()
    | Type_alias { name; parameters; body } ->
        tycon ~units_optional:(names_a_number parameters body) ?size:(size_of body) name parameters
          []
    | Data { name; parameters; constructors } ->
        let fields =
          match constructors with
          | [ { fields; _ } ] -> Option.value (field_names fields) ~default:[]
          | _ -> []
        in
        tycon name parameters fields;
        List.iter (constructor (global name.text)) constructors
    | Base_unit name | Scaled_unit { name; _ } ->
        add context units names name { global = global name.text; span = name.span }
    | Class { name; members; _ } ->
        let methods = method_names members in
        let texts = Long_list.map (fun (m : Syntax.Ir.name) -> m.text) methods in
        let class_ = global name.text in
        add context classes names name { global = class_; methods = texts; span = name.span };
        List.iter (fun name -> value ~class_ name ~signed:true) methods
    | Check { kind; label; _ } ->
        value { label with text = Labels.check_name kind label.text } ~signed:true
    | Instance _ | Claim _ -> ()
  in
  List.iter declaration program.declarations;
  names

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
