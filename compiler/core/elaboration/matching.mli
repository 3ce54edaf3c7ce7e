(** Patterns, taken apart: the tests that decide whether a value matches, and the variables as
    components and payloads of it.

    The value matched is always a variable ([root]), so that naming it many times costs nothing. *)

val binder : Context.t -> Typing.Ir.pattern -> Ir.binder
(** The variable that a pattern matches: its own if it is one, else fresh. *)

val variables : Typing.Ir.pattern -> root:Ir.expr -> (Ir.binder * Ir.expr) list
(** What the pattern's variables stand for, in order of writing. For a pattern that is its {!binder}
    there is none. *)

val part : Typing.Ir.pattern -> root:Ir.expr -> Ir.Local.t -> Ir.expr
(** What one of the pattern's variables stands for. *)

type branch = {
  pattern : Typing.Ir.pattern;
  falls : bool;  (** its guards may all fail *)
  value : fall:Ir.expr option -> Ir.expr;
      (** given what to do where they do, if [falls]: it is put there once *)
}

val case : Context.t -> root:Ir.expr -> Basis.Span.t -> branch list -> Ir.expr
(** The first branch that matches and whose guards do not all fail. The last one is not tested:
    cases are exhaustive. What follows a branch that can be left at two places becomes a local
    function of [()], a join point. *)
