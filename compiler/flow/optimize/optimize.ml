open Basis

let simplify = Pass.make "simplify" Simplify.program "what is known of operands is known"
let dead_code = Pass.make "dead-code" Dead_code.program "last, for what all of them leave behind"

(* What makes each node as simple as it gets. *)
let tidy =
  [
    Pass.make "constant-propagation" Constant_propagation.program
      "literals first, as they decide choices";
    simplify;
    Pass.make "boolean-simplification" Boolean_simplification.program
      "it looks at choices and operators as they are simplified";
    Pass.make "constant-delays" Constant_delays.program "it takes simple conditions to see them";
    Pass.make "common-subexpressions" Common_subexpressions.program
      "after simplifying, which makes equal what looked different";
    Pass.make "equal-parameters" Equal_parameters.program "what is handed on stands there once";
    Pass.make "unreachable-modes" Unreachable_modes.program
      "conditions that are constant are seen to be";
    Pass.make "sole-mode" Sole_mode.program "where others cannot be reached it may be the only one";
    dead_code;
  ]

let loop_fusion =
  Pass.make "loop-fusion" Loop_fusion.program
    "before inlining, which takes the joined loops' bodies together"

let inline =
  Pass.make "inline" Inline.program
    "sizes are those of the work that remains; what was done twice is inlined once"

let absorb =
  Pass.make "absorb" Absorb.program
    "late, for a machine that so becomes a part of its user is inlined no more"

type step = Pass of Ir.program Pass.t | Tidy  (** if anything has changed since *)

(* Twice, as inlining brings loops of several nodes together. *)
let steps =
  [
    Tidy;
    Pass loop_fusion;
    Pass inline;
    Tidy;
    Pass loop_fusion;
    Pass inline;
    Tidy;
    Pass absorb;
    Pass simplify;
    Pass dead_code;
  ]

(* Few programs need more than three; a chain of functions could have one for each. *)
let most_rounds = 8

(* Modes, and outputs that are no literals. *)
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
  (* Where an output has become a literal more can be said of who reads it; and of a machine
     with fewer modes, for what is left may put out the same literal, or get it. *)
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
