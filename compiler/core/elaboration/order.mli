(** Definitions in dependency order.

    Those of methods come after the others when they are typed; here each moves in front of what
    uses it. Of definitions that use each other the order stays. *)

val definitions : Ir.definition list -> Ir.definition list
(** Linear. *)
