(** [frobc lsp]: the compiler in an editor, by the Language Server Protocol 3.17 on standard input
    and output.

    One message after the other; texts are looked at when no message waits, so that of many changes
    only the last is. A request that was cancelled before its turn is not answered otherwise.
    Nothing that is sent ends the server but [exit] and the end of input. *)

val run : ?disk:(string -> (string, Resolve.Files.error) result) -> unit -> int
(** The exit status: 0 after [shutdown], else 1. [disk]: how files are read that are not open. *)
