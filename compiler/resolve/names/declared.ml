open Basis
open Interface

(* Adds an entry to one namespace. Reports the name if it is already taken. *)
let add context space ?(is_function = false) names (name : Syntax.Ir.name) entry =
  let table = space.table names in
  match String_table.find_opt table name.text with
  | None -> String_table.add table name.text entry
  | Some earlier ->
      let namespace = space.namespace and first = space.place earlier in
      Context.report_definition context (Declared_twice { namespace; name; first; is_function })

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

(* The numbers that the module's own aliases represent, such as 25 for both `type N = 25` and
   `type M = N`. *)
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

let copy names =
  {
    values = String_table.copy names.values;
    constructors = String_table.copy names.constructors;
    tycons = String_table.copy names.tycons;
    units = String_table.copy names.units;
    classes = String_table.copy names.classes;
  }

let program context ~module_ ?after (program : Syntax.Ir.program) =
  let names =
    match after with
    | Some names -> copy names
    | None when String.equal module_ prelude -> builtin_names ~file:program.file
    | None -> none ()
  in
  let signed = signed_names program.declarations in
  let global name : Ir.Global.t = { module_; name } in
  let value ?is_function ?class_ (name : Syntax.Ir.name) ~signed =
    add context values ?is_function names name
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
        value name ~is_function:true ~signed:(String_table.mem signed name.text)
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
