(** Reads a recording's parameter values from the lines before its header, for example
    [# param kTurn=4[1/m]]. *)

type settings = (Core.Ir.Global.t * Value.t) list

val is_line : string -> bool
(** Is this line before the header a comment rather than a row? *)

val line : Core.Ir.program -> Core.Ir.param -> Value.t -> string

val read : Core.Ir.program -> set:settings -> string -> (settings, string) result * string option
(** Reads a line and returns the parameters that it sets, except those in [set], which an option has
    set. The second result is a warning for the user, if the line sets a parameter in [set] to a
    different value, or names a parameter that the program does not have. *)
