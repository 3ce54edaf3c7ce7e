(** Finds the size variables of signatures, such as the [n] of [Array n Float]. They cannot be used
    as values, so messages explain how to compute the size. *)

type t = Fact.size

val of_signature : name:string -> Ir.scheme -> Ir.pattern list -> t list
(** The size variables in the signature of a definition with these parameters. *)

val find : t list -> string -> t option
(** The innermost size variable with this name. The list is ordered innermost first. *)
