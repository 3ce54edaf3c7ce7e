(** Several programs at once. *)

type result = { status : int; output : string; errors : string }

val processors : unit -> int
(** Of this machine; 1 if it does not say. *)

val run : ?ended:(int -> unit) -> jobs:int -> (string * string list) list -> result list
(** Each a program and its arguments; at most so many run at a time. The results are in the order of
    the list, whatever ends first. [ended] is told the number of each that has, from 0. *)
