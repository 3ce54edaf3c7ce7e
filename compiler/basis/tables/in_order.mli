(** Arrays whose elements are made one after the other. *)

val map : stage:string -> (before:(int -> 'b) -> int -> 'a -> 'b) -> 'a array -> 'b array
(** What is made of each element, and its number, with what was made of those [before] it at hand.
    To ask for one that comes later is a bug of that [stage]. *)
