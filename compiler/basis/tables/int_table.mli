(** Hash tables keyed by small integers, such as the ids of signals, variables and fields.

    Passes look up signals a hundred times for each line of a program. Unlike in the standard
    library's [Hashtbl], hashing and comparing keys costs almost nothing, and an empty table takes
    almost no memory. The interface is a subset of the interface of [Hashtbl]. *)

type 'a t

val create : int -> 'a t
(** An empty table. The argument is the expected number of keys; it only affects performance. *)

val replace : 'a t -> int -> 'a -> unit
(** Binds the key to the value, replacing any previous binding. *)

val remove : 'a t -> int -> unit
val find_opt : 'a t -> int -> 'a option

val find : 'a t -> int -> 'a
(** @raise Not_found *)

val mem : 'a t -> int -> bool

val length : 'a t -> int
(** The number of keys. *)

val reset : 'a t -> unit
(** Removes all bindings. *)

val copy : 'a t -> 'a t

val fold : (int -> 'a -> 'b -> 'b) -> 'a t -> 'b -> 'b
(** The order of the calls depends on the keys and on the table's history, so use this function only
    where the order does not affect the result. *)
