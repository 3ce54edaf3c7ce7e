open Ir

let all = function
  | Copy a
  | Is_constructor (a, _)
  | Payload { value = a; _ }
  | Fill a
  | Index (a, _)
  | Integral a
  | Derivative a
  | Time { restart = a }
  | Ticks a ->
      [ a ]
  | Op (_, arguments) -> arguments
  | If { condition; then_; else_ } -> [ condition; then_; else_ ]
  | Construct { payload; constructor = _ } -> payload
  | Elements atoms -> atoms
  | At { array; index; default } -> [ array; index; default ]
  | Replace { array; index; value } -> [ array; index; value ]
  | Delay { init; next } -> [ init; next ]
  | Param _ | Absent | Step_time -> []

let same_instant = function
  | Delay _ | Integral _ -> []
  | ( Copy _ | Is_constructor _ | Payload _ | Derivative _ | Op _ | If _ | Construct _ | Elements _
    | Fill _ | Index _ | At _ | Replace _ | Time _ | Step_time | Ticks _ | Param _ | Absent ) as rhs
    ->
      all rhs

(* Handles short lists separately, because they are common. Other lists, such as the payload of a
   constructor, may be long. *)
let map_list f atoms =
  match atoms with
  | [ a ] -> [ f a ]
  | [ a; b ] ->
      let first = f a in
      [ first; f b ]
  | _ -> Basis.Long_list.map f atoms

let with_operands rhs (operands : atom list) =
  match (rhs, operands) with
  | Copy _, [ a ] -> Copy a
  | Is_constructor (_, constructor), [ a ] -> Is_constructor (a, constructor)
  | Payload p, [ value ] -> Payload { p with value }
  | Fill _, [ a ] -> Fill a
  | Index (_, k), [ a ] -> Index (a, k)
  | Integral _, [ a ] -> Integral a
  | Derivative _, [ a ] -> Derivative a
  | Time _, [ restart ] -> Time { restart }
  | Ticks _, [ a ] -> Ticks a
  | Op (operator, _), arguments -> Op (operator, arguments)
  | If _, [ condition; then_; else_ ] -> If { condition; then_; else_ }
  | Construct c, payload -> Construct { c with payload }
  | Elements _, atoms -> Elements atoms
  | At _, [ array; index; default ] -> At { array; index; default }
  | Replace _, [ array; index; value ] -> Replace { array; index; value }
  | Delay _, [ init; next ] -> Delay { init; next }
  | rhs, _ -> rhs

(* Most passes change nothing. Returning the same right-hand side then saves an allocation. *)
let map f rhs =
  let before = all rhs in
  let after = map_list f before in
  if List.for_all2 ( == ) after before then rhs else with_operands rhs after

let signals = function
  | [] | [ (Bool _ | Int _ | Float _) ] -> []
  | [ Signal s ] -> [ s ]
  | [ Signal s; Signal s' ] -> [ s; s' ]
  | atoms ->
      List.filter_map (function Signal s -> Some s | Bool _ | Int _ | Float _ -> None) atoms

let ty : Ir.atom -> Ir.ty = function
  | Signal s -> s.ty
  | Bool _ -> Bool
  | Int _ -> Int
  | Float _ -> Float

type key = Signal of int | Bool of bool | Int of int32 | Float of int64

let key : Ir.atom -> key = function
  | Signal s -> Signal s.id
  | Bool b -> Bool b
  | Int n -> Int n
  | Float x -> Float (Int64.bits_of_float x)

let same (a : Ir.atom) (b : Ir.atom) =
  match (a, b) with
  | Signal a, Signal b -> a.id = b.id
  | (Signal _ | Bool _ | Int _ | Float _), _ -> key a = key b

let of_instance atom signal (i : instance) =
  let trial (t : trial) : trial =
    { gives = List.map signal t.gives; given = List.map (Option.map atom) t.given }
  in
  {
    i with
    statics = Basis.Long_list.map atom i.statics;
    inputs = Basis.Long_list.map atom i.inputs;
    outputs = Basis.Long_list.map signal i.outputs;
    trials = List.map trial i.trials;
  }
