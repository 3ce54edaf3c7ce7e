module Ir = Typing.Ir
module Types = Probe.Signal_types

type known = {
  typed : Ir.program;
  types : Types.t;
  angles : (Ir.Global.t * string, string) Hashtbl.t;  (** units of angles, by type and field *)
  numbers : (Basis.Span.t, Ir.ty) Hashtbl.t Lazy.t;
      (** types of numeric expressions, by place in the source *)
}

(* {1 Declarations} *)

(* Generated C represents angles in radians, but their types do not say so. *)
let rec angle (ty : Resolve.Ir.ty) =
  match ty.desc with
  | Named { tycon = { module_ = "Prelude"; name = "Angle" }; _ } -> Some "rad"
  | Named { tycon = { module_ = "Prelude"; name = "AngularVelocity" }; _ } -> Some "rad/s"
  | Named { tycon = { name = "Event" | "Array"; _ }; arguments; _ } -> (
      match List.rev arguments with last :: _ -> angle last | [] -> None)
  | _ -> None

let angles (program : Resolve.Ir.program) =
  let table = Hashtbl.create 16 in
  let field tycon (f : Resolve.Ir.field) =
    Option.iter (Hashtbl.replace table (tycon, f.field_name)) (angle f.ty)
  in
  let declaration (d : Resolve.Ir.type_declaration) =
    match d.definition with
    | Data [ only ] when only.record -> List.iter (field d.tycon) only.fields
    | Data _ | Alias _ | Builtin | Foreign _ -> ()
  in
  List.iter declaration program.types;
  table

let numbers (program : Ir.program) =
  let table = Hashtbl.create 1024 in
  let rec expr (e : Ir.expr) =
    (match e.ty with Number _ -> Hashtbl.add table e.span e.ty | _ -> ());
    Typing.Walk.parts expr e
  in
  List.iter (fun (d : Ir.definition) -> expr d.value) program.definitions;
  table

(* {1 Values} *)

let number ty = Option.value (Types.unit_ ty) ~default:""

(* Returns the unit of a record whose numbers all have the same unit, such as a vector. *)
let record_unit known (ty : Ir.ty) tycon =
  let is_it (d : Ir.data) = d.tycon = tycon in
  match List.find_opt is_it known.typed.data with
  | Some { constructors = [ only ]; _ } -> (
      let unit_of k _ = Option.map number (Types.part known.types ty [ string_of_int (k + 1) ]) in
      match List.sort_uniq compare (List.mapi unit_of only.fields) with
      | [ Some unit_ ] -> unit_
      | _ -> "")
  | Some _ | None -> ""

let unit_ known (ty : Ir.ty) =
  match ty with
  | Data { tycon; units = [ _ ]; arguments = [] } -> record_unit known ty tycon
  | ty -> number ty

let rec declared_angle known (ty : Ir.ty) field =
  match ty with
  | Data { tycon = { name = "Array"; _ }; arguments = [ _; element ]; _ } ->
      declared_angle known element field
  | Data { tycon; _ } -> Hashtbl.find_opt known.angles (tycon, field)
  | _ -> None

let part known (ty : Ir.ty) word =
  Option.map (fun part -> (part, declared_angle known ty word)) (Types.part known.types ty [ word ])

let rec value known (ty, angle) : Cgen.Units.value =
  {
    unit_ = Option.value angle ~default:(unit_ known ty);
    part =
      (fun word -> Option.fold (part known ty word) ~none:Cgen.Units.unknown ~some:(value known));
  }

let record known (product : Flow.Ir.product) =
  match Columns.declared known.typed product with
  | Some ty -> value known (ty, None)
  | None -> Cgen.Units.unknown

(* {1 The state} *)

(* Inlining prefixes a signal's name with the names of instances. *)
let rec of_variable known words written =
  match words with
  | [] -> None
  | name :: path -> (
      match Types.type_of_signal known.types ~name written with
      | Some ty ->
          List.fold_left
            (fun found word -> Option.bind found (fun (ty, _) -> part known ty word))
            (Some (ty, None))
            path
      | None -> of_variable known path written)

(* Several expressions can have the same place, such as an operation and its result. *)
let of_expression known written =
  match Hashtbl.find_all (Lazy.force known.numbers) written with
  | ty :: others when List.for_all (fun other -> number other = number ty) others -> Some (ty, None)
  | _ -> None

let of_origin known ({ signal; written; role } : Step.Ir.origin) =
  let found =
    if String.equal signal "" then of_expression known written
    else of_variable known (String.split_on_char '.' signal) written
  in
  match (found, role) with
  | Some (ty, angle), Its_value -> Option.value angle ~default:(unit_ known ty)
  | Some (ty, _), Its_integrand -> number (Types.times_seconds (-1) ty)
  | Some (ty, _), Its_integral -> number (Types.times_seconds 1 ty)
  | None, _ -> ""

let rec is_number (ty : Step.Ir.ty) =
  match ty with
  | Int | Float -> true
  | Array (_, element) -> is_number element
  | Bool | Sum _ | Nanoseconds | Foreign _ -> false

let field known (f : Step.Ir.field) =
  match (f.content, f.origin) with
  | Value ty, Some origin when is_number ty -> of_origin known origin
  | _ -> ""

let of_program ~resolved typed (entry : Ir.definition) : Cgen.Units.t =
  let known =
    {
      typed;
      types = Types.of_program typed;
      angles = angles resolved;
      numbers = lazy (numbers typed);
    }
  in
  let side ty = value known (ty, None) in
  let input, output =
    match entry.scheme.ty with
    | Signal_function (input, output) -> (side input, side output)
    | _ -> (Cgen.Units.unknown, Cgen.Units.unknown)
  in
  { input; output; record = record known; field = field known }
