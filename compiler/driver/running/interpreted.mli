(** Programs run by the interpreter on files. *)

val trace :
  params:Interp.Recorded_params.settings ->
  Core.Ir.program ->
  entry:Core.Ir.Global.t ->
  marks:int ->
  input:string ->
  output:string option ->
  (unit, string list) result
(** [params]: those that are set. [input]: a path, [-] for standard input; [output]: a path,
    otherwise standard output. See {!Interp.Trace.run}; files that cannot be opened or written are
    errors too. *)

val no_interpreter : string
(** The code of the diagnostic for a program that the interpreter cannot run. *)

val refusal : at:Basis.Span.t -> Flow.Ir.program -> Basis.Diagnostic.t option
(** The interpreter runs Frob only: that a program has code in C, or gives or takes what is C's.
    [at]: its entry. *)
