exception Foreign_code of string

let bug (p : Core.Primitive.t) =
  Basis.Diagnostic.bug ~stage:"Interp" "`%s` is applied to values of unexpected types"
    (Core.Primitive_table.name p)

let float : Value.t -> float = function
  | Float x -> x
  | Bool _ | Int _ | Text _ | Drawing _ | Image _ | Tuple _ | Array _ | Data _ | Function _
  | Signal_function _ | Task _ | Ending _ ->
      Basis.Diagnostic.bug ~stage:"Interp" "a value that is not a Float"

let values real (p : Core.Primitive.t) (arguments : Value.t list) : Value.t =
  match (p, arguments) with
  | Add, [ Int a; Int b ] -> Int (Int32.add a b)
  | Add, [ Float a; Float b ] -> Float (Number.Float.add real a b)
  | Subtract, [ Int a; Int b ] -> Int (Int32.sub a b)
  | Subtract, [ Float a; Float b ] -> Float (Number.Float.subtract real a b)
  | Multiply, [ Int a; Int b ] -> Int (Int32.mul a b)
  | Multiply, [ Float a; Float b ] -> Float (Number.Float.multiply real a b)
  | Negate, [ Int a ] -> Int (Int32.neg a)
  | Negate, [ Float a ] -> Float (-.a)
  | Absolute, [ Int a ] -> Int (Number.Int.absolute a)
  | Absolute, [ Float a ] -> Float (Float.abs a)
  | Signum, [ Int a ] -> Int (Number.Int.signum a)
  | Signum, [ Float a ] -> Float (Number.Float.signum a)
  | Divide, [ Float a; Float b ] -> Float (Number.Float.divide real a b)
  | Power, [ Float a; Float b ] -> Float (Number.Float.pow real a b)
  | Power_literal k, [ Int a ] -> Int (Number.Int.power a k)
  | Power_literal k, [ Float a ] -> Float (Number.Float.power real a k)
  | Elementary f, _ -> Float (Number.Float.elementary real f (List.map float arguments))
  | Div, [ Int a; Int b ] -> Int (Number.Int.div a b)
  | Mod, [ Int a; Int b ] -> Int (Number.Int.modulo a b)
  | Bitwise operation, [ Int a; Int b ] -> Int (Number.Int.bitwise operation a b)
  | To_float, [ Int a ] -> Float (Basis.Real.round real (Int32.to_float a))
  | Round, [ Float a ] -> Int (Number.round a)
  | Floor, [ Float a ] -> Int (Number.floor a)
  | Ceiling, [ Float a ] -> Int (Number.ceiling a)
  | Truncate, [ Float a ] -> Int (Number.truncate a)
  | Equal, [ a; b ] -> Bool (Comparison.equal a b)
  | Not_equal, [ a; b ] -> Bool (not (Comparison.equal a b))
  | Less, [ a; b ] -> Bool (Comparison.less a b)
  | Less_equal, [ a; b ] -> Bool (Comparison.less_equal a b)
  | Greater, [ a; b ] -> Bool (Comparison.less b a)
  | Greater_equal, [ a; b ] -> Bool (Comparison.less_equal b a)
  | Minimum, [ Float a; Float b ] -> Float (Number.Float.minimum a b)
  | Minimum, [ a; b ] -> if Comparison.less b a then b else a
  | Maximum, [ Float a; Float b ] -> Float (Number.Float.maximum a b)
  | Maximum, [ a; b ] -> if Comparison.less a b then b else a
  | ( ( Add | Subtract | Multiply | Negate | Absolute | Signum | Divide | Power | Power_literal _
      | Div | Mod | Bitwise _ | To_float | Round | Floor | Ceiling | Truncate | Equal | Not_equal
      | Less | Less_equal | Greater | Greater_equal | Minimum | Maximum | And | Or | Delay | Time
      | Time_since | Step_time | Ticks | Integral | Derivative | Switch | Delayed_switch
      | Recurring_switch | Delayed_recurring_switch | Initially | On_event | Map_sf | Parallel
      | Make_task | Until_right | Return | Sequence | Run_task | At | Length | Replace | Generate
      | Map | Imap | Zip_with | Foldl | Scanl | Reactimate | Node | Ending | Console _ | Text_of
      | Blank | Drawn | Together ),
      _ ) ->
      bug p
  | Foreign f, _ -> raise_notrace (Foreign_code f.foreign_name)

let bool p : Value.t -> bool = function
  | Bool b -> b
  | Int _ | Float _ | Text _ | Drawing _ | Image _ | Tuple _ | Array _ | Data _ | Function _
  | Signal_function _ | Task _ | Ending _ ->
      bug p

let marks p : Value.t -> Value.thunk list = function
  | Drawing marks -> marks
  | Bool _ | Int _ | Float _ | Text _ | Image _ | Tuple _ | Array _ | Data _ | Function _
  | Signal_function _ | Task _ | Ending _ ->
      bug p

let apply real (p : Core.Primitive.t) arguments : Value.t =
  match (p, arguments) with
  | And, [ a; b ] -> Bool (bool p (Thunk.force a) && bool p (Thunk.force b))
  | Or, [ a; b ] -> Bool (bool p (Thunk.force a) || bool p (Thunk.force b))
  | Text_of, [ text ] -> Thunk.force text
  | Blank, [] -> Drawing []
  | Drawn, [ mark; below ] -> Drawing (mark :: marks p (Thunk.force below))
  | Together, [ below; above ] ->
      let above = marks p (Thunk.force above) in
      Drawing (above @ marks p (Thunk.force below))
  | _, _ -> values real p (List.map Thunk.force arguments)
