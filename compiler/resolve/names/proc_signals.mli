(** The signals of a [proc], for messages about names that are used where they cannot be seen:
    behind the bracket or the comma that ends the [proc], or in a [where] after [proc … -> do],
    which belongs to the definition around it. *)

type t = {
  name : Syntax.Ir.name;
  of_do : bool;  (** the [proc] is a whole right side, with a [do] *)
}

val of_body : Syntax.Ir.body -> t list
(** What the [proc] that this body is binds: its input and, in its [do], the statements. *)

val of_module : Syntax.Ir.program -> t list
(** What all [proc]s of its definitions bind. *)

val in_capitals : Syntax.Ir.program -> string list
(** What is defined at the top level by a name with a capital, as in [Speed = 0.3]: which is a
    pattern, and an error already. *)

val without_definition : Syntax.Ir.program -> string list
(** What has a signature at the top level and no definition, or a type before its name, as in
    [Velocity v = 0]: an error already. *)

val c_declarations : Syntax.Ir.program -> (Syntax.Ir.name * Syntax.Ir.name) list
(** Definitions of functions whose names are types of C, with their last parameters: in
    [int m = n + 1] these are [int] and [m]. *)

val of_right : Syntax.Ir.right -> t list
(** What all [proc]s within a right side bind. *)

val params : Syntax.Ir.program -> Syntax.Ir.name list
(** The names that [param] declares. *)
