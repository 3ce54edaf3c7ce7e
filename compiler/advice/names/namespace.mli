(** The names of the namespaces in messages. *)

val noun : Resolve.Interface.namespace -> string
(** For example [type class]. *)

val unknown : Resolve.Interface.namespace -> string
(** The code of the diagnostic for an unknown name. *)
