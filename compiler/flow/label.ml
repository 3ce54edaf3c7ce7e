type t = Equation of Ir.ty * Ir.rhs | Instance of Ir.instance | Output of int

let operands = function
  | Equation (_, rhs) -> Operands.all rhs
  | Instance { statics = []; inputs; _ } -> inputs
  | Instance { statics; inputs; _ } -> List.rev_append (List.rev statics) inputs
  | Output _ -> []

let same_operand (a : Ir.atom) (b : Ir.atom) =
  match (a, b) with Signal _, Signal _ -> true | _, _ -> Operands.same a b

let same_operands a b = List.compare_lengths a b = 0 && List.for_all2 same_operand a b

(* But for its operands. *)
let same_operation (a : Ir.rhs) (b : Ir.rhs) =
  match (a, b) with
  | Op (operator, _), Op (operator', _) -> operator == operator' || operator = operator'
  | Construct { constructor = k; _ }, Construct { constructor = k'; _ }
  | Is_constructor (_, k), Is_constructor (_, k')
  | Index (_, k), Index (_, k') ->
      Int.equal k k'
  | Payload { constructor; leaf; _ }, Payload { constructor = constructor'; leaf = leaf'; _ } ->
      Int.equal constructor constructor' && Int.equal leaf leaf'
  | Time { unit; _ }, Time { unit = unit'; _ } -> unit = unit'
  | Copy _, Copy _
  | If _, If _
  | Delay _, Delay _
  | Elements _, Elements _
  | Fill _, Fill _
  | At _, At _
  | Replace _, Replace _
  | Absent, Absent
  | Step_time, Step_time
  | Ticks _, Ticks _
  | Integral _, Integral _
  | Derivative _, Derivative _ ->
      true
  | ( ( Copy _ | Op _ | If _ | Construct _ | Is_constructor _ | Payload _ | Delay _ | Elements _
      | Fill _ | Index _ | At _ | Replace _ | Absent | Time _ | Step_time | Ticks _ | Integral _
      | Derivative _ ),
      _ ) ->
      false

let number_of_operation (rhs : Ir.rhs) =
  match rhs with
  | Op (operator, _) -> Hashtbl.hash operator
  | Construct { constructor; _ } -> 100 + constructor
  | Is_constructor (_, constructor) -> 200 + constructor
  | Payload { constructor; leaf; _ } -> 300 + (10 * constructor) + leaf
  | Index (_, k) -> 400 + k
  | Copy _ -> 1
  | If _ -> 2
  | Delay _ -> 3
  | Elements _ -> 4
  | Fill _ -> 5
  | At _ -> 6
  | Replace _ -> 7
  | Absent -> 8
  | Time _ -> 9
  | Ticks _ -> 10
  | Integral _ -> 11
  | Derivative _ -> 12
  | Step_time -> 13

let hash_operand (a : Ir.atom) =
  match a with
  | Signal _ -> 1
  | Bool b -> if b then 2 else 3
  | Int n -> 4 + Int32.to_int n
  | Float x -> Hashtbl.hash x

let hash_operands start operands =
  List.fold_left (fun h a -> ((h * 65_599) + hash_operand a) land max_int) start operands

let hash label =
  match label with
  | Equation (_, rhs) -> hash_operands (number_of_operation rhs) (Operands.all rhs)
  | Instance i -> hash_operands (1_000 + i.node) (operands label)
  | Output k -> 500 + k

module Table = Hashtbl.Make (struct
  type nonrec t = t

  let hash = hash

  let equal a b =
    match (a, b) with
    | Equation (ty, rhs), Equation (ty', rhs') ->
        (ty == ty' || ty = ty')
        && same_operation rhs rhs'
        && same_operands (Operands.all rhs) (Operands.all rhs')
    | Instance i, Instance i' ->
        Int.equal i.node i'.node && i.loop = i'.loop
        && same_operands (operands a) (operands b)
    | Output k, Output k' -> Int.equal k k'
    | (Equation _ | Instance _ | Output _), _ -> false
end)
