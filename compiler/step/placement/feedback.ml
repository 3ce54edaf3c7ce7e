module F = Flow.Ir
open Basis

type t = unit Int_table.t

let none : t = Int_table.create 1
let mem (t : t) (s : F.signal) = Int_table.mem t s.id

(* An edge means "is computed from", in this instant or an earlier one. An instance's first output
   has edges to its inputs; each other output has an edge to the first. *)
let graph (node : F.node) =
  let vertices = Int_table.create 64 in
  let define (s : F.signal) = Int_table.replace vertices s.id (Int_table.length vertices) in
  List.iter (fun (eq : F.equation) -> define eq.defines) node.equations;
  List.iter (fun (i : F.instance) -> List.iter define i.outputs) node.instances;
  let vertex (s : F.signal) = Int_table.find_opt vertices s.id in
  let graph = Array.make (Int_table.length vertices) [] in
  let reads (s : F.signal) atoms =
    let read = List.filter_map vertex (Flow.Operands.signals atoms) in
    Option.iter (fun v -> graph.(v) <- read) (vertex s)
  in
  let instance (i : F.instance) =
    match i.outputs with
    | [] -> ()
    | first :: others ->
        reads first i.inputs;
        List.iter (fun s -> reads s [ F.Signal first ]) others
  in
  List.iter (fun (eq : F.equation) -> reads eq.defines (Flow.Operands.all eq.rhs)) node.equations;
  List.iter instance node.instances;
  (graph, vertex)

let of_node (node : F.node) : t =
  match node.kind with
  | Function -> none
  | Signal_function ->
      let graph, vertex = graph node in
      let component = Array.make (Array.length graph) 0 in
      List.iteri (fun k -> List.iter (fun v -> component.(v) <- k)) (Graph.components graph);
      let found = Int_table.create 8 in
      List.iter
        (fun (eq : F.equation) ->
          match eq.rhs with
          | If { condition = Signal c; _ } -> (
              match (vertex c, vertex eq.defines) with
              | Some a, Some b when component.(a) = component.(b) ->
                  Int_table.replace found eq.defines.id ()
              | _, _ -> ())
          | _ -> ())
        node.equations;
      found
