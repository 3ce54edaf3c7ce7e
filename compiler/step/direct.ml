let is_direct (run : Ir.run) =
  let stays (next : Ir.next) =
    match next.at_entry with Flow.Ir.Impossible _ -> true | Possible -> false
  in
  run.steps > 1 && (not run.late) && (not run.drops)
  && List.for_all (fun (case : Ir.case) -> List.for_all stays case.transitions) run.cases
