(** The parts of resolved trees, for what looks at all of them. *)

type visitor = {
  expr : Ir.expr -> unit;
  pattern : Ir.pattern -> unit;
  binding : Ir.binding -> unit;
}

val expr : visitor -> Ir.expr -> unit
(** Visits what stands directly in an expression, as it is evaluated and bound: it is the visitor's
    to go on from there. *)

val binding : visitor -> Ir.binding -> unit
(** Visits what stands in a binding: its parameters, its [where] and its right side. *)

val own_modules : Ir.program -> Ir.module_ list
(** Those that are not of the library, and the main one. *)

val own : Ir.program -> Ir.binding list
(** The bindings of {!own_modules}. Those of methods, and their defaults, are among them. *)
