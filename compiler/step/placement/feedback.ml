module F = Flow.Ir
open Basis

type t = unit Int_table.t

let none : t = Int_table.create 1
let mem (t : t) (s : F.signal) = Int_table.mem t s.id

(* An edge means "is computed from", at this instant or an earlier one. An
   instance is a vertex between its outputs and its inputs. *)
let graph (node : F.node) =
  let vertices = Int_table.create 64 in
  let count = ref 0 in
  let add () =
    incr count;
    !count - 1
  in
  let define (s : F.signal) = Int_table.replace vertices s.id (add ()) in
  List.iter (fun (eq : F.equation) -> define eq.defines) node.equations;
  let instances =
    List.rev_map
      (fun (i : F.instance) ->
        List.iter define i.outputs;
        (add (), i))
      node.instances
  in
  let vertex (s : F.signal) = Int_table.find_opt vertices s.id in
  let graph = Array.make !count [] in
  let define (s : F.signal) successors =
    Option.iter (fun v -> graph.(v) <- successors) (vertex s)
  in
  let own atoms = List.filter_map vertex (Flow.Operands.signals atoms) in
  List.iter
    (fun (eq : F.equation) -> define eq.defines (own (Flow.Operands.all eq.rhs)))
    node.equations;
  List.iter
    (fun (v, (i : F.instance)) ->
      graph.(v) <- own i.inputs;
      List.iter (fun s -> define s [ v ]) i.outputs)
    instances;
  (graph, vertex)

let of_node (node : F.node) : t =
  match node.kind with
  | Function -> none
  | Signal_function ->
      let graph, vertex = graph node in
      let component = Array.make (Array.length graph) 0 in
      List.iteri
        (fun k -> List.iter (fun v -> component.(v) <- k))
        (Graph.components graph);
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
