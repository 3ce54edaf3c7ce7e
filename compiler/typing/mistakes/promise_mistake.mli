(** [E0309]: classes that a definition needs of its signature's variables, and that the signature's
    context does not promise. One message a signature: it is one line that has to change. *)

type t = {
  required : Context.required;  (** who needs it *)
  class_ : Ir.class_;  (** what is needed, perhaps through instances *)
  variable : Ir.variable;
  of_ : Type.t;  (** the variable as a type *)
}

val report : Context.t -> t list -> unit
(** In the order in which they are needed. What another one that is missing implies is left out. *)
