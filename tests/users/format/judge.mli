(** The laws of the formatter, told of a program and what has become of it by other means than its
    own: the trees are compared, and comments found by a scanner that knows nothing but comments and
    texts. *)

val parsed : string -> Syntax.Ir.program option
(** Without its places. *)

val verdict : string -> (string, string) result
(** Of a program that is one: the result of the formatter, or which law it breaks. *)
