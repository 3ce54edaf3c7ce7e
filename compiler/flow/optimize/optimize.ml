type pass = { name : string; pass : Ir.program -> Ir.program; reason : string }

let constant_propagation =
  {
    name = "constant-propagation";
    pass = Constant_propagation.program;
    reason = "literals first, as they decide choices";
  }

let simplify =
  { name = "simplify"; pass = Simplify.program; reason = "what is known of operands is known" }

let dead_code =
  {
    name = "dead-code";
    pass = Dead_code.program;
    reason = "last, for what all of them leave behind";
  }

(* What makes each node as simple as it gets. *)
let tidy =
  [
    constant_propagation;
    simplify;
    {
      name = "boolean-simplification";
      pass = Boolean_simplification.program;
      reason = "it looks at choices and operators as they are simplified";
    };
    {
      name = "constant-delays";
      pass = Constant_delays.program;
      reason = "it takes simple conditions to see them";
    };
    {
      name = "common-subexpressions";
      pass = Common_subexpressions.program;
      reason = "after simplifying, which makes equal what looked different";
    };
    {
      name = "equal-parameters";
      pass = Equal_parameters.program;
      reason = "what is handed on, or computed by a loop, stands there once";
    };
    {
      name = "unreachable-modes";
      pass = Unreachable_modes.program;
      reason = "conditions that are constant are seen to be";
    };
    dead_code;
  ]

let loop_fusion =
  {
    name = "loop-fusion";
    pass = Loop_fusion.program;
    reason = "before inlining, which takes the joined loops' bodies together";
  }

let inline =
  {
    name = "inline";
    pass = Inline.program;
    reason = "sizes are those of the work that remains; what was done twice is inlined once";
  }

let extreme =
  {
    name = "extreme";
    pass = Extreme.program;
    reason = "after inlining, which shows how they compare; then they join others";
  }

let absorb =
  {
    name = "absorb";
    pass = Absorb.program;
    reason = "late, for a machine that so becomes a part of its user is inlined no more";
  }

type step =
  | Pass of pass
  | Tidy  (** if anything has changed since *)

(* Twice, as inlining brings loops of several nodes together. *)
let steps =
  [ Tidy; Pass loop_fusion; Pass inline; Tidy; Pass extreme; Pass loop_fusion; Pass inline; Tidy;
    Pass absorb; Pass simplify; Pass dead_code ]

let modes (program : Ir.program) =
  Array.fold_left
    (fun n (node : Ir.node) ->
      Option.fold node.machine ~none:n ~some:(fun (m : Ir.machine) -> n + List.length m.modes))
    0 program.nodes

let program ?(after = fun _ _ -> ()) program =
  let run program p =
    let made = p.pass program in
    after p made;
    made
  in
  (* Of a machine with fewer modes more can be said: what is left may put out the same
     literal, or get it. *)
  let rec tidied program =
    let once = List.fold_left run program tidy in
    if modes once < modes program then tidied once else once
  in
  let step (program, is_tidy) = function
    | Pass p ->
        let made = run program p in
        (made, is_tidy && made == program)
    | Tidy -> ((if is_tidy then program else tidied program), true)
  in
  fst (List.fold_left step (program, false) steps)
