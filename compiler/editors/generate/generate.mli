(** The highlighting of editors, made of the compiler's own tables: [generate textmate|vim|emacs],
    then the prelude's file. Prints the file. *)
