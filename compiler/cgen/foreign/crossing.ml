module M = Step.Ir

type direction = To_c | From_c

let plain desc : Ir.statement = { desc; comment = "" }
let bug format = Basis.Diagnostic.bug ~stage:"Cgen.Crossing" format
let is_converted names = Value_types.differ (Expression.vocabulary names).types

let cast names direction e =
  match direction with
  | To_c -> Ir.Cast (Real Double, e)
  | From_c -> Cast (Vocabulary.real (Expression.vocabulary names), e)

let number names direction (ty : M.ty) e =
  match ty with Float when is_converted names ty -> cast names direction e | _ -> e

let member value name : Ir.expr =
  match value with
  | Ir.Unary (Dereference, pointer) -> Arrow (pointer, name)
  | value -> Member (value, name)

(* [depth]: the number of enclosing loops. *)
let rec value names direction ~depth (ty : M.ty) ~to_ ~from =
  match ty with
  | _ when not (is_converted names ty) -> [ plain (Ir.Assign (to_, from)) ]
  | Float -> [ plain (Ir.Assign (to_, cast names direction from)) ]
  | Sum k -> sum names direction ~depth k ~to_ ~from
  | Array (count, element) ->
      let index = Expression.index names depth in
      let at array = Array_type.element array (Name index) in
      let body = value names direction ~depth:(depth + 1) element ~to_:(at to_) ~from:(at from) in
      [ plain (For { index; count; body }) ]
  | Bool | Int | Nanoseconds | Foreign _ -> bug "expected a type that contains Floats"

(* Copies member by member, because both structs have the same members. *)
and sum names direction ~depth k ~to_ ~from =
  let v = Expression.vocabulary names in
  let sums = v.program.sums in
  let one (name, (kind : Sum_type.kind)) =
    let to_ = member to_ name and from = member from name in
    match kind with
    | Number -> value names direction ~depth M.Float ~to_ ~from
    | Large ty -> value names direction ~depth (Step.Layout.ty ty) ~to_ ~from
    | Whole | Truth | Inner_tag -> [ plain (Ir.Assign (to_, from)) ]
  in
  List.concat_map one (("tag", Sum_type.Inner_tag) :: Sum_type.kinds sums v.sums.(k).slots)

let assign names direction = value names direction ~depth:0

let rec without_arrays steps (ty : M.ty) =
  match (steps, ty) with
  | Interface.Element _ :: steps, Array (_, element) -> without_arrays steps element
  | Interface.Member _ :: steps, ty -> without_arrays steps ty
  | [], ty -> ty
  | Element _ :: _, _ -> bug "expected an array type for an element"

let elements names direction ty steps ~c ~own =
  let ty = without_arrays steps ty and depth = Interface.dimensions steps in
  Access.for_each names steps (fun indices ->
      let c = c indices and own = List.fold_left Array_type.element own indices in
      let to_, from = match direction with To_c -> (c, own) | From_c -> (own, c) in
      value names direction ~depth ty ~to_ ~from)
