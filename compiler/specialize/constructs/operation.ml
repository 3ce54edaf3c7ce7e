open Basis
module Ir = Flow.Ir

type position = Evaluator.position

(* Computes [x ^ k] by squaring. The intermediate powers have no names, because the program names
   only the result. *)
let power (p : position) target leaf x k =
  let one : Ir.atom = match (leaf : Ir.ty) with Int -> Int 1l | _ -> Float 1. in
  let define target operator operands =
    Node.define p.node target ~span:p.span leaf (Op (operator, operands))
  in
  let rec power target k : Ir.atom =
    if k = 0 then one
    else if k < 0 then define target Divide [ one; power Node.Unnamed (-k) ]
    else if k = 1 then x
    else if k mod 2 = 0 then
      let half = power Node.Unnamed (k / 2) in
      define target Multiply [ half; half ]
    else define target Multiply [ x; power Node.Unnamed (k - 1) ]
  in
  power target k

(* [min a b] is [if b < a then b else a], which is [a] if both are equal. *)
let extreme (p : position) target primitive ty a b =
  let less = Comparison.less p Node.Unnamed ty in
  let second = if primitive = Core.Primitive.Minimum then less b a else less a b in
  Leaves.select p.types p.node target ~span:p.span ty second b a

let apply (p : position) target (primitive : Core.Primitive.t) ~result
    (arguments : Value.argument list) : Value.t =
  let bug () =
    Diagnostic.bug ~stage:"Specialize.Operation" "`%s` applied to %d arguments"
      (Core.Primitive_table.name primitive)
      (List.length arguments)
  in
  let atom (a : Value.argument) = Leaves.atom p.types p.node ~span:p.span a.ty a.value in
  let leaf : Ir.ty =
    match (Types.layout p.types result).leaves with
    | [ { leaf; _ } ] -> leaf
    | [] | _ :: _ :: _ -> Bool (* structural [min] and [max], which do not use [leaf] *)
  in
  let define target rhs = Node.define p.node target ~span:p.span leaf rhs in
  let operate operator : Value.t =
    let arguments = List.map atom arguments in
    match Flow.Fold.operation p.context.real operator arguments with
    | Some known -> Value.Atom known
    | None -> Atom (define target (Op (operator, arguments)))
  in
  let compare comparison = function
    | [ (a : Value.argument); (b : Value.argument) ] ->
        Value.Atom (comparison p target a.ty a.value b.value)
    | _ -> bug ()
  in
  match primitive with
  | Add -> operate Add
  | Subtract -> operate Subtract
  | Multiply -> operate Multiply
  | Negate -> operate Negate
  | Absolute -> operate Absolute
  | Signum -> operate Signum
  | Divide -> operate Divide
  | Power -> operate Pow
  | Power_literal k -> (
      match arguments with [ x ] -> Atom (power p target leaf (atom x) k) | _ -> bug ())
  | Elementary e -> operate (Elementary e)
  | Div -> operate Div
  | Mod -> operate Mod
  | Bitwise b -> operate (Bitwise b)
  | To_float -> operate To_float
  | Round -> operate Round
  | Floor -> operate Floor
  | Ceiling -> operate Ceiling
  | Truncate -> operate Truncate
  | Equal -> compare Comparison.equal arguments
  | Not_equal ->
      let unequal p target ty a b = Comparison.(not_ p target (equal p Node.Unnamed ty a b)) in
      compare unequal arguments
  | Less -> compare Comparison.less arguments
  | Less_equal -> compare Comparison.less_equal arguments
  | Greater -> compare Comparison.less (List.rev arguments)
  | Greater_equal -> compare Comparison.less_equal (List.rev arguments)
  | Minimum | Maximum -> (
      match (result, arguments) with
      | (Int | Float), _ -> operate (if primitive = Minimum then Minimum else Maximum)
      | _, [ a; b ] -> extreme p target primitive result a.value b.value
      | _, _ -> bug ())
  | And | Or -> (
      (* The operator uses both operands, even if one determines the result, because the causality
         check must see the program as it was written. *)
      let operator : Flow.Ir.operator = if primitive = And then And else Or in
      match List.map atom arguments with
      | [ Bool a; Bool b ] -> Atom (Bool (if primitive = And then a && b else a || b))
      | [ _; _ ] -> operate operator
      | _ -> bug ())
  | Text_of | Blank | Drawn | Together -> Drawing.apply p target primitive ~result arguments
  | Delay | Time | Time_since | Step_time | Ticks | Integral | Derivative | Switch | Delayed_switch
  | Recurring_switch | Delayed_recurring_switch | Initially | On_event | Map_sf | Parallel
  | Make_task | Until_right | Return | Sequence | Run_task | At | Length | Replace | Generate | Map
  | Imap | Zip_with | Foldl | Scanl | Reactimate | Node | Ending | Console _ | Foreign _ ->
      bug ()
