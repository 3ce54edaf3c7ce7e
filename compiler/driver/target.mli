(** The machines that executables for robots are made for. *)

type t

val names : string list
val of_name : string -> t option

val meaning : t -> string
(** In a few words, for the user. *)

val linked : t -> real:Basis.Real.t -> Resources.t -> name:string -> Commands.linked

val size_tool : t -> string option
(** The program that tells how much memory an executable needs, where that is
    of interest. *)

val state_of : string -> string * string
(** The file, name and content, with the memory of a program's state, for hosts
    without a heap. *)
