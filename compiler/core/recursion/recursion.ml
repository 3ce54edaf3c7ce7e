open Basis
module Global_table = Resolve.Global_table

let report sink (definitions : Ir.definition array) use cycle =
  let vertex v = Cycle.vertex definitions.(v) in
  let cure =
    if List.for_all (fun v -> (vertex v).task) cycle then Fun.id
    else
      Diagnostic.hint
        "for a value that depends on its own past, write an equation in a `proc`, with `delay`, as \
         in `n = delay 0 n + 1`"
  in
  Cycle.diagnostic ~vertex ~use cycle |> cure |> Diagnostic.emit sink

let check_uses sink { Uses.definitions; index; uses } =
  let out (use : Uses.use) =
    match use with
    | { target = Definition (name, _); later = false; span } ->
        Option.map (fun target -> (target, span)) (Global_table.find_opt index name)
    | { target = Definition _ | Method _; _ } -> None
  in
  let out = Array.map (List.filter_map out) uses in
  let graph = Array.map (List.map fst) out in
  let report component =
    if Graph.is_cyclic graph component then
      report sink definitions
        (fun a b -> Option.value (List.assoc_opt b out.(a)) ~default:definitions.(a).span)
        (Graph.shortest_cycle graph component)
  in
  List.iter report (Graph.components graph)

let check sink (program : Ir.program) =
  let own = Diagnostic.sink () and uses = Uses.of_program program in
  check_uses own uses;
  (* A definition that is recursive at all types would be reported again for each type. *)
  if not (Diagnostic.has_errors own) then Method_recursion.check own program uses;
  if not (Diagnostic.has_errors own) then Polymorphic_recursion.check own uses;
  List.iter (Diagnostic.emit sink) (Diagnostic.all own)
