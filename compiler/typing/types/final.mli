(** Converts inferred types to their final form, when inference has finished.

    Type variables that nothing determines get a default: [()] for a type, [Float] for a
    representation, [1] for a unit.

    During inference, types share subterms, so a type may contain the same subterm many times at no
    cost. The final form can be exponentially larger: each [pair (pair …)] doubles it. Limits on
    size and nesting protect the later stages. *)

exception Too_large

val most_parts : int

val deepest : int
(** Maximum nesting depth. The curried arguments of a function count as one level. *)

val ty : Type.t -> Ir.ty
(** Calls share their work, so the total time is linear in the size of a definition's types, however
    often these occur.
    @raise Too_large beyond either limit, without building the large type *)

val representation : Type.representation -> Ir.representation

val scheme : Type.scheme -> Ir.scheme
(** @raise Too_large like {!ty} *)
