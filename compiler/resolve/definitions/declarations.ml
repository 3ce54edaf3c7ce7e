open Basis
open Interface

(* Sorts declarations topologically. Calls [report] for each cycle. *)
let sort ~name ~uses ~report declarations =
  let all = Array.of_list declarations in
  let index =
    let add (i, index) d = (i + 1, String_map.add (name d) i index) in
    snd (Array.fold_left add (0, String_map.empty) all)
  in
  let graph =
    Array.map (fun d -> List.filter_map (fun n -> String_map.find_opt n index) (uses d)) all
  in
  let components = Graph.components graph in
  let check component =
    if Graph.is_cyclic graph component then
      report (List.map (fun i -> all.(i)) (Graph.shortest_cycle graph component))
  in
  List.iter check components;
  Long_list.map (fun i -> all.(i)) (List.concat_map Fun.id components)

let own (scope : Scope.t) (g : Ir.Global.t) =
  if String.equal g.module_ scope.visible.module_ then Some g.name else None

(* Types *)

let rec types_used scope (t : Ir.ty) found =
  match t.desc with
  | Type_variable _ | Representation _ | Size _ -> found
  | Named { tycon; arguments; _ } ->
      let found = match own scope tycon with Some name -> name :: found | None -> found in
      List.fold_left (fun found t -> types_used scope t found) found arguments
  | Function (a, b) -> types_used scope b (types_used scope a found)
  | Tuple_type ts -> List.fold_left (fun found t -> types_used scope t found) found ts

let uses scope (d : Ir.type_declaration) =
  match d.definition with
  | Builtin | Foreign _ -> []
  | Alias t -> types_used scope t []
  | Data constructors ->
      let field found (f : Ir.field) = types_used scope f.ty found in
      let constructor found (c : Ir.constructor) = List.fold_left field found c.fields in
      List.rev (List.fold_left constructor [] constructors)

let report_circle (scope : Scope.t) (circle : Ir.type_declaration list) =
  let is_data (d : Ir.type_declaration) =
    match d.definition with Data _ -> true | Alias _ | Builtin | Foreign _ -> false
  in
  (* The type at which to report the cycle: a data type if there is one, because its size is the
     problem; otherwise the first alias. *)
  let main = match List.find_opt is_data circle with Some d -> d | None -> List.hd circle in
  Context.report_type scope.context (Type_circle { main; circle })

let check_distinct ~twice (names : Syntax.Ir.name list) =
  let add seen (name : Syntax.Ir.name) =
    match String_map.find_opt name.text seen with
    | Some first ->
        twice first name;
        seen
    | None -> String_map.add name.text name seen
  in
  ignore (List.fold_left add String_map.empty names)

let check_parameters (scope : Scope.t) (parameters : Syntax.Ir.type_parameters) =
  let report = Context.report_type scope.context in
  check_distinct (parameters.units @ parameters.types) ~twice:(fun first second ->
      report (Parameter_twice { first; second }));
  let check (name : Syntax.Ir.name) =
    match Scope.look scope units name with
    | None -> ()
    | Some _ -> report (Parameter_is_a_unit name)
  in
  List.iter check parameters.units

let field scope variables (name, ty) : Ir.field =
  let t : Ir.ty = Types.ty scope variables ty in
  match (name : Syntax.Ir.name option) with
  | None -> { field_name = ""; ty = t; span = t.span }
  | Some name -> { field_name = name.text; ty = t; span = name.span }

let constructor (scope : Scope.t) variables tycon index (c : Syntax.Ir.constructor) : Ir.constructor
    =
  let fields, record =
    match c.fields with
    | Positional types -> (Long_list.map (fun t -> (None, t)) types, false)
    | Named fields ->
        check_distinct (Long_list.map fst fields) ~twice:(fun first second ->
            Context.report_type scope.context (Field_twice { first; second }));
        (Long_list.map (fun (name, t) -> (Some name, t)) fields, true)
  in
  {
    constructor = { module_ = scope.visible.module_; name = c.name.text };
    tycon;
    index;
    fields = Long_list.map (field scope variables) fields;
    record;
    span = c.name.span;
  }

let variables owner (parameters : Syntax.Ir.type_parameters) =
  let set names = String_set.of_list (List.map (fun (n : Syntax.Ir.name) -> n.text) names) in
  Types.Parameters { units = set parameters.units; types = set parameters.types; owner }

let declaration (scope : Scope.t) (d : Syntax.Ir.declaration) : Ir.type_declaration option =
  let declare (name : Syntax.Ir.name) (parameters : Syntax.Ir.type_parameters) definition =
    check_parameters scope parameters;
    let parameter (p : Syntax.Ir.name) : Ir.parameter = { name = p.text; span = p.span } in
    let tycon : Ir.Global.t = { module_ = scope.visible.module_; name = name.text } in
    Some
      ({
         tycon;
         unit_parameters = Long_list.map parameter parameters.units;
         type_parameters = Long_list.map parameter parameters.types;
         definition = definition tycon (variables name.text parameters);
         doc = d.doc;
         span = name.span;
       }
        : Ir.type_declaration)
  in
  match d.desc with
  | Type_alias { name; parameters; body } ->
      declare name parameters (fun _ variables -> Ir.Alias (Types.ty scope variables body))
  | Data { name; parameters; constructors } ->
      declare name parameters (fun tycon variables ->
          let add (index, reversed) c =
            (index + 1, constructor scope variables tycon index c :: reversed)
          in
          Ir.Data (List.rev (snd (List.fold_left add (0, []) constructors))))
  | Foreign (Foreign_type { name; c_type; copyable }) ->
      declare name { units = []; types = [] } (fun _ _ ->
          Foreign_code.check_type scope c_type;
          Ir.Foreign { c_type = c_type.text; copyable })
  | Signature _ | Binding _ | Base_unit _ | Scaled_unit _ | Class _ | Instance _ | Primitive _
  | Foreign (Foreign_value _ | Foreign_include _)
  | Parameter _ | Claim _ | Check _ ->
      None

let builtin (_, (t : tycon)) : Ir.type_declaration =
  let parameters letters n =
    List.init n (fun i : Ir.parameter -> { name = String.make 1 letters.[i]; span = t.span })
  in
  {
    tycon = t.global;
    unit_parameters = parameters "u" t.unit_arity;
    type_parameters = parameters "abc" t.type_arity;
    definition = Builtin;
    doc = None;
    span = t.span;
  }

let types (scope : Scope.t) (program : Syntax.Ir.program) =
  let declared = List.filter_map (declaration scope) program.declarations in
  let sorted =
    sort declared
      ~name:(fun (d : Ir.type_declaration) -> d.tycon.name)
      ~uses:(uses scope) ~report:(report_circle scope)
  in
  if String.equal scope.visible.module_ "Prelude" then
    Long_list.map builtin (builtin_types ~file:program.file) @ sorted
  else sorted

(* Units *)

let check_unit_name (scope : Scope.t) (name : Syntax.Ir.name) =
  let proper =
    String.length name.text >= 2 || match name.text.[0] with 'A' .. 'Z' -> true | _ -> false
  in
  if not (proper || scope.library) then Context.report_type scope.context (Unit_of_one_letter name)

let unit_declaration (scope : Scope.t) (d : Syntax.Ir.declaration) : Ir.unit_declaration option =
  let declare (name : Syntax.Ir.name) definition : Ir.unit_declaration option =
    check_unit_name scope name;
    Some
      {
        unit_name = { module_ = scope.visible.module_; name = name.text };
        definition;
        span = name.span;
      }
  in
  match d.desc with
  | Base_unit name -> declare name Ir.Base
  | Scaled_unit { name; scale; unit_ } ->
      declare name (Ir.Scaled (scale, Types.concrete_unit scope unit_))
  | Signature _ | Binding _ | Type_alias _ | Data _ | Class _ | Instance _ | Primitive _ | Foreign _
  | Parameter _ | Claim _ | Check _ ->
      None

let units_used scope (d : Ir.unit_declaration) =
  let used ((factor : Ir.unit_factor), _) =
    match factor with Declared g -> own scope g | Unit_variable _ -> None
  in
  match d.definition with Base -> [] | Scaled (_, u) -> List.filter_map used u.factors

let report_unit_circle (scope : Scope.t) = function
  | [] -> ()
  | main :: others -> Context.report_type scope.context (Unit_circle { main; others })

let units (scope : Scope.t) (program : Syntax.Ir.program) =
  sort
    (List.filter_map (unit_declaration scope) program.declarations)
    ~name:(fun (d : Ir.unit_declaration) -> d.unit_name.name)
    ~uses:(units_used scope) ~report:(report_unit_circle scope)
