(** Juxtaposition: a function applied, or a signal function run.

    The head's type decides. While it is unknown the question is put off, at the latest to the end
    of the top-level group; what is unknown even then is a function. *)

open Context

val infer : expressions -> t -> Resolve.Ir.expr -> typed
(** Of an [Apply], with all the applications that are its head. *)
