(** Where recursion has to be looked for.

    Definitions come in dependency order, so one that uses no later one and not
    itself is in no circle. A single walk over the program finds that of nearly all;
    the analyses that can say how a circle goes look into the others only. *)

type t = {
  at_once : Core.Ir.definition list;
      (** that may need themselves, not counting what {!Cycle.is_continuation} says is a continuation *)
  ever : Core.Ir.definition list;
      (** that may need themselves, continuations counted *)
  by_methods : Core.Ir.definition list;
      (** from which a method at a type variable may be reached, not counting
          continuations *)
}
(** Each list in the order of the program. All circles lie within them, and all ways
    from one circle to another that comes later in the program. *)

val of_program : Core.Ir.program -> t
(** Linear. Does not need what {!Core.Lint} checks. *)
