open Basis

type definition =
  | Parameter
  | Equation of Ir.equation
  | Output of Ir.instance * int
  | Box of Ir.atom list

module Inputs = Set.Make (Int)

type passage = { passed : Inputs.t array; decisive : Inputs.t }

type node = {
  graph : Graph.t;
  definitions : definition list array;
  vertex : Ir.signal -> int;
  components : int list list;
  passage : passage;
}

(* The inputs that an output of an instance needs. A loop is treated as a black box. *)
let passed_by (passage : passage) (instance : Ir.instance) output =
  match instance.loop with
  | None -> passage.passed.(output)
  | Some _ -> Inputs.of_list (List.mapi (fun i _ -> i) instance.inputs)

let reads passages = function
  | Parameter -> []
  | Equation equation -> Operands.(signals (same_instant equation.rhs))
  | Output (instance, output) ->
      let passed = passed_by passages.(instance.node) instance output in
      let needed = List.filteri (fun i _ -> Inputs.mem i passed) instance.inputs in
      Operands.signals (List.rev_append (List.rev instance.statics) needed)
  | Box atoms -> Operands.signals atoms

let not_delayed = List.filter (fun (t : Ir.transition) -> not t.delayed)

(* Everything that an output of the machine needs in the same instant. *)
let needed_by_machine (passages : passage array) (machine : Ir.machine) =
  let needed_by_mode needed mode =
    let { passed; decisive; _ } = passages.(mode) in
    Array.fold_left Inputs.union (Inputs.union decisive needed) passed
  in
  let needed = List.fold_left needed_by_mode Inputs.empty machine.modes in
  let inputs = List.filteri (fun i _ -> Inputs.mem i needed) machine.inputs in
  List.rev_append (List.rev inputs)
    (Option.to_list machine.active @ Transitions.atoms (not_delayed machine.controls))

(* All signals of the node with their definitions: parameters first, then equations, then
   outputs. *)
let definitions passages (node : Ir.node) =
  let all = ref [] in
  let add definition s = all := (s, definition) :: !all in
  let outputs (i : Ir.instance) = List.iteri (fun k -> add (Output (i, k))) i.outputs in
  let machine (m : Ir.machine) = List.iter (add (Box (needed_by_machine passages m))) m.outputs in
  let inputs = lazy (Box (List.map (fun s -> Ir.Signal s) node.inputs)) in
  let foreign (f : Ir.foreign) = List.iter (add (Lazy.force inputs)) f.results in
  List.iter (add Parameter) (node.statics @ node.inputs);
  List.iter (fun (e : Ir.equation) -> add (Equation e) e.defines) node.equations;
  List.iter outputs node.instances;
  Option.iter machine node.machine;
  Option.iter foreign node.foreign;
  List.rev !all

let of_node passages (node : Ir.node) =
  let all = definitions passages node in
  let vertices = Int_table.create 64 in
  List.iter
    (fun ((s : Ir.signal), _) ->
      if not (Int_table.mem vertices s.group) then
        Int_table.replace vertices s.group (Int_table.length vertices))
    all;
  let vertex (s : Ir.signal) =
    match Int_table.find_opt vertices s.group with
    | Some v -> v
    | None ->
        Diagnostic.bug ~stage:"Flow.Dependency" "`%s` (%d) is not defined in `%s`" s.name s.id
          node.name
  in
  let n = Int_table.length vertices in
  let defined_by = Array.make n [] in
  List.iter
    (fun (s, definition) ->
      let v = vertex s in
      defined_by.(v) <- definition :: defined_by.(v))
    (List.rev all);
  let edges definitions =
    let read all s = vertex s :: all in
    let add all definition = List.fold_left read all (reads passages definition) in
    List.rev (List.fold_left add [] definitions)
  in
  let graph = Array.map edges defined_by in
  let components = Graph.components graph in
  (* The inputs that each vertex needs. Components are sorted in evaluation order. *)
  let needs = Array.make n Inputs.empty in
  List.iteri
    (fun i s ->
      let v = vertex s in
      needs.(v) <- Inputs.add i needs.(v))
    node.inputs;
  let unite component =
    let all =
      List.fold_left
        (fun all v ->
          List.fold_left
            (fun all w -> if needs.(w) == all then all else Inputs.union all needs.(w))
            (Inputs.union all needs.(v))
            graph.(v))
        Inputs.empty component
    in
    List.iter (fun v -> needs.(v) <- all) component
  in
  List.iter unite components;
  let needed : Ir.atom -> Inputs.t = function
    | Signal s -> needs.(vertex s)
    | Bool _ | Int _ | Float _ -> Inputs.empty
  in
  let passed = Array.of_list (Long_list.map (fun (_, a) -> needed a) node.outputs) in
  let decisive =
    List.fold_left
      (fun inputs a -> Inputs.union inputs (needed a))
      Inputs.empty
      (Transitions.atoms (not_delayed node.transitions))
  in
  { graph; definitions = defined_by; vertex; components; passage = { passed; decisive } }

let program ?(each = fun _ _ _ -> ()) (program : Ir.program) =
  let none = { passed = [||]; decisive = Inputs.empty } in
  let passages = Array.make (Array.length program.nodes) none in
  Array.iteri
    (fun index node ->
      let node = of_node passages node in
      passages.(index) <- node.passage;
      each passages index node)
    program.nodes;
  passages
