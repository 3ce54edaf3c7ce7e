(** Reports definitions that require classes of their signature's variables which the signature's
    context does not promise ([E0309]). There is one message per signature, because the fix changes
    one line. *)

type t = {
  required : Context.required;  (** the use that needs the class *)
  class_ : Ir.class_;  (** the needed class, possibly reached through instances *)
  variable : Ir.variable;
  of_ : Type.t;  (** the variable as a type *)
}

val report : Context.t -> t list -> unit
(** Reports the missing classes in the order in which they are needed. A class implied by another
    missing one is left out. *)
