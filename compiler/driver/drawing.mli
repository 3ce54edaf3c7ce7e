(** What a program draws: counted in each program that draws, and put into its output for who asks
    for the probe [draw]. The program that drives a robot has nothing of it. *)

open Basis

val probe : string
(** What the drawing is called among probes. *)

val is_seen : Request.t -> bool
(** It is asked for, by itself or with all probes. *)

val row : Flow.Ir.program -> string
(** Its line in the list of probes; [""] if nothing is drawn. *)

val others : Flow.Ir.program -> string list -> string list
(** Of the probes that are asked for, those that are inner signals. *)

val program :
  Request.t ->
  Diagnostic.sink ->
  written:Typing.Ir.definition ->
  specialized:(int option -> Flow.Ir.program option) ->
  Flow.Ir.program ->
  Flow.Ir.program option
(** [specialized]: with room for so many marks. The program is the one without, and has been found
    right; it comes back with the number of its marks. *)
