(** Builds arrays whose elements depend on earlier elements. *)

val map : stage:string -> (before:(int -> 'b) -> int -> 'a -> 'b) -> 'a array -> 'b array
(** Calls the function with each index and element. The function can look up the results for earlier
    indices with [before]; looking up any other index is reported as a bug in this [stage]. *)
