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

(* Shows a cycle as `A` → `B` → `A`. *)
let path names =
  match names with
  | [] -> ""
  | first :: _ -> String.concat " → " (List.map (Printf.sprintf "`%s`") (names @ [ first ]))

let own (scope : Scope.t) (g : Ir.Global.t) =
  if String.equal g.module_ scope.module_ then Some g.name else None

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
  let names = List.map (fun (d : Ir.type_declaration) -> d.tycon.name) circle in
  let is_data (d : Ir.type_declaration) =
    match d.definition with Data _ -> true | Alias _ | Builtin | Foreign _ -> false
  in
  (* The type at which to report the cycle: a data type if there is one, because its size is the
     problem; otherwise the first alias. *)
  let main = match List.find_opt is_data circle with Some d -> d | None -> List.hd circle in
  let diagnostic =
    if is_data main then
      Diagnostic.error ~code:"E0218" ~at:main.span "the data type `%s` contains itself"
        main.tycon.name
      |> Diagnostic.note "every value has a fixed size, so a data type cannot be recursive"
      |> Diagnostic.hint
           "use an array of a fixed size, such as `Array 8 Distance`; if the number of valid \
            elements varies, keep their count in a second field"
    else
      Diagnostic.error ~code:"E0217" ~at:main.span "the type alias `%s` is defined by itself"
        main.tycon.name
  in
  let label diagnostic (d : Ir.type_declaration) =
    if d == main then diagnostic
    else Diagnostic.label ~at:d.span (Printf.sprintf "through `%s`" d.tycon.name) diagnostic
  in
  let diagnostic = List.fold_left label diagnostic circle in
  (if List.length names > 1 then Diagnostic.note (path names) diagnostic else diagnostic)
  |> Context.emit scope.context

let report_repeated (scope : Scope.t) what (first : Syntax.Ir.name) (second : Syntax.Ir.name) =
  Diagnostic.error ~code:"E0211" ~at:second.span "the %s `%s` is declared twice" what second.text
  |> Diagnostic.label ~at:first.span "first declared here"
  |> Context.emit scope.context

let check_distinct scope what (names : Syntax.Ir.name list) =
  let add seen (name : Syntax.Ir.name) =
    match String_map.find_opt name.text seen with
    | Some first ->
        report_repeated scope what first name;
        seen
    | None -> String_map.add name.text name seen
  in
  ignore (List.fold_left add String_map.empty names)

let check_parameters (scope : Scope.t) (parameters : Syntax.Ir.type_parameters) =
  check_distinct scope "parameter" (parameters.units @ parameters.types);
  let check (name : Syntax.Ir.name) =
    match Scope.look scope units name with
    | None -> ()
    | Some _ ->
        Diagnostic.error ~code:"E0224" ~at:name.span
          "the unit parameter `%s` has the same name as a unit" name.text
        |> Diagnostic.hint "use a letter that is not a unit, such as `u`"
        |> Context.emit scope.context
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
        check_distinct scope "field" (Long_list.map fst fields);
        (Long_list.map (fun (name, t) -> (Some name, t)) fields, true)
  in
  {
    constructor = { module_ = scope.module_; name = c.name.text };
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
    let tycon : Ir.Global.t = { module_ = scope.module_; name = name.text } in
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
  if String.equal scope.module_ "Prelude" then
    Long_list.map builtin (builtin_types ~file:program.file) @ sorted
  else sorted

(* Units *)

let check_unit_name (scope : Scope.t) (name : Syntax.Ir.name) =
  let proper =
    String.length name.text >= 2 || match name.text.[0] with 'A' .. 'Z' -> true | _ -> false
  in
  if not (proper || scope.library) then
    Diagnostic.error ~code:"E0220" ~at:name.span
      "the name of the unit `%s` is a single lower-case letter" name.text
    |> Diagnostic.note
         "single lower-case letters are reserved for unit variables and the library's units"
    |> Diagnostic.hint "use a name of at least two characters, or a capital letter"
    |> Context.emit scope.context

let unit_declaration (scope : Scope.t) (d : Syntax.Ir.declaration) : Ir.unit_declaration option =
  let declare (name : Syntax.Ir.name) definition : Ir.unit_declaration option =
    check_unit_name scope name;
    Some { unit_name = { module_ = scope.module_; name = name.text }; definition; span = name.span }
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

let report_unit_circle (scope : Scope.t) (circle : Ir.unit_declaration list) =
  let main = List.hd circle in
  let label diagnostic (d : Ir.unit_declaration) =
    Diagnostic.label ~at:d.span (Printf.sprintf "through `%s`" d.unit_name.name) diagnostic
  in
  List.fold_left label
    (Diagnostic.error ~code:"E0219" ~at:main.span "the unit `%s` is defined by itself"
       main.unit_name.name)
    (List.tl circle)
  |> Context.emit scope.context

let units (scope : Scope.t) (program : Syntax.Ir.program) =
  sort
    (List.filter_map (unit_declaration scope) program.declarations)
    ~name:(fun (d : Ir.unit_declaration) -> d.unit_name.name)
    ~uses:(units_used scope) ~report:(report_unit_circle scope)
