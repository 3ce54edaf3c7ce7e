open Basis
module Global_table = Resolve.Global_table

let of_uses { Uses.definitions; index; uses } : Fact.t list =
  let out (use : Uses.use) =
    match use with
    | { target = Definition (name, _); later = false; span } ->
        Option.map (fun target -> (target, span)) (Global_table.find_opt index name)
    | { target = Definition _ | Method _; _ } -> None
  in
  let out = Array.map (List.filter_map out) uses in
  let graph = Array.map (List.map fst) out in
  let cycle component : Fact.t option =
    if Graph.is_cyclic graph component then
      let use a b = List.assoc_opt b out.(a) in
      Some
        (Cycle
           {
             cycle = Uses.cycle definitions ~use (Graph.shortest_cycle graph component);
             cause = Itself;
           })
    else None
  in
  List.filter_map cycle (Graph.components graph)

let facts (program : Ir.program) =
  let uses = Uses.of_program program in
  (* Runs the later checks only if the earlier ones find nothing. Otherwise, a definition that is
     recursive at every type would be reported again for each type. *)
  match of_uses uses with
  | [] -> (
      match Method_recursion.facts program uses with
      | [] -> Polymorphic_recursion.facts uses
      | facts -> facts)
  | facts -> facts

let check into program = List.iter (Facts.report into) (facts program)
