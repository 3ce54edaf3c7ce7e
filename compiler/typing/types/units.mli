(** Units of measure while types are inferred: products of rational powers of base units, of the
    unit variables that a signature names, and of unit variables still to be found.

    Unifying two units is solving one linear equation in the exponents; over the rationals any
    variable can be solved for, so the most general solution of each equation is found by
    eliminating one variable (Gaussian elimination, one row at a time). *)

type t
(** A product. Solutions found later show through {!resolve}. *)

type rigid = { variable : Ir.variable; depth : int }
(** A variable that stands for every unit. [depth]: how many generalizing definitions are around the
    one that quantifies it; nothing further out may depend on it. *)

type flexible
(** To be found. *)

val one : t
val base : Ir.Global.t -> t
val of_rigid : rigid -> t

val fresh : id:int -> depth:int -> t
(** A new variable to be found. *)

val multiply : t -> t -> t
val divide : t -> t -> t
val power : t -> Rational.t -> t

val unify : t -> t -> bool
(** Makes them equal by the most general solution; [false], and nothing changed, if there is none.
*)

val equal : t -> t -> bool
(** Already equal, whatever is found later. *)

val resolve : t -> t
(** With all solutions put in. *)

val lower : depth:int -> t -> bool
(** Nothing found later for it may depend on rigid variables deeper than [depth]; [false] if it does
    already. *)

val is_open : t -> bool
(** Has variables to be found. *)

(** {1 The parts of a resolved unit, sorted} *)

val base_powers : t -> (Ir.Global.t * Rational.t) list
val rigid_powers : t -> (rigid * Rational.t) list

val flexible_powers : t -> (int * Rational.t) list
(** By id. *)

val generalize : fresh:(unit -> rigid) -> t -> rigid option
(** Solves one variable to be found so that the whole unit is a new rigid variable; [None] if all is
    found. Taking a type's units from left to right in this way gives the simplest principal form:
    [Float[u] -> Float[u^2]], never [Float[m u] -> Float[m^2 u^2]]. *)

val substitute : (int -> t option) -> t -> t
(** Replaces rigid variables, by id. *)

val to_ir : t -> Ir.unit_
(** What is not found is 1. *)
