(** Units of measure during inference: products of rational powers of base units, of unit variables
    named in a signature, and of unsolved unit variables.

    Unifying two units means solving one linear equation in the exponents. Over the rationals, any
    variable of an equation can be solved for. Eliminating one variable per equation (Gaussian
    elimination, one row at a time) therefore gives the most general solution. *)

type t
(** A product of powers. {!resolve} substitutes the solutions found later. *)

type rigid = { variable : Ir.variable; depth : int }
(** A universally quantified variable. [depth]: the number of generalizing definitions around the
    definition that quantifies the variable. Variables of outer definitions must not depend on it.
*)

type flexible
(** An unsolved variable. *)

val one : t
val base : Ir.Global.t -> t
val of_rigid : rigid -> t

val fresh : id:int -> depth:int -> t
(** A new unsolved variable. *)

val multiply : t -> t -> t
val divide : t -> t -> t
val power : t -> Rational.t -> t

val unify : t -> t -> bool
(** Unifies the units by the most general solution. Returns [false], without changing anything, if
    there is none. *)

val equal : t -> t -> bool
(** Are the units equal, regardless of how variables are solved later? *)

val resolve : t -> t
(** Substitutes all solutions found so far. *)

val lower : depth:int -> t -> bool
(** Ensures that solutions found later do not depend on rigid variables deeper than [depth]. Returns
    [false] if the unit already depends on one. *)

val is_open : t -> bool
(** Does the unit contain unsolved variables? *)

(** {1 The parts of a resolved unit, sorted} *)

val base_powers : t -> (Ir.Global.t * Rational.t) list
val rigid_powers : t -> (rigid * Rational.t) list

val flexible_powers : t -> (int * Rational.t) list
(** Unsolved variables, by id. *)

val generalize : fresh:(unit -> rigid) -> t -> rigid option
(** Solves one unsolved variable such that the whole unit becomes a new rigid variable; [None] if
    nothing is unsolved. Applied to the units of a type from left to right, it produces the simplest
    principal form: [Float[u] -> Float[u^2]], never [Float[m u] -> Float[m^2 u^2]]. *)

val substitute : (int -> t option) -> t -> t
(** Substitutes units for rigid variables, which are given by their ids. *)

val to_ir : t -> Ir.unit_
(** Unsolved variables become 1. *)
