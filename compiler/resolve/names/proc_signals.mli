(** The signals of [proc]s, for messages about names used outside their scope: after the bracket or
    comma that ends the [proc], or in a [where] after [proc … -> do], which belongs to the enclosing
    definition. *)

type t = {
  name : Syntax.Ir.name;
  of_do : bool;  (** the [proc] is a whole right-hand side and uses a [do] *)
}

val of_body : Syntax.Ir.body -> t list
(** The names bound by a body that is a [proc]: its input and, if it uses a [do], its statements. *)

val of_module : Syntax.Ir.program -> t list
(** The names bound by all [proc]s in the module's definitions. *)

val in_capitals : Syntax.Ir.program -> string list
(** Top-level definitions whose name is capitalized, as in [Speed = 0.3]. These are parsed as
    patterns, and already reported. *)

val without_definition : Syntax.Ir.program -> string list
(** Names with a signature but no definition at the top level, or with a type before the name, as in
    [Velocity v = 0]. These are already reported. *)

val c_declarations : Syntax.Ir.program -> (Syntax.Ir.name * Syntax.Ir.name) list
(** Function definitions whose name is a C type, with their last parameter: [int] and [m] in
    [int m = n + 1]. *)

val of_right : Syntax.Ir.right -> t list
(** The names bound by all [proc]s within a right-hand side. *)

val params : Syntax.Ir.program -> Syntax.Ir.name list
(** The names declared by [param]. *)
