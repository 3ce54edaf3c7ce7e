(** Programs run by the interpreter on files. *)

val trace :
  Core.Ir.program ->
  entry:Core.Ir.Global.t ->
  input:string ->
  output:string option ->
  (unit, string list) result
(** [input]: a path, [-] for standard input; [output]: a path, otherwise
    standard output. See {!Interp.Trace.run}; files that cannot be opened or
    written are errors too. *)
