(** Random expressions of a given type, as text that can stand anywhere. *)

type scope = {
  random : Random.State.t;
  bias : Bias.t;
  prefix : string;  (** of all names that the program defines *)
  methods : bool;  (** whether the methods of the shared classes may be used *)
  count : int ref;  (** of the names given *)
  seen : Coverage.t;
  declared : Type.t list;
  variables : (string * Type.t) list;
  functions : (string * Type.t list * Type.t) list;
  run : (scope -> int -> Type.t -> string) option;
      (** an instance with an output of this type; where none may stand, none *)
}

val fresh : scope -> string -> string
(** A name that starts so. *)

val note : scope -> string -> unit
(** See {!Coverage.note}. *)

val any_type : scope -> Type.t
val bind : (string * Type.t) list -> scope -> scope

val literal : scope -> Type.t -> string
(** A constant. *)

val expression : scope -> int -> Type.t -> string
(** No deeper than the number says. *)

val lambda : scope -> int -> Type.t -> Type.t -> string
(** A function of one argument. *)

val pattern : scope -> Type.t -> string * (string * Type.t) list
(** One that always matches, and its variables. *)
