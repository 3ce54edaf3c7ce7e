(** The corpus of messages: all programs in the files that are named on standard input: programs,
    pages with blocks, and sessions with here-documents. The first argument is the folder of the
    library. *)

open Basis

val check : library:string -> string -> Diagnostic.t list * Source.t
(** What is said of a text, which is called [program.frob]. *)

val each :
  (path:string -> text:string -> Diagnostic.t list -> Source.t -> Diagnostic.t -> unit) -> unit
(** With each diagnostic; the list is all of the same program. *)
