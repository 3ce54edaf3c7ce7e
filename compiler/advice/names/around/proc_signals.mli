(** The signals of [proc]s, for messages about signals that are used outside their scope: after the
    bracket or comma that ends the [proc], or in a [where] after [proc … -> do], because such a
    [where] belongs to the enclosing definition. *)

type t = {
  name : Syntax.Ir.name;
  of_do : bool;  (** the [proc] is a whole right-hand side and uses a [do] *)
}

val of_surroundings : Syntax.Ir.right list -> t list
(** The right-hand sides are nested, innermost first. Returns the names bound by all [proc]s in the
    outermost right-hand side, and by each right-hand side that is itself a [proc] with a [do]. *)

val of_module : Syntax.Ir.program -> t list
(** The names bound by all [proc]s in the module's definitions. *)

val in_capitals : Syntax.Ir.program -> string list
(** Top-level definitions whose name is capitalized, as in [Speed = 0.3]. These are parsed as
    patterns, and have already been reported. *)

val without_definition : Syntax.Ir.program -> string list
(** Top-level names that have a signature but no definition, or that are defined with a type before
    the name, as in [Velocity v = 0]. These have already been reported. *)

type c_declaration = {
  head : Syntax.Ir.name;  (** the first word, which parses as the name of a function *)
  type_ : string;
  declared : Syntax.Ir.name;  (** the last word before the [=] *)
  value : string option;  (** the number after the [=] *)
}
(** A definition such as [const int m = 1]. *)

val c_declarations : Syntax.Ir.program -> c_declaration list
