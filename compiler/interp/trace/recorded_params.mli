(** The values of parameters that a recording was made with: the lines before its header,
    [# param kTurn=4[1/m]]. *)

type settings = (Core.Ir.Global.t * Value.t) list

val is_line : string -> bool
(** Before a header: is it no row? *)

val line : Core.Ir.program -> Core.Ir.param -> Value.t -> string

val read : Core.Ir.program -> set:settings -> string -> (settings, string) result * string option
(** What a line adds; a parameter that is [set] by option stays so. And a text for the user about
    one that is, to something else, or that the program does not have. *)
