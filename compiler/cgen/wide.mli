(** Functions with very many parameters: what they are given and what they give are
    members of two structs.

    After it no function has more than {!Machine.Parameters.most} parameters. What is
    given becomes [const struct f_in *in], the results that were written through
    pointers [struct f_out *out]; state and time stay parameters of their own. A result that
    the function does not always write (a mode that ends leaves them) stays a pointer in it. A call
    fills the one struct before the statement in which it stands: what it is given has
    no side effects and is computed without harm even where it is not wanted. *)

val functions :
  struct_name:(string -> string) -> Ir.function_ list -> Ir.declaration list * Ir.function_ list
(** The structs' definitions, and the same functions in the same order, physically the
    same where nothing is to do. [struct_name] makes a name in the file. *)
