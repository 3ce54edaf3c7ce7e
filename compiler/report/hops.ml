open Basis
module M = Step.Ir

type machine = {
  name : string;
  file : string;
  span : Span.t;
  modes : string list;
  transitions : transition list;
  steps : int;
}

and transition = { leaves : string; enters : string; at_entry : Flow.Ir.at_entry; at : Span.t }

let of_node (program : M.program) (node : M.node) =
  let found = ref [] in
  let mode (mode : M.mode) = program.nodes.(mode.node).origin in
  Step.Walk.statements
    (function
      | M.Run { steps; span; cases; _ } ->
          let modes = List.map mode node.modes in
          let transition leaves (n : M.next) =
            { leaves; enters = List.nth modes n.entry.mode; at_entry = n.at_entry; at = n.span }
          in
          let transitions =
            List.concat
              (List.map2
                 (fun leaves (case : M.case) -> List.map (transition leaves) case.transitions)
                 modes cases)
          in
          let hops = { name = node.origin; file = span.file; span; modes; transitions; steps } in
          found := hops :: !found
      | Declare _ | Assign _ | If _ | Step _ | Loop _ | Reset _ | Enter _ | Return _ -> ())
    node.step.body;
  List.rev !found

let of_program (program : M.program) =
  Array.fold_left (fun later node -> of_node program node @ later) [] program.nodes
