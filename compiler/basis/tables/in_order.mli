(** Builds arrays whose elements depend on earlier elements. *)

val map : stage:string -> (before:(int -> 'b) -> int -> 'a -> 'b) -> 'a array -> 'b array
(** Maps each index and element. The function can get the results for earlier indices from [before];
    asking for a later one is a bug, reported for this [stage]. *)
