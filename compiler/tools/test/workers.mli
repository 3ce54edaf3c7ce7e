(** Runs several programs concurrently. *)

type result = {
  status : int;  (** 128 + n if signal n ended it (see {!Build.Signals.status}) *)
  output : string;
  errors : string;
}

val processors : unit -> int
(** The number of processors of this machine; 1 if unknown. *)

val run : ?ended:(int -> unit) -> jobs:int -> (string * string list) list -> result list
(** Runs programs with their arguments, at most [jobs] at a time. The results are in the order of
    the list. [ended] is called with the index of each program when it ends. *)
