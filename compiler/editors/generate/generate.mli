(** Generates the highlighting for editors from the compiler's own tables. The arguments are
    [textmate], [vim] or [emacs], and the file of the prelude; the result is printed. *)
