(** Maps and sets of local variables and type variables, by their ids. *)

include Map.S with type key = int
module Set : Set.S with type elt = int

val restrict : Set.t -> 'a t -> 'a t
(** The entries of the given keys only; linear in the keys, not in the map. *)

module Table = Basis.Int_table
