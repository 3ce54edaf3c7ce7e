open Basis
module Ir = Typing.Ir
module Constants = Cgen.Named_constants

type value = { constant : Constants.constant; value : float }

(** The constant that an operation uses as its operand with a given value, or [Ambiguous] if several
    of its operands may have this value. *)
type use = One of Constants.constant | Ambiguous

type t = {
  real : Real.t;
  globals : (Ir.Global.t, value) Hashtbl.t;
  locals : (int, value) Hashtbl.t;
  uses : (Span.t * int64, use) Hashtbl.t;
}

(* {1 Values} *)

let known t (e : Ir.expr) =
  match e.desc with
  | Global (name, _) -> Hashtbl.find_opt t.globals name
  | Local (local, _) -> Hashtbl.find_opt t.locals local.id
  | _ -> None

let operator (primitive : Ir.Global.t) : Flow.Ir.operator option =
  match Core.Primitive_table.of_name primitive.name with
  | Some Add -> Some Add
  | Some Subtract -> Some Subtract
  | Some Multiply -> Some Multiply
  | Some Divide -> Some Divide
  | Some _ | None -> None

(* The value of a number, of another constant, or of an arithmetic operation on them. A whole-number
   constant without a signature, such as [k = 2[1/s]], is a Float wherever it is used as one. *)
let rec value t (e : Ir.expr) =
  match (e.desc, e.ty) with
  | Number x, Number ((Float | Representation_variable _), _) -> Some (Real.of_exact t.real x)
  | Negate e, _ -> Option.map Float.neg (value t e)
  | Apply ({ desc = Apply ({ desc = Primitive (primitive, _); _ }, a); _ }, b), _ -> (
      match (operator primitive, value t a, value t b) with
      | Some operator, Some a, Some b -> (
          match Flow.Fold.operation t.real operator [ Float a; Float b ] with
          | Some (Float x) -> Some x
          | Some (Signal _ | Bool _ | Int _) | None -> None)
      | _, _, _ -> None)
  | _, _ -> Option.map (fun known -> known.value) (known t e)

(* Zero gets no name, because operations with zero are special cases in C. *)
let constant t ~name place (e : Ir.expr) =
  let unit_ = Option.value (Probe.Signal_types.unit_ e.ty) ~default:"" in
  match value t e with
  | Some value when Float.is_finite value && value <> 0. ->
      Some { constant = { name; unit_; place }; value }
  | Some _ | None -> None

(* {1 Uses} *)

let note t place value use =
  let key = (place, Int64.bits_of_float value) in
  match (Hashtbl.find_opt t.uses key, use) with
  | None, _ -> Hashtbl.replace t.uses key use
  | Some (One before), One constant when before = constant -> ()
  | Some _, _ -> Hashtbl.replace t.uses key Ambiguous

let operand t place (e : Ir.expr) =
  match known t e with
  | Some { constant; value } -> note t place value (One constant)
  | None -> Option.iter (fun value -> note t place value Ambiguous) (value t e)

(* The arguments of a primitive operation. Returns no arguments for a function call, because the
   function's own body contains the operations on them. *)
let rec arguments (e : Ir.expr) others =
  match e.desc with
  | Apply (f, argument) -> arguments f (argument :: others)
  | Primitive _ -> others
  | _ -> []

let rec expr t (e : Ir.expr) =
  (match e.desc with
  | Apply _ -> List.iter (operand t e.span) (arguments e [])
  | If (_, then_, else_) -> List.iter (operand t e.span) [ then_; else_ ]
  | Record (_, fields) -> List.iter (fun (_, field) -> operand t e.span field) fields
  | Let (bindings, _) -> List.iter (binding t) bindings
  | Proc { equations; output; _ } ->
      List.iter (binding t) equations;
      operand t output.span output
  | _ -> ());
  Typing.Walk.parts (expr t) e

and binding t (b : Ir.binding) =
  (match b.pattern.desc with
  | Bound local when b.level = Constant ->
      let found = constant t ~name:local.name local.span b.value in
      Option.iter (Hashtbl.replace t.locals local.id) found
  | _ -> ());
  operand t b.span b.value

let definition t (d : Ir.definition) =
  let found = constant t ~name:d.name.name d.span d.value in
  Option.iter (Hashtbl.replace t.globals d.name) found;
  expr t d.value

let of_program ~resolved (program : Ir.program) =
  let create () = Hashtbl.create 64 in
  let t =
    { real = program.real; globals = create (); locals = create (); uses = Hashtbl.create 64 }
  in
  let own = Resolve.Walk.own_modules resolved in
  let is_own (d : Ir.definition) =
    List.exists (fun (m : Resolve.Ir.module_) -> String.equal m.name d.name.module_) own
  in
  let is_param (d : Ir.definition) =
    List.exists (fun (p : Ir.param) -> p.param = d.name || p.given = Some d.name) program.params
  in
  let wanted d = is_own d && not (is_param d) in
  List.iter (definition t) (List.filter wanted program.definitions);
  fun ~at x ->
    match Hashtbl.find_opt t.uses (at, Int64.bits_of_float x) with
    | Some (One constant) -> Some constant
    | Some Ambiguous | None -> None
