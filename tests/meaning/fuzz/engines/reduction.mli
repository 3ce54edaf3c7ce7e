(** Smaller programs made of the text of a program, right or wrong: who asks for them has them
    compiled.

    Random programs put everything into parentheses and one equation on a line, so text is structure
    enough. *)

val paragraphs : string -> string list
(** What stands between blank lines. *)

val lines : string -> string list

val without_some : separator:string -> string list -> (string -> bool) -> string list
(** [without_some ~separator parts good]: as few of the parts as the search finds such that they are
    [good] when joined: first large chunks are left out, then smaller ones. All of them are. *)

val at : string -> int -> (int * string list) option
(** [at text i]: the first place from [i] on where something can stand for what stands there, and
    the texts with something smaller there, the smallest first. *)
