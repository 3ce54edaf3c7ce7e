(** Compiles patterns into tests, which decide whether a value matches, and bindings of variables to
    components and payloads of the value. The matched value is always a variable ([root]), so that
    it can be mentioned several times at no cost. *)

val binder : Context.t -> Typing.Ir.pattern -> Ir.binder
(** The variable that is bound to the matched value: the pattern itself if it is a variable,
    otherwise a new variable. *)

val variables : Typing.Ir.pattern -> root:Ir.expr -> (Ir.binder * Ir.expr) list
(** The values of the pattern's variables, in source order. Empty if the pattern is a variable,
    because that variable is the {!binder}. *)

val part : Typing.Ir.pattern -> root:Ir.expr -> Ir.Local.t -> Ir.expr
(** The value of one of the pattern's variables. *)

type branch = {
  pattern : Typing.Ir.pattern;
  falls : bool;  (** whether all its guards may fail *)
  value : fall:Ir.expr option -> Ir.expr;
      (** returns the value, given the expression to use if all guards fail; if [falls] is true,
          that expression is used exactly once *)
}

val case : Context.t -> root:Ir.expr -> Basis.Span.t -> branch list -> Ir.expr
(** The value of the first branch that matches and whose guards do not all fail. The last branch is
    not tested, because cases are exhaustive. If the branches after a given one are needed in two
    places, they become a join point, which is a local function of [()]. *)
