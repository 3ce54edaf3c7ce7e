open Basis

type t = {
  mutable current : int option;
  all : int list array;  (** references of each binding, newest first *)
  unsigned : int list array;
}

let create n = { current = None; all = Array.make n []; unsigned = Array.make n [] }

let within t i f =
  let outer = t.current in
  t.current <- Some i;
  let result = f () in
  t.current <- outer;
  result

let refer t ~signed target =
  match t.current with
  | None -> ()
  | Some i ->
      t.all.(i) <- target :: t.all.(i);
      if not signed then t.unsigned.(i) <- target :: t.unsigned.(i)

(* Splits a cycle into the components that remain after removing the references to names with
   signatures. *)
let split t ~position vertices =
  let vertex = Array.of_list vertices in
  Array.iteri (fun k v -> position.(v) <- k) vertex;
  let inside v =
    List.filter_map
      (fun w -> if position.(w) >= 0 then Some position.(w) else None)
      (List.rev t.unsigned.(v))
  in
  let components = Graph.components (Array.map inside vertex) in
  Array.iter (fun v -> position.(v) <- -1) vertex;
  Long_list.map (Long_list.map (fun k -> vertex.(k))) components

let sort t bindings =
  let graph = Array.map List.rev t.all in
  let position = Array.make (Array.length bindings) (-1) in
  let group recursive vertices : Ir.binding_group =
    { bindings = Long_list.map (fun v -> bindings.(v)) vertices; recursive }
  in
  let groups = function
    | [ v ] -> [ group (Graph.is_cyclic graph [ v ]) [ v ] ]
    | circle -> Long_list.map (group true) (split t ~position circle)
  in
  let add reversed component = List.rev_append (groups component) reversed in
  List.rev (List.fold_left add [] (Graph.components graph))
