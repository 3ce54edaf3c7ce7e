(** Reports definitions that require a class of a type variable although the context of their
    signature does not promise it ([E0309]). There is one message per signature, because the fix
    changes one line. *)

type t = {
  required : Context.required;  (** the use that needs the class *)
  class_ : Ir.class_;  (** the needed class, possibly reached through instances *)
  variable : Ir.variable;
  of_ : Type.t;  (** the variable as a type *)
}

val report : Context.t -> t list -> unit
(** Reports the missing classes in the order in which they are needed. A class implied by another
    missing one is left out. *)
