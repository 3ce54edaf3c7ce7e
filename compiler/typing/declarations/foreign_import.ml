open Basis

(* The reason why a type has no counterpart in C. *)
type obstacle = { culprit : string; why : string; cure : string option }

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

let compile_time = "functions, signal functions and labels exist only at compile time"

(* The first part of the type that has no counterpart in C. *)
let rec obstacle environment (ty : Ir.ty) =
  let here ?cure why = Some { culprit = Show.ty ty; why; cure } in
  match ty with
  | Bool | Number ((Int | Float), _) | Size _ -> None
  | Number (Representation_variable _, _) ->
      here "C has different functions for Int and Float" ~cure:"write `Float[…]` or `Int[…]`"
  | String -> here compile_time ~cure:"pass an `Int` that tells C which text you mean"
  | Function _ | Signal_function _ -> here compile_time
  | Variable { name = ("double" | "float" | "int" | "bool") as name; _ } ->
      let cure =
        match name with
        | "int" -> "`Int`"
        | "bool" -> "`Bool`"
        | _ -> "`Float`, which is a `double`"
      in
      here "a lower-case name is a type variable" ~cure:("write this C type as " ^ cure)
  | Variable _ ->
      here "a C function has one type" ~cure:"import it once for each type and size that you need"
  | Tuple parts -> List.find_map (obstacle environment) parts
  | Data { tycon; _ } when is_program tycon -> here compile_time
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

let report sink (p : Resolve.Ir.primitive) ?note ?hint format =
  Printf.ksprintf
    (fun text ->
      Diagnostic.error ~code:"E0380" ~at:p.scheme.span "%s" text
      |> Option.fold ~none:Fun.id ~some:Diagnostic.note note
      |> Option.fold ~none:Fun.id ~some:Diagnostic.hint hint
      |> Diagnostic.emit sink)
    format

let rec result : Ir.ty -> Ir.ty = function Function (_, ty) -> result ty | ty -> ty
let rec arguments : Ir.ty -> Ir.ty list = function Function (a, b) -> a :: arguments b | _ -> []

let check_form sink (p : Resolve.Ir.primitive) (kind : Syntax.Ir.foreign_kind) ty =
  let name = p.name.name in
  match (kind, ty, result ty) with
  | Foreign_signal_function, Ir.Signal_function _, _ -> true
  | Foreign_signal_function, Function _, Signal_function _ ->
      report sink p "the foreign signal function `%s` cannot have parameters" name
        ~hint:"add them to its input";
      false
  | Foreign_signal_function, _, _ ->
      report sink p "`%s` is a foreign signal function, but `%s` is not a signal function type" name
        (Show.ty ty)
        ~hint:
          (Printf.sprintf "declare a function without `sf`: `foreign %s :: %s = …`" name
             (Show.ty ty));
      false
  | Foreign_function, _, Signal_function _ ->
      report sink p "`%s` is a signal function" name
        ~hint:(Printf.sprintf "if it has state in C, declare it as `foreign sf %s :: …`" name);
      false
  | Foreign_function, Function _, _ -> true
  | Foreign_function, _, _ ->
      report sink p "`%s` has no argument, but a C function needs a function type" name
        ~hint:(Printf.sprintf "use `() -> %s`, and call it as `%s ()`" (Show.ty ty) name);
      false

let check_parts sink environment (p : Resolve.Ir.primitive) ty =
  let taken, given =
    match ty with Ir.Signal_function (a, b) -> ([ a ], b) | ty -> (arguments ty, result ty)
  in
  let check what ty =
    match obstacle environment ty with
    | None -> true
    | Some { culprit; why; cure } ->
        report sink p "`%s` cannot %s C a value of type `%s`" p.name.name what culprit ~note:why
          ?hint:cure;
        false
  in
  List.for_all (check "give") taken && check "take from" given

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

let check_once sink known (p : Resolve.Ir.primitive) (v : Ir.foreign_value) =
  match Hashtbl.find_opt known v.symbol with
  | Some ((first : Resolve.Ir.primitive), (other : Ir.foreign_value))
    when not (other.kind = v.kind && same other.ty v.ty) ->
      Diagnostic.error ~code:"E0381" ~at:p.span "C's `%s` is imported here as `%s`" v.symbol
        (Show.ty v.ty)
      |> Diagnostic.label ~at:first.span (Printf.sprintf "and here as `%s`" (Show.ty other.ty))
      |> Diagnostic.note "a C function has one type"
      |> Diagnostic.emit sink
  | Some _ -> ()
  | None -> Hashtbl.replace known v.symbol (p, v)

let value sink environment known schemes (p : Resolve.Ir.primitive) =
  let import ({ kind; symbol } : Resolve.Ir.foreign) : Ir.foreign_value option =
    let scheme : Ir.scheme = Hashtbl.find schemes p.name in
    let without_context =
      match p.scheme.context with
      | [] -> true
      | _ :: _ ->
          report sink p "foreign declarations cannot have type classes"
            ~hint:"import it once for each type that you need";
          false
    in
    if
      without_context && check_form sink p kind scheme.ty
      && check_parts sink environment p scheme.ty
    then (
      let v : Ir.foreign_value = { name = p.name; kind; symbol; ty = scheme.ty; span = p.span } in
      check_once sink known p v;
      Some v)
    else None
  in
  Option.bind p.foreign import

let program sink (program : Resolve.Ir.program) ~environment ~primitives : Ir.foreign =
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
    values = List.filter_map (value sink environment known schemes) program.primitives;
  }
