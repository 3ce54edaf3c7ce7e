(** The signals of a [proc], for messages about names that are used where they cannot be
    seen: behind the bracket or the comma that ends the [proc], or in a [where] after
    [proc … -> do], which belongs to the definition around it. *)

type t = {
  name : Syntax.Ir.name;
  of_do : bool;  (** the [proc] is a whole right side, with a [do] *)
}

val of_body : Syntax.Ir.body -> t list
(** What the [proc] that this body is binds: its input and, in its [do], the
    statements. *)

val of_right : Syntax.Ir.right -> t list
(** What all [proc]s within a right side bind. *)
