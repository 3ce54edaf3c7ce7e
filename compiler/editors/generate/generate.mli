(** Generates the highlighting for editors from the compiler's own tables. Its command-line
    arguments are [textmate], [vim] or [emacs], and the file of the prelude. It prints the result.
*)
