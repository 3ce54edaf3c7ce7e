open Basis

let simplify =
  Pass.make "simplify" Simplify.program
    "after constant propagation, so that all known operands are literals"

let dead_code =
  Pass.make "dead-code" Dead_code.program
    "last, because every other pass leaves unused equations behind"

(* Passes that simplify each node. *)
let tidy =
  [
    Pass.make "constant-propagation" Constant_propagation.program
      "first, because literals can decide which branch of a choice is taken";
    simplify;
    Pass.make "boolean-simplification" Boolean_simplification.program
      "after simplification, because it only recognizes simplified choices and operators";
    Pass.make "constant-delays" Constant_delays.program
      "after the conditions are simplified, because it only recognizes simple ones";
    Pass.make "redundant-marks" Redundant_marks.program
      "after the conditions are simplified, because it only recognizes conjunctions";
    Pass.make "common-subexpressions" Common_subexpressions.program
      "after simplification, which turns equivalent expressions into equal ones";
    Pass.make "duplicate-parameters" Duplicate_parameters.program
      "after common subexpressions, so that arguments with the same value are the same signal";
    Pass.make "unreachable-modes" Unreachable_modes.program
      "after simplification, which shows that a condition is constant";
    Pass.make "single-mode" Single_mode.program
      "after unreachable modes, because a machine may then have only one mode left";
    dead_code;
  ]

let loop_fusion =
  Pass.make "loop-fusion" Loop_fusion.program
    "before inlining, so that the bodies of fused loops are inlined together"

let inline =
  Pass.make "inline" Inline.program
    "after the nodes are simplified, so that their sizes are final and repeated calls are inlined \
     once"

let hoisting =
  Pass.make "hoisting" Hoisting.program
    "after inlining, because a node then contains the computations of its inlined callees"

let inline_machines =
  Pass.make "inline-machines" Inline_machines.program
    "late, because a node that contains an inlined machine can no longer be inlined"

type step =
  | Pass of Ir.program Pass.t
  | Tidy  (** skipped if nothing has changed since the last [Tidy] *)

(* Loop fusion and inlining run twice, because inlining brings loops from several nodes together. *)
let steps =
  [
    Tidy;
    Pass loop_fusion;
    Pass inline;
    Tidy;
    Pass loop_fusion;
    Pass inline;
    Tidy;
    Pass hoisting;
    Tidy;
    Pass inline_machines;
    Pass simplify;
    Pass dead_code;
  ]

(* Few programs need more than three rounds, but a chain of functions could need one for each
   function. *)
let most_rounds = 8

(* The number of modes plus the number of outputs that are not literals. *)
let unknown (program : Ir.program) =
  let is_signal (_, (a : Ir.atom)) = match a with Signal _ -> true | _ -> false in
  let modes (m : Ir.machine) = List.length m.modes in
  Array.fold_left
    (fun n (node : Ir.node) ->
      n
      + Option.fold node.machine ~none:0 ~some:modes
      + List.length (List.filter is_signal node.outputs))
    0 program.nodes

let program ?(after = fun _ _ -> ()) program =
  let run = Pass.run after in
  (* Another round may help if an output has become a literal, because this simplifies the nodes
     that read it, or if a machine has lost modes, because the remaining modes may agree on a
     literal for an output or parameter. *)
  let rec tidied ?(round = 1) program =
    let once = List.fold_left run program tidy in
    if unknown once < unknown program && round < most_rounds then tidied ~round:(round + 1) once
    else once
  in
  let step (program, is_tidy) = function
    | Pass p ->
        let made = run program p in
        (made, is_tidy && made == program)
    | Tidy -> ((if is_tidy then program else tidied program), true)
  in
  fst (List.fold_left step (program, false) steps)
