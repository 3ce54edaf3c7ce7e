(* Reports the fact at a place in the program rather than in the library, with the calls that lead
   there. *)
let report (c : Context.t) trail ~span excess =
  let at = Context.own_place c trail ~span in
  Context.report c (Limit { at; calls = Context.calls trail; excess })

let report_work (c : Context.t) (core : Core.Ir.definition) =
  let trail = Context.latest c in
  let report ~span excess = report c trail ~span excess in
  let large (e : Context.expansion) = e.elements > 1 in
  let modes (m : Context.machine) = m.modes in
  let most (best : Context.machine option) m =
    match best with Some other when modes other >= modes m -> best | Some _ | None -> Some m
  in
  match
    ( List.filter large (Context.expansions trail),
      List.fold_left most None (Context.machines trail),
      Context.most_specialized c )
  with
  | (_ :: _ as expansions), _, _
    when List.fold_left (fun n (e : Context.expansion) -> n * e.elements) 1 expansions > 5_000 ->
      let innermost = List.hd expansions in
      let numbers = List.rev_map (fun (e : Context.expansion) -> e.elements) expansions in
      report ~span:innermost.at (Elements { numbers; by = innermost.by })
  | _, Some machine, _ when machine.modes > 100 ->
      report ~span:machine.place (Modes { of_ = machine.of_; modes = machine.modes })
  | _, _, Some (name, copies) when copies > 1_000 ->
      report ~span:core.span (Copies { name; copies })
  | _, _, _ -> (
      match Context.widest c with
      | Some wide when wide.uses * wide.leaves > 100_000 ->
          let { Context.ty; leaves; uses } = wide in
          report ~span:core.span (Wide { ty; leaves; uses })
      | Some _ | None ->
          report ~span:core.span (Work { definition = core; most_called = Context.most_called c }))

let report_type (c : Context.t) (core : Core.Ir.definition) ty =
  report c (Context.latest c) ~span:core.span (Leaves { ty; limit = Types.most_leaves })

let report_nesting (c : Context.t) (core : Core.Ir.definition) ty =
  report c (Context.latest c) ~span:core.span (Data_nested { ty; limit = Types.deepest })
