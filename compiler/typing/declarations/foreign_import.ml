(* The part of a type that has no counterpart in C, and the reason. *)
type culprit = { culprit : Ir.ty; obstacle : Declaration_fact.obstacle }

let rec substitute by (ty : Ir.ty) : Ir.ty =
  match ty with
  | Variable v -> (
      match List.find_opt (fun ((w : Ir.variable), _) -> w.id = v.id) by with
      | Some (_, ty) -> ty
      | None -> ty)
  | Number _ | Bool | String | Size _ -> ty
  | Tuple parts -> Tuple (List.map (substitute by) parts)
  | Function (a, b) -> Function (substitute by a, substitute by b)
  | Signal_function (a, b) -> Signal_function (substitute by a, substitute by b)
  | Data d -> Data { d with arguments = List.map (substitute by) d.arguments }

let is_array tycon = tycon = Environment.array

let is_program tycon =
  List.mem tycon [ Environment.built_in "Program"; Environment.built_in "Task" ]

(* The first part of the type that has no counterpart in C. *)
let rec obstacle environment (ty : Ir.ty) =
  let here obstacle = Some { culprit = ty; obstacle } in
  match ty with
  | Bool | Number ((Int | Float), _) | Size _ -> None
  | Number (Representation_variable _, _) -> here Representation
  | String -> here Text
  | Function _ | Signal_function _ -> here Compile_time
  | Variable { name = ("double" | "float" | "int" | "bool") as name; _ } -> here (Type_of_c name)
  | Variable _ -> here Several_types
  | Tuple parts -> List.find_map (obstacle environment) parts
  | Data { tycon; _ } when is_program tycon -> here Compile_time
  | Data { tycon; arguments; _ } -> (
      match List.find_map (obstacle environment) arguments with
      | Some found -> Some found
      | None when is_array tycon -> None
      | None -> (
          match (Environment.type_ environment tycon).definition with
          | Alias _ | Builtin | Foreign -> None
          | Data data ->
              let by = List.combine data.type_parameters arguments in
              let field (_, ty) = obstacle environment (substitute by ty) in
              List.find_map
                (fun (c : Ir.constructor) -> List.find_map field c.fields)
                data.constructors))

let refuse report declared refusal =
  report (Declaration_fact.Foreign { declared; refusal });
  false

let rec result : Ir.ty -> Ir.ty = function Function (_, ty) -> result ty | ty -> ty
let rec arguments : Ir.ty -> Ir.ty list = function Function (a, b) -> a :: arguments b | _ -> []

let check_form report p (kind : Syntax.Ir.foreign_kind) ty =
  match (kind, ty, result ty) with
  | Foreign_signal_function, Ir.Signal_function _, _ -> true
  | Foreign_signal_function, Function _, Signal_function _ ->
      refuse report p Signal_function_with_parameters
  | Foreign_signal_function, _, _ -> refuse report p (Not_a_signal_function ty)
  | Foreign_function, _, Signal_function _ -> refuse report p Signal_function
  | Foreign_function, Function _, _ -> true
  | Foreign_function, _, _ -> refuse report p (No_argument ty)

let check_parts report environment p ty =
  let taken, given =
    match ty with Ir.Signal_function (a, b) -> ([ a ], b) | ty -> (arguments ty, result ty)
  in
  let check ~to_c ty =
    match obstacle environment ty with
    | None -> true
    | Some { culprit; obstacle } -> refuse report p (Not_passed { culprit; obstacle; to_c })
  in
  List.for_all (check ~to_c:true) taken && check ~to_c:false given

(* Do these types have the same representation in C? *)
let rec same (a : Ir.ty) (b : Ir.ty) =
  match (a, b) with
  | Number (r, _), Number (s, _) -> r = s
  | Tuple a, Tuple b -> all_same a b
  | Function (a, b), Function (c, d) | Signal_function (a, b), Signal_function (c, d) ->
      same a c && same b d
  | Data a, Data b -> a.tycon = b.tycon && all_same a.arguments b.arguments
  | (Variable _ | Bool | String | Size _), _ -> a = b
  | (Number _ | Tuple _ | Function _ | Signal_function _ | Data _), _ -> false

and all_same a b = List.compare_lengths a b = 0 && List.for_all2 same a b

let check_once report known (p : Resolve.Ir.primitive) (v : Ir.foreign_value) =
  match Hashtbl.find_opt known v.symbol with
  | Some ((first : Resolve.Ir.primitive), (other : Ir.foreign_value))
    when not (other.kind = v.kind && same other.ty v.ty) ->
      let this = { Declaration_fact.ty = v.ty; at = p.span } in
      let first = { Declaration_fact.ty = other.ty; at = first.span } in
      report (Declaration_fact.Imported_twice { symbol = v.symbol; this; first })
  | Some _ -> ()
  | None -> Hashtbl.replace known v.symbol (p, v)

let value report environment known schemes (p : Resolve.Ir.primitive) =
  let import ({ kind; symbol } : Resolve.Ir.foreign) : Ir.foreign_value option =
    let scheme : Ir.scheme = Hashtbl.find schemes p.name in
    let without_context =
      match p.scheme.context with [] -> true | _ :: _ -> refuse report p Type_classes
    in
    if
      without_context
      && check_form report p kind scheme.ty
      && check_parts report environment p scheme.ty
    then (
      let v : Ir.foreign_value = { name = p.name; kind; symbol; ty = scheme.ty; span = p.span } in
      check_once report known p v;
      Some v)
    else None
  in
  Option.bind p.foreign import

let program ~report (program : Resolve.Ir.program) ~environment ~primitives : Ir.foreign =
  let schemes = Hashtbl.create 64 in
  List.iter (fun (name, scheme) -> Hashtbl.replace schemes name scheme) primitives;
  let known = Hashtbl.create 8 in
  let foreign_type (d : Resolve.Ir.type_declaration) : Ir.foreign_type option =
    match d.definition with
    | Foreign { c_type; copyable } -> Some { tycon = d.tycon; c_type; copyable }
    | Alias _ | Data _ | Builtin -> None
  in
  let headers (m : Resolve.Ir.module_) =
    List.map (fun header : Ir.header -> { header; of_file = m.file }) m.includes
  in
  {
    headers = List.concat_map headers program.modules;
    foreign_types = List.filter_map foreign_type program.types;
    values = List.filter_map (value report environment known schemes) program.primitives;
  }
