(** Traversals of resolved trees. *)

type visitor = {
  expr : Ir.expr -> unit;
  pattern : Ir.pattern -> unit;
  binding : Ir.binding -> unit;
}

val expr : visitor -> Ir.expr -> unit
(** Visits the direct parts of an expression in the order in which they are evaluated and bound. The
    visitor itself must descend into these parts. *)

val binding : visitor -> Ir.binding -> unit
(** Visits the parts of a binding: its parameters, its [where] and its right-hand side. *)

val application : Ir.expr -> Ir.expr * Ir.expr list
(** Splits nested applications into the function and all its arguments, in order. For any other
    expression, the list of arguments is empty. *)

val own_modules : Ir.program -> Ir.module_ list
(** The modules outside the library, and the main module. *)

val own : Ir.program -> Ir.binding list
(** The bindings of {!own_modules}, including those of methods and their defaults. *)
