(** Where random expressions stand: what they may use. *)

type t = {
  random : Random.State.t;
  bias : Bias.t;
  prefix : string;  (** of all names that the program defines *)
  methods : bool;  (** whether the methods of the shared classes may be used *)
  count : int ref;  (** of the names given *)
  seen : Coverage.t;
  declared : Type.t list;
  variables : (string * Type.t) list;
  functions : (string * Type.t list * Type.t) list;
  run : (t -> int -> Type.t -> string) option;
      (** an instance with an output of this type; where none may stand, none *)
  senses : (t -> int -> Type.t -> string) option;
      (** likewise in branches and functions: of what remembers nothing *)
}

val fresh : t -> string -> string
(** A name that starts so. *)

val note : t -> string -> unit
(** See {!Coverage.note}. *)

val any_type : t -> Type.t
val bind : (string * Type.t) list -> t -> t

val variable : t -> Type.t -> string option
(** One of those in scope that have this type. *)
