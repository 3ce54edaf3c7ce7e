(** Modes that hand two numbers on to each other, of which some need only what they compute of both.

    The compiler then hands on that, and computes it where the numbers come from, or takes what is
    computed there anyhow; so the modes and their conditions compute the same of these numbers and
    of the input, sometimes with other signs. *)

val definitions :
  Scope.t -> input:Type.t -> pattern:string * (string * Type.t) list -> string * string
(** The text, and the name of the signal function of that input that starts in the first mode. It
    gives a Float. *)
