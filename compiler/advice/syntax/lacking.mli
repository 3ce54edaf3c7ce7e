(** Declarations and equations with a missing or a superfluous part. The messages describe the whole
    declaration and not just the token at which the parser stops. *)

val diagnostic : Found.t -> Basis.Diagnostic.t option
(** Reports E0110 for an assertion without its label, a `param` without its type, a `let` among
    equations, constraints without parentheses, and similar mistakes. *)

val path : Found.t -> string option
(** The hint for a module name written as a file path. *)

val choices : Found.t -> string option
(** The hint for a `data` whose constructors begin with lower-case letters. *)
