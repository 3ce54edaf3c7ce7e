(** The words for namespaces in messages. *)

val noun : Resolve.Interface.namespace -> string
(** The name of the namespace in messages, such as [type class]. *)

val unknown : Resolve.Interface.namespace -> string
(** The code of the diagnostic for an unknown name. *)
