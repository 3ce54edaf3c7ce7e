(** [frobc lsp]: a server for the Language Server Protocol 3.17 on standard input and output.

    The server processes one message after another. It checks changed texts only when no message is
    waiting, so after several changes in a row, it checks only the latest text. Long computations
    run in separate processes ({!Worker}), which are killed when an edit makes their results
    useless. Responses may therefore arrive in a different order from the requests. If a request is
    cancelled before its turn, the response says so. Only [exit] or the end of the input stops the
    server. *)

val run : ?disk:(string -> (string, Resolve.Files.error) result) -> unit -> int
(** Returns the exit status: 0 after [shutdown], otherwise 1. [disk] reads files that are not open
    in the editor. *)
