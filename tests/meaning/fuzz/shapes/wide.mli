(** A signal function that is given very many numbers, needs them all, and gives several. *)

val output : Type.t

val definition : Scope.t -> string -> string * Type.t
(** Of that name: the text, and the type of its input. *)

val part : Scope.t -> Type.t -> call:string -> string option
(** What a call of it, as text, gives of this type. *)
