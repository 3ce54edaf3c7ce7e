open Basis
module Ir = Core.Ir
module Global_table = Resolve.Global_table

type graph = {
  globals : int Global_table.t;
  mutable vertices : Cycle.vertex list;  (* the last one first *)
  mutable count : int;
  edges : (int * Span.t) list Int_table.t;  (* with the place of the use *)
}

let vertex g (d : Ir.definition) =
  let number = g.count in
  g.vertices <- { Cycle.name = d.name.name; span = d.span; task = Cycle.gives_task d.ty } :: g.vertices;
  g.count <- number + 1;
  Global_table.replace g.globals d.name number

let uses g (d : Ir.definition) =
  let use (target, span) =
    match (target : Uses.target) with
    | Definition (name, _) ->
        Option.map (fun number -> (number, span)) (Global_table.find_opt g.globals name)
    | Method _ -> None
  in
  let found = List.filter_map use (Uses.of_expr ~continuations:false d.body) in
  Int_table.replace g.edges (Global_table.find g.globals d.name) found

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
      vertices = [];
      count = 0;
      edges = Int_table.create 256;
    }
  in
  List.iter (vertex g) definitions;
  List.iter (uses g) definitions;
  let vertices = Array.of_list (List.rev g.vertices) in
  let out v = Int_table.find g.edges v in
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
