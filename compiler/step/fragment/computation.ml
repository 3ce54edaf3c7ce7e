module F = Flow.Ir
open Basis
open Fragment

let atom_type atom = Layout.ty (Flow.Operands.ty atom)
let broken what = Diagnostic.bug ~stage:"Step.Computation" "%s" what

let sum_of : F.ty -> int = function
  | Sum k -> k
  | Bool | Int | Float | Array _ | Foreign _ -> broken "a constructor of a value that is not a sum"

let operation ~span operator ty arguments : Ir.expr = Operation { operator; ty; arguments; span }

let operator_weight : F.operator -> int = function
  | Add | Subtract | Multiply | Negate | Absolute | Equal | Less | Less_equal | Not | And | Or
  | To_float
  | Bitwise (Bit_and | Bit_or | Bit_xor) ->
      1
  | Signum | Minimum | Maximum | Truncate | Floor | Ceiling | Round
  | Bitwise (Shift_left | Shift_right)
  | Elementary (Floor_float | Ceiling_float) ->
      2
  | Divide | Elementary Nanoseconds -> 5
  | Div | Mod -> 8
  | Elementary Sqrt -> 5
  | Elementary (Hypot | Exp | Log | Sin | Cos | Tan | Asin | Acos | Atan | Atan2) | Pow -> 20

let one = function [ e ] -> e | _ -> broken "an operation with the wrong number of operands"

(* Replaces comparisons of a signal with itself, because C compilers warn about them. Keeps [x ==
   x], which tests for NaN. *)
let without_self_comparison (rhs : F.rhs) : F.rhs =
  match rhs with
  | Op (((Less | Less_equal | Equal) as operator), [ (Signal a as x); Signal b ]) when a.id = b.id
    -> (
      match (operator, a.ty) with
      | Less, _ -> Copy (Bool false)
      | _, Float -> Op (Equal, [ x; x ])
      | _, (Int | Bool | Sum _ | Array _ | Foreign _) -> Copy (Bool true))
  | rhs -> rhs

let array_type : F.ty -> int * Ir.ty = function
  | Array (n, element) -> (n, Layout.ty element)
  | Bool | Int | Float | Sum _ | Foreign _ -> broken "an element of a value that is not an array"

(* The expression of a stateless equation. *)
let computed (eq : F.equation) rhs : computed =
  let make ?choice operands weight build =
    { signal = eq.defines; operands; build; choice; weight; span = eq.span }
  in
  match (rhs : F.rhs) with
  | Copy a -> make [ a ] 0 one
  | Op (operator, operands) ->
      let ty =
        match operands with a :: _ -> atom_type a | [] -> broken "an operation without operands"
      in
      make operands (operator_weight operator) (operation ~span:eq.span operator ty)
  | If { condition; then_; else_ } ->
      let choice =
        match condition with
        | Signal _ -> Some (condition, then_, else_)
        | Bool _ | Int _ | Float _ -> None
      in
      make ?choice [ condition; then_; else_ ] 1 (function
        | [ condition; then_; else_ ] -> Select { condition; then_; else_; span = eq.span }
        | _ -> broken "a choice with the wrong number of operands")
  | Construct { constructor; payload } ->
      let sum = sum_of eq.defines.ty in
      let construct payload : Ir.expr = Construct { sum; constructor; payload } in
      make payload (1 + List.length payload) construct
  | Is_constructor (value, constructor) ->
      let sum = sum_of (Flow.Operands.ty value) in
      make [ value ] 1 (fun e -> Is_constructor { sum; value = one e; constructor })
  | Payload { value; constructor; leaf } ->
      let sum = sum_of (Flow.Operands.ty value) in
      make [ value ] 1 (fun e -> Payload { sum; value = one e; constructor; leaf })
  | Absent ->
      let ty =
        match eq.defines.ty with
        | Foreign ty -> ty
        | Bool | Int | Float | Sum _ | Array _ ->
            broken "expected a foreign type for an absent value"
      in
      make [] 0 (fun _ -> Ir.Absent ty)
  | Elements elements ->
      let _, element = array_type eq.defines.ty in
      make elements (List.length elements) (fun elements -> Elements { element; elements })
  | Fill value ->
      let count, element = array_type eq.defines.ty in
      make [ value ] count (fun e -> Fill { count; element; value = one e })
  | Index (array, index) -> make [ array ] 1 (fun e -> Index { array = one e; index })
  | At { array; index; default } ->
      let count, element = array_type (Flow.Operands.ty array) in
      make [ array; index; default ] 3 (function
        | [ array; index; default ] -> At { count; element; array; index; default }
        | _ -> broken "an array access with the wrong number of operands")
  | Replace { array; index; value } ->
      let count, element = array_type eq.defines.ty in
      make [ array; index; value ] (2 + count) (function
        | [ array; index; value ] -> Replace { count; element; array; index; value }
        | _ -> broken "an array update with the wrong number of operands")
  | Step_time -> make [] 0 (fun _ -> Ir.Dt)
  | Param k -> make [] 0 (fun _ -> Ir.Param k)
  | Delay _ | Time _ | Ticks _ | Integral _ | Derivative _ ->
      broken "a stateful operation where none is allowed"
