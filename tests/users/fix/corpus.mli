(** The corpus of messages: all programs in the files listed on standard input, which are programs,
    pages with code blocks, and sessions with here-documents. The first argument is the folder of
    the library. *)

open Basis

val check : library:string -> string -> Diagnostic.t list * Source.t
(** The diagnostics of a text, as the file [program.frob]. *)

val each :
  (path:string -> text:string -> Diagnostic.t list -> Source.t -> Diagnostic.t -> unit) -> unit
(** Calls the function with each diagnostic; the list has all diagnostics of the same program. *)
