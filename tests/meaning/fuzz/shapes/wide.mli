(** A signal function that takes very many numbers, uses all of them, and has several outputs. *)

val output : Type.t

val definition : Scope.t -> string -> string * Type.t
(** A signal function of this name: its text, and the type of its input. *)

val part : Scope.t -> Type.t -> call:string -> string option
(** The component that has this type in the result of a call. The call is given as text. *)
