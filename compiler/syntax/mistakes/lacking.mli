(** Declarations and equations that lack a part, or have one too many: what is said of the whole of
    them, and not of the token at which the grammar stops. *)

val diagnostic : Found.t -> Basis.Diagnostic.t option
(** E0110, in the words of the program: an assertion without its label, a `param` without its type,
    a `let` among equations, constraints without parentheses and their like. *)

val path : Found.t -> string option
(** The hint, where the name of a module is written as the path of a file. *)

val choices : Found.t -> string option
(** The hint, where the constructors of a `data` begin with small letters. *)
