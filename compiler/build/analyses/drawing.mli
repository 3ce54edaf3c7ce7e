(** Counts the marks of each program that draws, and adds the drawing to the output if the user
    requests the probe [draw]. Programs that drive a robot do not contain the drawing. *)

open Basis

val probe : string
(** The name that selects the drawing as a probe. *)

val if_any : string
(** A name that requests the drawing, but is ignored in a program that does not draw. *)

val is_shown : Request.t -> bool
(** Whether the request includes the drawing, by name or with all probes. *)

val row : Flow.Ir.program -> string
(** The drawing's line in the list of probes; [""] if the program draws nothing. *)

val others : Flow.Ir.program -> string list -> string list
(** The requested probes, except those that select the drawing. *)

val bound : Diagnostic.sink -> Typing.Ir.definition -> Flow.Ir.program -> int option
(** The maximum number of marks that the program draws in one instant. The program must have been
    specialized with room for one mark. [None] after a diagnostic: E0432 if there is no maximum,
    E0413 if it draws too many different strings. *)
