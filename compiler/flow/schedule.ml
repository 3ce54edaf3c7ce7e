open Basis

type item =
  | Equation of Ir.equation
  | Instance of Ir.instance
  | Machine of Ir.machine

(* Equations in their order; an instance before the first equation that is
   written after it. Only equations of the instance's own file can tell. *)
let in_source_order (node : Ir.node) =
  let precedes (instance : Ir.instance) (equation : Ir.equation) =
    String.equal instance.span.file equation.span.file
    && Span.compare instance.span equation.span <= 0
  in
  let rec merge items (instances : Ir.instance list) (equations : Ir.equation list) =
    match (instances, equations) with
    | [], [] -> List.rev items
    | i :: instances, [] -> merge (Instance i :: items) instances []
    | i :: instances, e :: _ when precedes i e -> merge (Instance i :: items) instances equations
    | _, e :: equations -> merge (Equation e :: items) instances equations
  in
  let items = merge [] node.instances node.equations in
  match node.machine with
  | None -> items
  | Some machine -> List.rev (Machine machine :: List.rev items)

let defines = function
  | Equation e -> [ e.defines ]
  | Instance i -> i.outputs
  | Machine m -> m.outputs

let needs = function
  | Equation e -> Operands.(signals (same_instant e.rhs))
  | Instance i -> Operands.signals (List.rev_append (List.rev i.statics) i.inputs)
  | Machine m -> Operands.signals (Transitions.read_in_step m)

let graph items =
  let definer = Hashtbl.create (2 * Array.length items) in
  Array.iteri
    (fun v item -> List.iter (fun (s : Ir.signal) -> Hashtbl.replace definer s.id v) (defines item))
    items;
  (* What no item defines is a parameter. *)
  Array.map
    (fun item -> List.filter_map (fun (s : Ir.signal) -> Hashtbl.find_opt definer s.id) (needs item))
    items

let in_order items components =
  let append order component = List.fold_left (fun order v -> items.(v) :: order) order component in
  List.rev (List.fold_left append [] components)

let of_node (node : Ir.node) =
  let items = Array.of_list (in_source_order node) in
  let graph = graph items in
  let components = Graph.components graph in
  if List.exists (Graph.is_cyclic graph) components then
    Diagnostic.bug ~stage:"Flow.Schedule" "`%s` has a cycle" node.name;
  in_order items components

let as_far_as_possible node =
  let items = Array.of_list (in_source_order node) in
  in_order items (Graph.components (graph items))

let loops (node : Ir.node) =
  let items = Array.of_list (in_source_order node) in
  let graph = graph items in
  let instance v = match items.(v) with Instance i -> Some i | Equation _ | Machine _ -> None in
  List.filter_map
    (fun component ->
      if Graph.is_cyclic graph component then Some (List.filter_map instance component) else None)
    (Graph.components graph)
