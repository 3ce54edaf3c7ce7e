(** The parts of resolved trees, for what looks at all of them. *)

type visitor = {
  expr : Ir.expr -> unit;
  pattern : Ir.pattern -> unit;
  binding : Ir.binding -> unit;
}

val expr : visitor -> Ir.expr -> unit
(** Visits what stands directly in an expression, as it is evaluated and bound: it is the
    visitor's to go on from there. *)

val binding : visitor -> Ir.binding -> unit
(** Visits what stands in a binding: its parameters, its [where] and its right side. *)

val own : Ir.program -> Ir.binding list
(** The bindings of the program's own modules: not the library's, unless the program is a
    module of it. Those of methods, and their defaults, are among them. *)
