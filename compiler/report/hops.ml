open Basis
module M = Machine.Ir

type machine = {
  name : string;
  file : string;
  span : Span.t;
  modes : string list;
  steps : int;
}

let of_node (program : M.program) (node : M.node) =
  let found = ref [] in
  let mode (mode : M.mode) = program.nodes.(mode.node).origin in
  Machine.Walk.statements
    (function
      | M.Run { steps; span; _ } ->
          let modes = List.map mode node.modes in
          found := { name = node.origin; file = span.file; span; modes; steps } :: !found
      | Declare _ | Assign _ | If _ | Step _ | Loop _ | Reset _ | Enter _ | Return _ -> ())
    node.step.body;
  List.rev !found

let of_program (program : M.program) =
  Array.fold_left (fun later node -> of_node program node @ later) [] program.nodes
