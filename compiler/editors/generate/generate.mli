(** Generates syntax highlighting for editors from the compiler's own tables. Command-line
    arguments: [textmate], [vim] or [emacs], then the path of the prelude. Prints the result to
    standard output. *)
