(** Names under which a dump shows variables: the first variable with a name keeps it, and later
    ones get a number, as in [x_2]. Variables without a name are [_1], [_2]…, so the text does not
    depend on how many variables were created before. *)

type t

val create : unit -> t
val clear : t -> unit

val find : t -> id:int -> string -> string
(** [find t ~id name] is the name under which to show the variable [id], which the program calls
    [name]. *)

val find_opt : t -> int -> string option
(** The name that {!find} returned for the variable with this id; [None] if {!find} was not called
    for it. *)
