open Ir

let all = function
  | Copy a
  | Is_constructor (a, _)
  | Payload { value = a; _ }
  | Fill a
  | Index (a, _)
  | Integral a
  | Derivative a
  | Time { restart = a; unit = _ }
  | Ticks a ->
      [ a ]
  | Op (_, arguments) -> arguments
  | If { condition; then_; else_ } -> [ condition; then_; else_ ]
  | Construct { payload; constructor = _ } -> payload
  | Elements atoms -> atoms
  | At { array; index; default } -> [ array; index; default ]
  | Replace { array; index; value } -> [ array; index; value ]
  | Delay { init; next } -> [ init; next ]
  | Absent -> []

let same_instant = function
  | Delay _ | Integral _ -> []
  | ( Copy _ | Is_constructor _ | Payload _ | Derivative _ | Op _ | If _ | Construct _ | Elements _
    | Fill _ | Index _ | At _ | Replace _ | Time _ | Ticks _ | Absent ) as rhs ->
      all rhs

(* Most lists are short; a constructor's payload may be long. *)
let map_list f = function
  | [ a ] -> [ f a ]
  | [ a; b ] ->
      let a = f a in
      [ a; f b ]
  | atoms -> Basis.Long_list.map f atoms

let map f = function
  | Copy a -> Copy (f a)
  | Op (operator, arguments) -> Op (operator, map_list f arguments)
  | If { condition; then_; else_ } ->
      let condition = f condition in
      let then_ = f then_ in
      If { condition; then_; else_ = f else_ }
  | Construct { constructor; payload } -> Construct { constructor; payload = map_list f payload }
  | Is_constructor (a, constructor) -> Is_constructor (f a, constructor)
  | Payload { value; constructor; leaf } -> Payload { value = f value; constructor; leaf }
  | Delay { init; next } ->
      let init = f init in
      Delay { init; next = f next }
  | Elements atoms -> Elements (map_list f atoms)
  | Fill a -> Fill (f a)
  | Index (a, k) -> Index (f a, k)
  | At { array; index; default } ->
      let array = f array in
      let index = f index in
      At { array; index; default = f default }
  | Replace { array; index; value } ->
      let array = f array in
      let index = f index in
      Replace { array; index; value = f value }
  | Time { unit; restart } -> Time { unit; restart = f restart }
  | Ticks a -> Ticks (f a)
  | Absent -> Absent
  | Integral a -> Integral (f a)
  | Derivative a -> Derivative (f a)

let signals = function
  | [] | [ (Bool _ | Int _ | Float _) ] -> []
  | [ Signal s ] -> [ s ]
  | [ Signal s; Signal s' ] -> [ s; s' ]
  | atoms ->
      List.filter_map (function Signal s -> Some s | Bool _ | Int _ | Float _ -> None) atoms

let same (a : Ir.atom) (b : Ir.atom) =
  match (a, b) with
  | Signal a, Signal b -> a.id = b.id
  | Bool a, Bool b -> Bool.equal a b
  | Int a, Int b -> Int32.equal a b
  | Float a, Float b -> Int64.equal (Int64.bits_of_float a) (Int64.bits_of_float b)
  | (Signal _ | Bool _ | Int _ | Float _), _ -> false
