open Basis
open Flow

type t = { mutable nodes : Ir.node list; mutable next : int }

type node = {
  program : t;
  file : string;
  mutable line : int;
  mutable statics : Ir.signal list;
  mutable inputs : Ir.signal list;
  mutable equations : Ir.equation list;
  mutable instances : Ir.instance list;
}

let create () = { nodes = []; next = 0 }

let span file line =
  Span.make ~file ~start:(Span.position ~line ~column:1) ~stop:(Span.position ~line ~column:9)

let node ?(kind = Ir.Signal_function) ?(file = "test.frob") program name outputs =
  let b = { program; file; line = 0; statics = []; inputs = []; equations = []; instances = [] } in
  let outputs = outputs b in
  let node =
    {
      Ir.name;
      origin = name;
      kind;
      statics = List.rev b.statics;
      inputs = List.rev b.inputs;
      outputs;
      equations = List.rev b.equations;
      instances = List.rev b.instances;
      machine = None;
      foreign = None;
      transitions = [];
      span = span file 1;
      file;
    }
  in
  program.nodes <- node :: program.nodes;
  List.length program.nodes - 1

let declare ?(ty : Ir.ty = Float) ?line ?group_of b name =
  let id = b.program.next in
  b.program.next <- id + 1;
  b.line <- b.line + 1;
  let group = match group_of with Some (s : Ir.signal) -> s.group | None -> id in
  { Ir.id; name; ty; group; span = span b.file (Option.value line ~default:b.line) }

let static ?ty b name =
  let s = declare ?ty b name in
  b.statics <- s :: b.statics;
  Ir.Signal s

let input ?ty b name =
  let s = declare ?ty b name in
  b.inputs <- s :: b.inputs;
  Ir.Signal s

let define b (s : Ir.signal) rhs =
  b.equations <- { Ir.defines = s; rhs; span = s.span } :: b.equations

let let_ ?ty ?line b name rhs =
  let s = declare ?ty ?line b name in
  define b s rhs;
  Ir.Signal s

let op ?ty b operator arguments = let_ ?ty b "" (Ir.Op (operator, arguments))

let call ?(statics = []) ?line b index inputs outputs =
  b.line <- b.line + 1;
  let callee = List.nth (List.rev b.program.nodes) index in
  let same (i : Ir.instance) = i.node = index in
  let name =
    match List.length (List.filter same b.instances) with
    | 0 -> callee.name
    | n -> Printf.sprintf "%s_%d" callee.name (n + 1)
  in
  let span = span b.file (Option.value line ~default:b.line) in
  b.instances <-
    { Ir.node = index; name; statics; inputs; outputs; loop = None; trials = []; span }
    :: b.instances

let run ?statics b index inputs name =
  let s = declare b name in
  call ?statics ~line:(Span.line s.span.start) b index inputs [ s ];
  Ir.Signal s

(* One parameter of each type that parameters can have. *)
let params : Ir.param list =
  let param label param_ty default : Ir.param =
    { label; param_ty; unit_ = ""; default; doc = None; declared = span "test.frob" 1 }
  in
  [ param "on" Bool (Bool false); param "count" Int (Int 0l); param "gain" Float (Float 1.) ]

let param : Ir.ty -> Ir.rhs = function
  | Bool -> Param 0
  | Int -> Param 1
  | Float -> Param 2
  | Sum _ | Array _ | Foreign _ -> invalid_arg "Build.param"

let program ?(sums = [||]) ?(params = []) t =
  let nodes = Array.of_list (List.rev t.nodes) in
  let root = nodes.(Array.length nodes - 1) in
  let tuple leaves =
    Ir.Product
      {
        product_name = "";
        product_module = "";
        constructor = "";
        record = false;
        parts = List.map (fun ty -> ("", Ir.Leaf ty)) leaves;
      }
  in
  let ty_of_atom : Ir.atom -> Ir.ty = function
    | Ir.Signal (s : Ir.signal) -> s.ty
    | Ir.Bool _ -> Ir.Bool
    | Ir.Int _ -> Ir.Int
    | Ir.Float _ -> Ir.Float
  in
  {
    Ir.name = "test";
    sums;
    nodes;
    next_id = Signals.next_id nodes;
    imports = [];
    console = [];
    headers = [];
    input = tuple (List.map (fun (s : Ir.signal) -> s.ty) root.inputs);
    output = tuple (List.map (fun (_, a) -> ty_of_atom a) root.outputs);
    ends = false;
    probes = [];
    claims = [];
    rate = None;
    marks = 0;
    params;
    real = Double;
  }
