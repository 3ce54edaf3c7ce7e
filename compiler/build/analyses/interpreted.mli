(** Runs programs in the interpreter, with files for input and output. *)

val trace :
  params:Interp.Recorded_params.settings ->
  dialect:Interp.Dialect.t ->
  Core.Ir.program ->
  entry:Core.Ir.Global.t ->
  marks:int ->
  input:string ->
  output:string option ->
  (unit, string list) result
(** - [params]: the parameters that are set.
    - [dialect]: the dialect of the input.
    - [input]: a path, or [-] for standard input.
    - [output]: a path; the default is standard output.

    Returns the errors of {!Interp.Trace.run}, and errors from opening or writing files. *)

val no_interpreter : string
(** The code of the diagnostic for a program that the interpreter cannot run. *)

val refusal : at:Basis.Span.t -> Flow.Ir.program -> Basis.Diagnostic.t option
(** The diagnostic to report if the program cannot be interpreted, because it calls the user's C or
    has foreign types in its input or output. [at] is the program's entry. *)
