open Ir

let function_ arguments result = List.fold_right (fun a b -> Function (a, b)) arguments result
let unary a = function_ [ a ] a
let binary a = function_ [ a; a ] a
let comparison a = function_ [ a; a ] Bool
let prelude name arguments = Data (({ module_ = "Prelude"; name } : Global.t), arguments)
let event a = prelude "Event" [ a ]
let either a b = prelude "Either" [ a; b ]
let console = Data (({ module_ = "Capability"; name = "Console" } : Global.t), [])
let frame = Data (({ module_ = "Vision"; name = "Frame" } : Global.t), [])
let tag_frame = Data (({ module_ = "Tags"; name = "TagFrame" } : Global.t), [])
let scan n = Data (({ module_ = "Lidar"; name = "Scan" } : Global.t), [ n ])
let imu = Data (({ module_ = "Imu"; name = "Imu" } : Global.t), [])
let task a b c = prelude "Task" [ a; b; c ]
let display name = Data (({ module_ = "Display"; name } : Global.t), [])
let drawing = display "Drawing"
let text = display "Text"
let mark = display "Mark"
let reading : Global.t = { module_ = "Display"; name = "reading" }

let of_control (control : Primitive.console) types =
  match (control, types) with
  | Button, [] -> Some (function_ [ String; console ] (event (Tuple [])))
  | Hold, [] -> Some (function_ [ String; console ] Bool)
  | Knob, [] -> Some (function_ [ String; Float; Float; Float; console ] Float)
  | Toggle, [] -> Some (function_ [ String; Bool; console ] Bool)
  | Map, [] -> Some (function_ [ console ] (event (Tuple [ Float; Float ])))
  | Camera, [] -> Some (function_ [ String; console ] (event frame))
  | Tags, [] -> Some (function_ [ String; console ] (event tag_frame))
  | Lidar, [ n ] -> Some (function_ [ String; console ] (event (scan n)))
  | Imu, [] -> Some (function_ [ String; console ] (event imu))
  | (Button | Hold | Knob | Toggle | Map | Camera | Tags | Lidar | Imu), _ -> None

let of_primitive (p : Primitive.t) types =
  match (p, types) with
  | (Add | Subtract | Multiply | Minimum | Maximum), [ a ] -> Some (binary a)
  | (Negate | Absolute | Signum | Power_literal _), [ a ] -> Some (unary a)
  | (Equal | Not_equal | Less | Less_equal | Greater | Greater_equal), [ a ] -> Some (comparison a)
  | (Divide | Power | Elementary (Hypot | Atan2)), [] -> Some (binary Float)
  | ( Elementary
        ( Sqrt | Floor_float | Ceiling_float | Nanoseconds | Exp | Log | Sin | Cos | Tan | Asin
        | Acos | Atan ),
      [] ) ->
      Some (unary Float)
  | (Div | Mod | Bitwise _), [] -> Some (binary Int)
  | To_float, [] -> Some (Function (Int, Float))
  | (Round | Floor | Ceiling | Truncate), [] -> Some (Function (Float, Int))
  | (And | Or), [] -> Some (binary Bool)
  | Delay, [ a ] -> Some (Function (a, Signal_function (a, a)))
  | (Time | Step_time), [ a ] -> Some (Signal_function (a, Float))
  | Time_since, [] -> Some (Signal_function (Bool, Float))
  | Ticks, [ a ] -> Some (Function (Float, Signal_function (a, Bool)))
  | (Integral | Derivative), [] -> Some (Signal_function (Float, Float))
  | (Switch | Delayed_switch), [ a; b; c ] ->
      let before = Signal_function (a, Tuple [ b; event c ]) in
      let after = Function (c, Signal_function (a, b)) in
      Some (function_ [ before; after ] (Signal_function (a, b)))
  | (Recurring_switch | Delayed_recurring_switch), [ a; b ] ->
      let running = Signal_function (a, b) in
      Some (Function (running, Signal_function (Tuple [ a; event running ], b)))
  | Initially, [ a; b ] ->
      let chosen = Signal_function (a, b) in
      Some (Function (Function (a, chosen), chosen))
  | On_event, [ a; b ] ->
      Some (Function (Signal_function (a, b), Signal_function (event a, event b)))
  | Make_task, [ a; b; c ] ->
      Some (Function (Signal_function (a, Tuple [ b; event c ]), task a b c))
  | Until_right, [ a; b; c ] -> Some (Function (Signal_function (a, either b c), task a b c))
  | Return, [ c; a; b ] -> Some (Function (c, task a b c))
  | Sequence, [ a; b; c; d ] ->
      Some (function_ [ task a b c; Function (c, task a b d) ] (task a b d))
  | Run_task, [ a; b; c ] -> Some (Function (task a b c, Signal_function (a, either b c)))
  | At, [ a; n ] -> Some (function_ [ Int; a; Array (n, a) ] a)
  | Length, [ n; a ] -> Some (Function (Array (n, a), Int))
  | Replace, [ a; n ] -> Some (function_ [ Int; a; Array (n, a) ] (Array (n, a)))
  | Generate, [ a; n ] -> Some (Function (Function (Int, a), Array (n, a)))
  | Map, [ a; b; n ] -> Some (function_ [ Function (a, b); Array (n, a) ] (Array (n, b)))
  | Imap, [ a; b; n ] -> Some (function_ [ function_ [ Int; a ] b; Array (n, a) ] (Array (n, b)))
  | Zip_with, [ a; b; c; n ] ->
      let arguments = [ function_ [ a; b ] c; Array (n, a); Array (n, b) ] in
      Some (function_ arguments (Array (n, c)))
  | Foldl, [ b; a; n ] -> Some (function_ [ function_ [ b; a ] b; b; Array (n, a) ] b)
  | Scanl, [ b; a; n ] -> Some (function_ [ function_ [ b; a ] b; b; Array (n, a) ] (Array (n, b)))
  | Map_sf, [ a; b; n ] ->
      let one = Signal_function (a, b) in
      Some (Function (one, Signal_function (Array (n, a), Array (n, b))))
  | Parallel, [ n; a; b ] ->
      let all : Ir.ty = Array (n, Signal_function (a, b)) in
      Some (Function (all, Signal_function (Array (n, a), Array (n, b))))
  | Reactimate, [ i; o ] -> Some (Function (Signal_function (i, o), prelude "Program" [ i; o ]))
  | Node, [ i; o ] ->
      Some (function_ [ Float; Signal_function (i, o) ] (prelude "Program" [ i; o ]))
  | Console control, types -> of_control control types
  | Ending, [ i; o; c ] ->
      Some (Function (Signal_function (i, Tuple [ o; event c ]), Signal_function (i, o)))
  | Text_of, [] -> Some (Function (String, text))
  | Blank, [] -> Some drawing
  | Drawn, [] -> Some (function_ [ mark; drawing ] drawing)
  | Together, [] -> Some (binary drawing)
  | ( ( Add | Subtract | Multiply | Negate | Absolute | Signum | Divide | Power | Power_literal _
      | Elementary _ | Div | Mod | Bitwise _ | To_float | Round | Floor | Ceiling | Truncate | Equal
      | Not_equal | Less | Less_equal | Greater | Greater_equal | Minimum | Maximum | And | Or
      | Delay | Time | Time_since | Step_time | Ticks | Integral | Derivative | Switch
      | Delayed_switch | Recurring_switch | Delayed_recurring_switch | Initially | On_event
      | Reactimate | Node | Ending | Make_task | Until_right | Return | Sequence | Run_task | At
      | Length | Replace | Generate | Map | Imap | Zip_with | Foldl | Scanl | Map_sf | Parallel
      | Text_of | Blank | Drawn | Together | Foreign _ ),
      _ ) ->
      None
