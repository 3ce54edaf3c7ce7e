open Flow

let any rng items = List.nth items (Random.State.int rng (List.length items))
let chance rng percent = Random.State.int rng 100 < percent

(* Chooses an item; the list starts with the newest, and newer items are likelier, so that most
   computed values are used. *)
let recent rng items =
  let n = List.length items in
  List.nth items (min (Random.State.int rng n) (Random.State.int rng n))

let usual = [ 0.; -0.; 1.; -1.; 0.5; 2.; 3.5; -2.5; 0.1; 0.25; 7.; -0.75 ]
let floats = [ infinity; Evaluate.nan; 1e300 ] @ usual @ usual
let ints = [ 0l; 1l; -1l; 2l; 7l; -7l; Int32.max_int; Int32.min_int ]

let maybe =
  {
    Ir.name = "Maybe Float";
    module_ = "Prelude";
    constructors =
      [
        { constructor = "Nothing"; fields = [] };
        { constructor = "Just"; fields = [ ("", Leaf Float) ] };
      ];
  }

let types : Ir.ty list = [ Bool; Int; Float; Float; Float; Sum 0 ]

(* The values that a node can read. *)
type scope = {
  rng : Random.State.t;
  node : Build.node;
  mutable atoms : Ir.atom list;
  mutable static_atoms : Ir.atom list;
}

let type_of : Ir.atom -> Ir.ty = function
  | Signal s -> s.ty
  | Bool _ -> Bool
  | Int _ -> Int
  | Float _ -> Float

let literal rng : Ir.ty -> Ir.atom option = function
  | Bool -> Some (Bool (chance rng 50))
  | Int -> Some (Int (any rng ints))
  | Float -> Some (Float (any rng floats))
  | Sum _ | Array _ | Foreign _ -> None

let define scope ?(static = false) ty rhs =
  let name = if chance scope.rng 50 then any scope.rng [ "x"; "y"; "z"; "v" ] else "" in
  let atom = Build.let_ ~ty scope.node name rhs in
  scope.atoms <- atom :: scope.atoms;
  if static then scope.static_atoms <- atom :: scope.static_atoms;
  atom

let rec choose scope ~static (ty : Ir.ty) =
  let among = if static then scope.static_atoms else scope.atoms in
  match List.filter (fun a -> type_of a = ty) among with
  | _ :: _ as found when chance scope.rng 88 -> recent scope.rng found
  | found -> (
      match (literal scope.rng ty, found) with
      | Some literal, _ -> literal
      | None, _ :: _ -> recent scope.rng found
      | None, [] -> make_sum scope ~static)

and make_sum scope ~static =
  let rhs =
    if chance scope.rng 40 then Ir.Construct { constructor = 0; payload = [] }
    else Construct { constructor = 1; payload = [ choose scope ~static Float ] }
  in
  define scope ~static (Sum 0) rhs

let binary : (Ir.operator * Ir.ty * Ir.ty) list =
  [
    (Add, Float, Float);
    (Subtract, Float, Float);
    (Multiply, Float, Float);
    (Divide, Float, Float);
    (Minimum, Float, Float);
    (Maximum, Float, Float);
    (Equal, Float, Bool);
    (Less, Float, Bool);
    (Less_equal, Float, Bool);
    (Elementary Atan2, Float, Float);
    (Elementary Hypot, Float, Float);
    (Pow, Float, Float);
    (Add, Int, Int);
    (Subtract, Int, Int);
    (Multiply, Int, Int);
    (Div, Int, Int);
    (Mod, Int, Int);
    (Minimum, Int, Int);
    (Maximum, Int, Int);
    (Equal, Int, Bool);
    (Less, Int, Bool);
    (Less_equal, Int, Bool);
    (And, Bool, Bool);
    (Or, Bool, Bool);
  ]

let unary : (Ir.operator * Ir.ty * Ir.ty) list =
  [
    (Negate, Float, Float);
    (Absolute, Float, Float);
    (Signum, Float, Float);
    (Elementary Sqrt, Float, Float);
    (Elementary Floor_float, Float, Float);
    (Elementary Ceiling_float, Float, Float);
    (Elementary Nanoseconds, Float, Float);
    (Elementary Sin, Float, Float);
    (Elementary Cos, Float, Float);
    (Round, Float, Int);
    (Floor, Float, Int);
    (Ceiling, Float, Int);
    (Truncate, Float, Int);
    (Negate, Int, Int);
    (Absolute, Int, Int);
    (Signum, Int, Int);
    (To_float, Int, Float);
    (Not, Bool, Bool);
  ]

let operation scope ~static =
  let pick ty = choose scope ~static ty in
  match Random.State.int scope.rng 11 with
  | 10 ->
      (* a distance from one point to another, and one back *)
      let a = pick Float and b = pick Float and across = pick Float in
      let difference a b = Build.op scope.node Subtract [ a; b ] in
      let even : Ir.operator = any scope.rng [ Ir.Absolute; Elementary Cos; Elementary Hypot ] in
      let size d =
        let arguments : Ir.atom list =
          match even with
          | Elementary Hypot -> any scope.rng [ [ d; across ]; [ across; d ] ]
          | _ -> [ any scope.rng [ d; Build.op scope.node Negate [ d ] ] ]
        in
        ignore (define scope ~static Float (Op (even, arguments)))
      in
      let there = difference a b in
      size there;
      if chance scope.rng 50 then ignore (define scope ~static Float (Copy there));
      size (difference b a)
  | 0 | 1 | 2 | 3 ->
      let operator, argument, result = any scope.rng binary in
      let a = pick argument in
      ignore (define scope ~static result (Op (operator, [ a; pick argument ])))
  | 4 | 5 ->
      let operator, argument, result = any scope.rng unary in
      ignore (define scope ~static result (Op (operator, [ pick argument ])))
  | 6 ->
      let ty = any scope.rng types in
      let condition = pick Bool in
      let then_ = pick ty in
      ignore (define scope ~static ty (If { condition; then_; else_ = pick ty }))
  | 7 when chance scope.rng 30 ->
      let ty = any scope.rng [ (Bool : Ir.ty); Int; Float ] in
      ignore (define scope ~static ty (Build.param ty))
  | 7 ->
      let ty = any scope.rng types in
      ignore (define scope ~static ty (Copy (pick ty)))
  | 8 -> ignore (make_sum scope ~static)
  | _ ->
      (* a payload may be read only after a test of its constructor *)
      let value = pick (Sum 0) in
      let condition = Build.let_ ~ty:Bool scope.node "" (Is_constructor (value, 1)) in
      let then_ = Build.let_ scope.node "" (Payload { value; constructor = 1; leaf = 0 }) in
      ignore (define scope ~static Float (If { condition; then_; else_ = pick Float }))

let stateful scope =
  let pick ty = choose scope ~static:false ty in
  let time restart =
    let t = Build.let_ scope.node "" (Time { restart }) in
    ignore
      (define scope Float
         (if chance scope.rng 50 then Copy t else Op (Elementary Nanoseconds, [ t ])))
  in
  match Random.State.int scope.rng 7 with
  | 0 ->
      let ty = any scope.rng types in
      let init = choose scope ~static:true ty in
      ignore (define scope ty (Delay { init; next = pick ty }))
  | 1 -> time (Bool false)
  | 2 -> ignore (define scope Float (Integral (pick Float)))
  | 3 -> time (pick Bool)
  | 4 -> ignore (define scope Bool (Ticks (choose scope ~static:true Float)))
  | 5 -> ignore (define scope Float Step_time)
  | _ -> ignore (define scope Float (Derivative (pick Float)))

(* The properties of a finished node that its callers need. *)
type callee = {
  index : int;
  kind : Ir.kind;
  static_types : Ir.ty list;
  input_types : Ir.ty list;
  output_types : Ir.ty list;
}

let instance scope ~later callee =
  let statics = List.map (choose scope ~static:true) callee.static_types in
  let argument ty =
    match List.filter (fun (s : Ir.signal) -> s.ty = ty) later with
    | _ :: _ as found when chance scope.rng 25 -> Ir.Signal (any scope.rng found)
    | _ -> choose scope ~static:false ty
  in
  let inputs = List.map argument callee.input_types in
  let outputs =
    List.map
      (fun ty -> Build.declare ~ty scope.node (if chance scope.rng 50 then "out" else ""))
      callee.output_types
  in
  Build.call ~statics scope.node callee.index inputs outputs;
  List.iter (fun s -> scope.atoms <- Ir.Signal s :: scope.atoms) outputs

let some rng most make = List.init (Random.State.int rng (most + 1)) make

let add_node rng program callees ~root =
  let kind : Ir.kind = if (not root) && chance rng 35 then Function else Signal_function in
  let static_types = if root || kind = Function then [] else some rng 2 (fun _ -> any rng types) in
  let input_types = List.init (1 + Random.State.int rng 3) (fun _ -> any rng types) in
  let output_types = List.init (1 + Random.State.int rng 4) (fun _ -> any rng types) in
  let index =
    Build.node ~kind program
      (Printf.sprintf "node%d" (List.length callees))
      (fun node ->
        let statics = List.map (fun ty -> Build.static ~ty node "s") static_types in
        let inputs = List.map (fun ty -> Build.input ~ty node "i") input_types in
        let scope = { rng; node; atoms = inputs @ statics; static_atoms = statics } in
        if kind = Signal_function then
          for _ = 1 to Random.State.int rng 4 do
            operation scope ~static:true
          done;
        (* Signals for feedback: declared here, and read by delays, integrals and (if that
           happens to be causal) instances. *)
        let later =
          if kind = Function then []
          else some rng 3 (fun _ -> Build.declare ~ty:(any rng types) node "later")
        in
        List.iter
          (fun (s : Ir.signal) ->
            if s.ty = Float && chance rng 40 then ignore (define scope Float (Integral (Signal s)))
            else
              let init = choose scope ~static:true s.ty in
              ignore (define scope s.ty (Delay { init; next = Signal s })))
          later;
        let callable =
          List.filter (fun c -> kind = Signal_function || c.kind = Ir.Function) callees
        in
        for _ = 1 to 3 + Random.State.int rng 25 do
          match Random.State.int rng 10 with
          | (0 | 1 | 2) when callable <> [] -> instance scope ~later (any rng callable)
          | (3 | 4) when kind = Signal_function -> stateful scope
          | _ -> operation scope ~static:false
        done;
        List.iter
          (fun (s : Ir.signal) -> Build.define node s (Copy (choose scope ~static:false s.ty)))
          later;
        if root then List.map (fun a -> ("", a)) scope.atoms
        else List.map (fun ty -> ("", choose scope ~static:false ty)) output_types)
  in
  { index; kind; static_types; input_types; output_types }

let program rng =
  let program = Build.create () in
  let rec add callees n =
    let callee = add_node rng program callees ~root:(n = 0) in
    if n > 0 then add (callee :: callees) (n - 1)
  in
  add [] (Random.State.int rng 5);
  Build.program ~sums:[| maybe |] ~params:Build.params program

let instants rng (program : Ir.program) =
  let root = program.nodes.(Array.length program.nodes - 1) in
  let value (s : Ir.signal) : Evaluate.value =
    match s.ty with
    | Bool -> Bool (chance rng 50)
    | Int -> Int (any rng ints)
    | Float -> Float (if chance rng 30 then any rng floats else Random.State.float rng 10.)
    | Array _ | Foreign _ -> failwith "no such value is made"
    | Sum _ -> if chance rng 50 then Sum (0, []) else Sum (1, [ Float (any rng floats) ])
  in
  List.init 6 (fun _ ->
      { Evaluate.dt = any rng [ 0.; 0.1; 0.25; 1. ]; inputs = List.map value root.inputs })
