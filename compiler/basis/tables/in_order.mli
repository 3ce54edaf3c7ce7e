(** Builds arrays whose elements depend on earlier elements. *)

val map : stage:string -> (before:(int -> 'b) -> int -> 'a -> 'b) -> 'a array -> 'b array
(** Calls the function with each index and element. The function can look up the results for earlier
    indices with [before]; looking up a later one is a bug, reported for this [stage]. *)
