open Basis
module Ir = Core.Ir
module Global_table = Resolve.Global_table

(* What may call or be called: definitions, let-bound variables, and equations
   that are no signals. *)
type graph = {
  globals : int Global_table.t;
  locals : int Int_table.t;
  mutable vertices : Cycle.vertex list;  (* the last one first *)
  mutable count : int;
  edges : (int * Span.t) list Int_table.t;  (* with the place of the use *)
}

let vertex g name ?(ty : Ir.ty = Tuple []) span =
  let number = g.count in
  g.vertices <- { Cycle.name; span; task = Cycle.gives_task ty } :: g.vertices;
  g.count <- number + 1;
  number

let edge g source target span =
  let others = Option.value (Int_table.find_opt g.edges source) ~default:[] in
  Int_table.replace g.edges source ((target, span) :: others)

(* First all local vertices, as uses may come before their binding; then the
   edges. [visit] gets an expression and the vertex whose value it belongs to. *)
let sub_expressions visit (e : Ir.expr) =
  match e.desc with
  | Local _ | Global _ | Primitive _ | Method _ | Number _ | Boolean _ | String _ | Let _ | Proc _ -> ()
  | Lambda (_, body) -> visit body
  | Apply (f, argument) ->
      visit f;
      visit argument
  | Tuple parts | Array parts | Construct { arguments = parts; _ } -> List.iter visit parts
  | Component (e, _) | Index (e, _) | Is_constructor (e, _) | Payload { value = e; _ } -> visit e
  | If (condition, then_, else_) ->
      visit condition;
      visit then_;
      visit else_

let rhs_expressions visit : Ir.rhs -> unit = function
  | Pure e -> visit e
  | Run { signal_function; input } ->
      visit signal_function;
      visit input

let rec declare g (e : Ir.expr) =
  match e.desc with
  | Let { binder; value; body; parameters = _ } ->
      declare_local g binder;
      declare g value;
      declare g body
  | Proc proc ->
      List.iter
        (fun (eq : Ir.equation) ->
          if Cycle.is_static eq then declare_local g eq.binder;
          rhs_expressions (declare g) eq.rhs)
        proc.equations;
      declare g proc.output
  | _ -> sub_expressions (declare g) e

and declare_local g (binder : Ir.binder) =
  let number = vertex g binder.local.name ~ty:binder.ty binder.local.span in
  Int_table.replace g.locals binder.local.id number

let rec uses g owner (e : Ir.expr) =
  match e.desc with
  | Local (local, _) -> (
      match Int_table.find_opt g.locals local.id with
      | Some target -> edge g owner target e.span
      | None -> ())
  | Global (name, _) -> (
      match Global_table.find_opt g.globals name with
      | Some target -> edge g owner target e.span
      | None -> ())
  | Let { binder; value; body; parameters = _ } ->
      uses g (Int_table.find g.locals binder.local.id) value;
      uses g owner body
  | Proc proc ->
      List.iter
        (fun (eq : Ir.equation) ->
          let owner =
            if Cycle.is_static eq then Int_table.find g.locals eq.binder.local.id else owner
          in
          rhs_expressions (uses g owner) eq.rhs)
        proc.equations;
      uses g owner proc.output
  | Apply (f, argument) when Cycle.is_continuation argument.ty ->
      uses g owner f;
      (* Nothing uses this vertex, so it is in no circle. *)
      uses g (vertex g "" argument.span) argument
  | _ -> sub_expressions (uses g owner) e

let report sink vertices use cycle =
  let tasks = List.for_all (fun v -> vertices.(v).Cycle.task) cycle in
  let cure =
    if tasks then Fun.id
    else
      Diagnostic.hint "a value that depends on its own past is an equation of a `proc`, with `delay`"
  in
  Cycle.diagnostic ~vertex:(fun v -> vertices.(v)) ~use cycle |> cure |> Diagnostic.emit sink

let check_graph sink (definitions : Ir.definition list) =
  let g =
    {
      globals = Global_table.create 256;
      locals = Int_table.create 256;
      vertices = [];
      count = 0;
      edges = Int_table.create 256;
    }
  in
  let number (d : Ir.definition) =
    let number = vertex g d.name.name ~ty:d.ty d.span in
    Global_table.replace g.globals d.name number
  in
  List.iter number definitions;
  List.iter (fun (d : Ir.definition) -> declare g d.body) definitions;
  List.iter
    (fun (d : Ir.definition) ->
      uses g (Global_table.find g.globals d.name) d.body)
    definitions;
  let vertices = Array.of_list (List.rev g.vertices) in
  let out v = List.rev (Option.value (Int_table.find_opt g.edges v) ~default:[]) in
  let graph = Array.init g.count (fun v -> List.map fst (out v)) in
  let place a b =
    match List.assoc_opt b (out a) with Some span -> span | None -> vertices.(a).span
  in
  List.iter
    (fun component ->
      if Graph.is_cyclic graph component then
        report sink vertices place (Graph.shortest_cycle graph component))
    (Graph.components graph)

let check sink program =
  let own = Diagnostic.sink () in
  let candidates = Candidates.of_program program in
  check_graph own candidates.at_once;
  (* What runs in a circle by itself would do so again at every type. *)
  if not (Diagnostic.has_errors own) then
    Method_recursion.check own program ~among:candidates.by_methods;
  if not (Diagnostic.has_errors own) then Polymorphic_recursion.check own candidates.ever;
  List.iter (Diagnostic.emit sink) (Diagnostic.all own)
