(** Tables by small numbers, such as the ids of signals, variables and fields.

    Passes look signals up a hundred times for each line of a program. What the standard library's
    [Hashtbl] spends on hashing and comparing a key, and on room for what never comes, is here next
    to nothing; the calls are its. *)

type 'a t

val create : int -> 'a t
(** An empty table. It helps a little to know about how many keys will come. *)

val replace : 'a t -> int -> 'a -> unit
(** Binds the key to the value, and to nothing else any more. *)

val remove : 'a t -> int -> unit
val find_opt : 'a t -> int -> 'a option

val find : 'a t -> int -> 'a
(** @raise Not_found *)

val mem : 'a t -> int -> bool

val length : 'a t -> int
(** How many keys there are. *)

val reset : 'a t -> unit
(** Empty again. *)

val copy : 'a t -> 'a t

val fold : (int -> 'a -> 'b -> 'b) -> 'a t -> 'b -> 'b
(** In an order that depends on the keys and on how many came before: only for what has the same
    result in any order. *)
