(** The scope of random expressions: the names and features that they may use. *)

type t = {
  random : Random.State.t;
  bias : Bias.t;
  prefix : string;  (** prefix of all names that the program defines *)
  methods : bool;  (** whether the methods of the shared classes may be used *)
  count : int ref;  (** number of names generated so far *)
  seen : Coverage.t;
  declared : Type.t list;
  variables : (string * Type.t) list;
  functions : (string * Type.t list * Type.t) list;
  run : (t -> int -> Type.t -> string) option;
      (** makes an instance with an output of this type; None if instances are not allowed here *)
  senses : (t -> int -> Type.t -> string) option;
      (** like [run], but within branches and functions, where only stateless instances are allowed
      *)
}

val fresh : t -> string -> string
(** A new name that starts with this text. *)

val note : t -> string -> unit
(** See {!Coverage.note}. *)

val any_type : t -> Type.t
val bind : (string * Type.t) list -> t -> t

val variable : t -> Type.t -> string option
(** A random variable in scope of this type. *)
