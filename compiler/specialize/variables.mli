(** Maps and sets of local variables and type variables, by their ids. *)

include Map.S with type key = int
module Set : Set.S with type elt = int

val restrict : Set.t -> 'a t -> 'a t
(** The entries with the given keys. Takes time that is linear in the number of keys, not in the
    size of the map. *)

module Table = Basis.Int_table
