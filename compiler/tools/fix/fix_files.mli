(** [frobc fix]: applies the fixes that diagnostics suggest. *)

open Basis

val applied : Source.t -> file:string -> Diagnostic.fix list -> string * Diagnostic.fix list
(** Applies the fixes to the file in order. Returns the new text and the fixes that were applied.
    Skips a fix that changes other files or overlaps another fix. Keeps comments ({!Kept_comments})
    and the line endings of the text. *)

type choice = Safe | All

val run : Common_options.t -> diff:bool -> choice -> string list -> int
(** Applies fixes and checks the program again until no fix is left, then writes the files. If
    [diff] is true, only prints the changes. Prints the remaining diagnostics like [frobc check],
    and returns their exit status. *)
