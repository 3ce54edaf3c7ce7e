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
  | Absent | Step_time -> []

let same_instant = function
  | Delay _ | Integral _ -> []
  | ( Copy _ | Is_constructor _ | Payload _ | Derivative _ | Op _ | If _ | Construct _ | Elements _
    | Fill _ | Index _ | At _ | Replace _ | Time _ | Step_time | Ticks _ | Absent ) as rhs ->
      all rhs

let fold f start = function
  | Copy a
  | Is_constructor (a, _)
  | Payload { value = a; _ }
  | Fill a
  | Index (a, _)
  | Integral a
  | Derivative a
  | Time { restart = a; unit = _ }
  | Ticks a ->
      f start a
  | Op (_, atoms) | Construct { payload = atoms; constructor = _ } | Elements atoms ->
      List.fold_left f start atoms
  | If { condition = a; then_ = b; else_ = c }
  | At { array = a; index = b; default = c }
  | Replace { array = a; index = b; value = c } ->
      f (f (f start a) b) c
  | Delay { init; next } -> f (f start init) next
  | Absent | Step_time -> start

(* Most lists are short; a constructor's payload may be long. *)
let map_list f atoms =
  match atoms with
  | [ a ] ->
      let mapped = f a in
      if mapped == a then atoms else [ mapped ]
  | [ a; b ] ->
      let mapped = f a in
      let mapped' = f b in
      if mapped == a && mapped' == b then atoms else [ mapped; mapped' ]
  | _ ->
      let mapped = Basis.Long_list.map f atoms in
      if List.for_all2 ( == ) mapped atoms then atoms else mapped

(* Passes mostly find nothing to change: then the right side stays the very same, which
   takes no memory. *)
let map1 f rhs a make =
  let a' = f a in
  if a' == a then rhs else make a'

let map2 f rhs a b make =
  let a' = f a in
  let b' = f b in
  if a' == a && b' == b then rhs else make a' b'

let map3 f rhs a b c make =
  let a' = f a in
  let b' = f b in
  let c' = f c in
  if a' == a && b' == b && c' == c then rhs else make a' b' c'

let map_all f rhs atoms make =
  let mapped = map_list f atoms in
  if mapped == atoms then rhs else make mapped

let map f rhs =
  match rhs with
  | Copy a -> map1 f rhs a (fun a -> Copy a)
  | Op (operator, arguments) -> map_all f rhs arguments (fun arguments -> Op (operator, arguments))
  | If { condition; then_; else_ } ->
      map3 f rhs condition then_ else_ (fun condition then_ else_ -> If { condition; then_; else_ })
  | Construct { constructor; payload } ->
      map_all f rhs payload (fun payload -> Construct { constructor; payload })
  | Is_constructor (a, constructor) -> map1 f rhs a (fun a -> Is_constructor (a, constructor))
  | Payload { value; constructor; leaf } ->
      map1 f rhs value (fun value -> Payload { value; constructor; leaf })
  | Delay { init; next } -> map2 f rhs init next (fun init next -> Delay { init; next })
  | Elements atoms -> map_all f rhs atoms (fun atoms -> Elements atoms)
  | Fill a -> map1 f rhs a (fun a -> Fill a)
  | Index (a, k) -> map1 f rhs a (fun a -> Index (a, k))
  | At { array; index; default } ->
      map3 f rhs array index default (fun array index default -> At { array; index; default })
  | Replace { array; index; value } ->
      map3 f rhs array index value (fun array index value -> Replace { array; index; value })
  | Time { unit; restart } -> map1 f rhs restart (fun restart -> Time { unit; restart })
  | Ticks a -> map1 f rhs a (fun a -> Ticks a)
  | Absent | Step_time -> rhs
  | Integral a -> map1 f rhs a (fun a -> Integral a)
  | Derivative a -> map1 f rhs a (fun a -> Derivative a)

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
