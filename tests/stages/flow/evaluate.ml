open Flow

type value =
  | Bool of bool
  | Int of int32
  | Float of float
  | Sum of int * value list
  | Array of value list

type instant = { dt : float; inputs : value list }

let rec equal a b =
  match (a, b) with
  | Bool a, Bool b -> Bool.equal a b
  | Int a, Int b -> Int32.equal a b
  | Float a, Float b ->
      (Float.is_nan a && Float.is_nan b)
      || Int64.equal (Int64.bits_of_float a) (Int64.bits_of_float b)
  | Sum (a, payload), Sum (b, other) -> a = b && List.for_all2 equal payload other
  | Array a, Array b -> List.for_all2 equal a b
  | (Bool _ | Int _ | Float _ | Sum _ | Array _), _ -> false

let rec show = function
  | Bool b -> string_of_bool b
  | Int n -> Int32.to_string n
  | Float x -> Printf.sprintf "%h" x
  | Sum (c, payload) -> Printf.sprintf "#%d(%s)" c (String.concat ", " (List.map show payload))
  | Array elements -> Printf.sprintf "[%s]" (String.concat ", " (List.map show elements))

(* A quiet NaN; OCaml's own was signaling before 5.1. *)
let nan = Int64.float_of_bits 0x7ff8_0000_0000_0000L

let floor_div a b =
  if b = 0l then 0l
  else
    let a = Int32.to_int a and b = Int32.to_int b in
    Int32.of_float (Float.floor (float_of_int a /. float_of_int b))

let to_int x =
  if Float.is_nan x then 0l else Int32.of_float (Float.min 2147483647. (Float.max (-2147483648.) x))

let half_away x = if x < 0. then Float.ceil (x -. 0.5) else Float.floor (x +. 0.5)

let elementary (f : Core.Primitive.elementary) arguments =
  let module Elementary = (val Elementary.of_precision Double) in
  match (f, arguments) with
  | Sqrt, [ x ] -> sqrt x
  | Floor_float, [ x ] -> Float.floor x
  | Ceiling_float, [ x ] -> Float.ceil x
  | Nanoseconds, [ x ] -> Clock.nanoseconds Double x
  | Hypot, [ x; y ] -> Elementary.hypot x y
  | Exp, [ x ] -> Elementary.exp x
  | Log, [ x ] -> Elementary.log x
  | Sin, [ x ] -> Elementary.sin x
  | Cos, [ x ] -> Elementary.cos x
  | Tan, [ x ] -> Elementary.tan x
  | Asin, [ x ] -> Elementary.asin x
  | Acos, [ x ] -> Elementary.acos x
  | Atan, [ x ] -> Elementary.atan x
  | Atan2, [ x; y ] -> Elementary.atan2 x y
  | _ -> failwith "arity"

let operation (operator : Ir.operator) arguments =
  match (operator, arguments) with
  | Add, [ Int a; Int b ] -> Int (Int32.add a b)
  | Subtract, [ Int a; Int b ] -> Int (Int32.sub a b)
  | Multiply, [ Int a; Int b ] -> Int (Int32.mul a b)
  | Div, [ Int a; Int b ] ->
      (* exact in double precision except for this overflow *)
      Int (if b = -1l then Int32.neg a else floor_div a b)
  | Mod, [ Int a; Int b ] ->
      let q = if b = -1l then Int32.neg a else floor_div a b in
      Int (if b = 0l then 0l else Int32.sub a (Int32.mul q b))
  | Negate, [ Int a ] -> Int (Int32.neg a)
  | Absolute, [ Int a ] -> Int (if Int32.compare a 0l < 0 then Int32.neg a else a)
  | Signum, [ Int a ] -> Int (Int32.of_int (compare a 0l))
  | Equal, [ Bool a; Bool b ] -> Bool (a = b)
  | Equal, [ Int a; Int b ] -> Bool (a = b)
  | Less, [ Int a; Int b ] -> Bool (a < b)
  | Less_equal, [ Int a; Int b ] -> Bool (a <= b)
  | Minimum, [ Int a; Int b ] -> Int (min a b)
  | Maximum, [ Int a; Int b ] -> Int (max a b)
  | To_float, [ Int a ] -> Float (Int32.to_float a)
  | Add, [ Float a; Float b ] -> Float (a +. b)
  | Subtract, [ Float a; Float b ] -> Float (a -. b)
  | Multiply, [ Float a; Float b ] -> Float (a *. b)
  | Divide, [ Float a; Float b ] -> Float (a /. b)
  | Negate, [ Float a ] -> Float (-.a)
  | Absolute, [ Float a ] -> Float (Float.abs a)
  | Signum, [ Float a ] -> Float (if a > 0. then 1. else if a < 0. then -1. else a)
  | Equal, [ Float a; Float b ] -> Bool (a = b)
  | Less, [ Float a; Float b ] -> Bool (a < b)
  | Less_equal, [ Float a; Float b ] -> Bool (a <= b)
  | (Minimum | Maximum), [ Float a; Float b ] when Float.is_nan a || Float.is_nan b -> Float nan
  | Minimum, [ Float a; Float b ] -> Float (if b < a then b else a)
  | Maximum, [ Float a; Float b ] -> Float (if b > a then b else a)
  | Pow, [ Float a; Float b ] -> Float (Float.pow a b)
  | Round, [ Float a ] -> Int (to_int (half_away a))
  | Floor, [ Float a ] -> Int (to_int (Float.floor a))
  | Ceiling, [ Float a ] -> Int (to_int (Float.ceil a))
  | Truncate, [ Float a ] -> Int (to_int (Float.trunc a))
  | Elementary f, arguments ->
      Float (elementary f (List.map (function Float x -> x | _ -> failwith "type") arguments))
  | Not, [ Bool a ] -> Bool (not a)
  | And, [ Bool a; Bool b ] -> Bool (a && b)
  | Or, [ Bool a; Bool b ] -> Bool (a || b)
  | _ -> failwith "ill-typed operation"

let rec zero : Ir.ty -> value = function
  | Bool -> Bool false
  | Int -> Int 0l
  | Float -> Float 0.
  | Sum _ -> failwith "a sum in a payload"
  | Foreign _ -> failwith "a foreign value"
  | Array (n, element) -> Array (List.init n (fun _ -> zero element))

let is_true = function Bool b -> b | Int _ | Float _ | Sum _ | Array _ -> failwith "not a Bool"
let number = function Float x -> x | Bool _ | Int _ | Sum _ | Array _ -> failwith "not a Float"

let elements = function
  | Array elements -> elements
  | Bool _ | Int _ | Float _ | Sum _ -> failwith "not an array"

(* Converts an index; a negative one becomes an index beyond every array. *)
let position = function
  | Int n -> if n < 0l then max_int else Int32.to_int n
  | Bool _ | Float _ | Sum _ | Array _ -> failwith "not an Int"

(* The state of a stateful equation: see {!advance}. *)
type memory = { past : value; total : float }
type clock = { dt : float; time : float; first : bool }

let time clock read memory (e : Ir.equation) (restart : Ir.atom) =
  if restart = Bool false then clock.time
  else if clock.first || is_true (read restart) then 0.
  else (memory e).total +. clock.dt

let since_tick clock memory (e : Ir.equation) =
  if clock.first then 0. else (memory e).total +. Clock.nanoseconds Double clock.dt

let is_due period time = period < 1. || Float.trunc period <= time

(* The value of an equation, given functions that read operands and memory. *)
let value clock read memory (e : Ir.equation) =
  match e.rhs with
  | Copy a -> read a
  | Param _ -> (
      (* Values other than the default. *)
      match e.defines.ty with
      | Bool -> Bool true
      | Int -> Int 7l
      | Float -> Float (-3.25)
      | Sum _ | Array _ | Foreign _ -> failwith "a parameter that is no number")
  | Absent -> failwith "a foreign value"
  | Op (operator, arguments) -> operation operator (List.map read arguments)
  | If { condition; then_; else_ } -> if is_true (read condition) then read then_ else read else_
  | Construct { constructor; payload } -> Sum (constructor, List.map read payload)
  | Is_constructor (a, constructor) -> (
      match read a with
      | Sum (c, _) -> Bool (c = constructor)
      | Bool _ | Int _ | Float _ | Array _ -> failwith "not a sum")
  | Payload { value; constructor; leaf } -> (
      match read value with
      | Sum (c, payload) when c = constructor -> List.nth payload leaf
      | Sum _ -> zero e.defines.ty
      | Bool _ | Int _ | Float _ | Array _ -> failwith "not a sum")
  | Elements atoms -> Array (List.map read atoms)
  | Fill a -> (
      match e.defines.ty with
      | Array (n, _) -> Array (List.init n (fun _ -> read a))
      | Bool | Int | Float | Sum _ | Foreign _ -> failwith "not an array")
  | Index (a, k) -> List.nth (elements (read a)) k
  | At { array; index; default } ->
      Option.value
        (List.nth_opt (elements (read array)) (position (read index)))
        ~default:(read default)
  | Replace { array; index; value } ->
      let k = position (read index) in
      Array (List.mapi (fun i x -> if i = k then read value else x) (elements (read array)))
  | Time { restart } -> Float (time clock read memory e restart)
  | Step_time -> Float (if clock.first then 0. else clock.dt)
  | Ticks period -> Bool (is_due (number (read period)) (since_tick clock memory e))
  | Delay { init; _ } -> if clock.first then read init else (memory e).past
  | Integral _ ->
      if clock.first then Float 0.
      else
        let m = memory e in
        Float (m.total +. (clock.dt *. number m.past))
  | Derivative a ->
      if clock.first then Float 0.
      else
        let m = memory e in
        if clock.dt = 0. then Float m.total
        else Float ((number (read a) -. number m.past) /. clock.dt)

(* The state for the next instant, given the current value [now]. *)
let advance clock read memory now (e : Ir.equation) =
  match e.rhs with
  | Delay { next; _ } -> Some { past = read next; total = 0. }
  | Integral a | Derivative a -> Some { past = read a; total = number now }
  | Time { restart } -> Some { past = now; total = time clock read memory e restart }
  | Ticks period ->
      let period = number (read period) and time = since_tick clock memory e in
      let rest = if period < 1. then 0. else Float.rem time (Float.trunc period) in
      Some { past = now; total = (if is_due period time then rest else time) }
  | Copy _ | Op _ | If _ | Construct _ | Is_constructor _ | Payload _ | Elements _ | Param _
  | Absent | Fill _ | Index _ | At _ | Replace _ | Step_time ->
      None

let constant : Ir.atom -> value option = function
  | Bool b -> Some (Bool b)
  | Int n -> Some (Int n)
  | Float x -> Some (Float x)
  | Signal _ -> None

(* An instance of a node, with its state. *)
type frame = {
  node : Ir.node;
  children : (string * frame) list;
  now : (int, value) Hashtbl.t;  (** values at this instant *)
  memory : (int, memory) Hashtbl.t;
  schedule : Schedule.item list;
}

let rec frame schedule (program : Ir.program) index =
  let node = program.nodes.(index) in
  {
    node;
    children =
      List.map (fun (i : Ir.instance) -> (i.name, frame schedule program i.node)) node.instances;
    now = Hashtbl.create 16;
    memory = Hashtbl.create 16;
    schedule = schedule node;
  }

let rec forget frame =
  Hashtbl.reset frame.now;
  List.iter (fun (_, child) -> forget child) frame.children

let remembered frame (e : Ir.equation) = Hashtbl.find frame.memory e.defines.id

let over_time root instants step =
  let time = ref 0. in
  List.mapi
    (fun k { dt; inputs } ->
      let first = k = 0 in
      let dt = if first then 0. else dt in
      time := !time +. dt;
      let outputs = step { dt; time = !time; first } inputs in
      forget root;
      outputs)
    instants

let root_index (program : Ir.program) = Array.length program.nodes - 1

(* {1 By demand} *)

let by_demand (program : Ir.program) instants =
  let root = frame (fun _ -> []) program (root_index program) in
  let advances = ref [] in
  (* [argument] asks the caller for a parameter's value. *)
  let rec ask clock frame argument (a : Ir.atom) =
    match (constant a, a) with
    | Some v, _ -> v
    | None, Signal s -> (
        match Hashtbl.find_opt frame.now s.id with
        | Some v -> v
        | None ->
            let v = compute clock frame argument s in
            Hashtbl.replace frame.now s.id v;
            v)
    | None, (Bool _ | Int _ | Float _) -> assert false
  and compute clock frame argument (s : Ir.signal) =
    let is (other : Ir.signal) = other.id = s.id in
    match List.find_opt (fun (e : Ir.equation) -> is e.defines) frame.node.equations with
    | Some e -> value clock (ask clock frame argument) (remembered frame) e
    | None -> (
        match
          List.find_opt (fun (i : Ir.instance) -> List.exists is i.outputs) frame.node.instances
        with
        | None -> argument s
        | Some i ->
            let child = List.assoc i.name frame.children in
            let outputs = List.combine i.outputs child.node.outputs in
            let _, (_, a) = List.find (fun (o, _) -> is o) outputs in
            ask clock child (passed clock frame argument child i) a)
  and passed clock frame argument child (i : Ir.instance) (parameter : Ir.signal) =
    let pairs = List.combine (child.node.statics @ child.node.inputs) (i.statics @ i.inputs) in
    let _, a = List.find (fun ((p : Ir.signal), _) -> p.id = parameter.id) pairs in
    ask clock frame argument a
  in
  let rec remember clock frame argument =
    List.iter
      (fun (e : Ir.equation) ->
        let read = ask clock frame argument in
        match advance clock read (remembered frame) (read (Signal e.defines)) e with
        | Some m -> advances := (frame, e.defines.id, m) :: !advances
        | None -> ())
      frame.node.equations;
    List.iter
      (fun (i : Ir.instance) ->
        let child = List.assoc i.name frame.children in
        remember clock child (passed clock frame argument child i))
      frame.node.instances
  in
  over_time root instants (fun clock inputs ->
      let values = List.combine root.node.inputs inputs in
      let argument (s : Ir.signal) =
        snd (List.find (fun ((i : Ir.signal), _) -> i.id = s.id) values)
      in
      let outputs = List.map (fun (_, a) -> ask clock root argument a) root.node.outputs in
      advances := [];
      remember clock root argument;
      List.iter (fun (frame, id, m) -> Hashtbl.replace frame.memory id m) !advances;
      outputs)

(* {1 By schedule} *)

let read table (a : Ir.atom) =
  match (constant a, a) with
  | Some v, _ -> v
  | None, Signal s -> (
      match Hashtbl.find_opt table s.id with
      | Some v -> v
      | None -> failwith (Printf.sprintf "signal %s (%d) is read before it is computed" s.name s.id)
      )
  | None, (Bool _ | Int _ | Float _) -> assert false

let start : clock = { dt = 0.; time = 0.; first = true }
let bind table = List.iter2 (fun (s : Ir.signal) v -> Hashtbl.replace table s.id v)

(* Switches are tested with whole programs, in tests/meaning/switch. *)
let no_machines () = invalid_arg "Evaluate: a machine"

let rec call frame clock statics inputs =
  bind frame.now frame.node.statics statics;
  bind frame.now frame.node.inputs inputs;
  List.iter (run frame clock frame.now) frame.schedule;
  let outputs = List.map (fun (_, a) -> read frame.now a) frame.node.outputs in
  let advance_equation (e : Ir.equation) =
    let now = Hashtbl.find frame.now e.defines.id in
    Option.map
      (fun m -> (e.defines.id, m))
      (advance clock (read frame.now) (remembered frame) now e)
  in
  let memories = List.filter_map advance_equation frame.node.equations in
  List.iter (fun (id, m) -> Hashtbl.replace frame.memory id m) memories;
  outputs

and run frame clock table = function
  | Schedule.Equation ({ rhs = Delay _; _ } as e) ->
      Hashtbl.replace table e.defines.id (remembered frame e).past
  | Equation e -> Hashtbl.replace table e.defines.id (value clock (read table) (remembered frame) e)
  | Instance i ->
      let child = List.assoc i.name frame.children in
      let values = List.map (read table) in
      bind table i.outputs (call child clock (values i.statics) (values i.inputs));
      (* a function may be called several times in an instant *)
      if child.node.kind = Function then forget child
  | Trial _ | Machine _ -> no_machines ()

(* Computes the signals that depend on statics alone, in the order of the step. *)
let rec reset frame statics =
  let table = Hashtbl.create 16 in
  bind table frame.node.statics statics;
  let known : Ir.atom -> bool = function
    | Signal s -> Hashtbl.mem table s.id
    | Bool _ | Int _ | Float _ -> true
  in
  let is_static = function
    | Schedule.Equation { rhs = Delay _ | Time _ | Integral _ | Derivative _; _ } -> false
    | Equation e -> List.for_all known (Operands.all e.rhs)
    | Instance i ->
        let child = List.assoc i.name frame.children in
        child.node.kind = Function && List.for_all known i.inputs
    | Trial _ | Machine _ -> no_machines ()
  in
  List.iter (fun item -> if is_static item then run frame start table item) frame.schedule;
  List.iter
    (function
      | { Ir.rhs = Delay { init; _ }; defines; _ } ->
          Hashtbl.replace frame.memory defines.id { past = read table init; total = 0. }
      | _ -> ())
    frame.node.equations;
  List.iter
    (fun (i : Ir.instance) ->
      let child = List.assoc i.name frame.children in
      if child.node.kind = Signal_function then reset child (List.map (read table) i.statics))
    frame.node.instances

let by_schedule (program : Ir.program) instants =
  let root = frame Schedule.of_node program (root_index program) in
  reset root [];
  over_time root instants (fun clock inputs -> call root clock [] inputs)
