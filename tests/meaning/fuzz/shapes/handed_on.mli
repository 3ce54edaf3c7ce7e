(** Modes that pass two numbers to each other; some of them need only a function of both.

    The compiler then passes the function's value instead, and computes that value where the numbers
    come from, or reuses it if it is already computed there. So the modes and their conditions
    compute the same function of these numbers and of the input, sometimes with opposite signs. *)

val definitions :
  Scope.t -> input:Type.t -> pattern:string * (string * Type.t) list -> string * string
(** The text, and the name of the signal function with this input that starts in the first mode. Its
    output is a Float. *)
