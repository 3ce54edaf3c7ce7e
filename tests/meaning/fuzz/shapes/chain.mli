(** Random chains of array functions: arrays of one size, each computed from earlier ones and from
    numbers computed from those, and each used several times.

    The compiler turns them into loops, and fuses the loops where that is allowed. *)

type binding = { name : string; ty : Type.t; text : string }

type makers = {
  expression : Scope.t -> int -> Type.t -> string;
  instances : (Type.t -> Type.t -> string) option;
      (** makes a signal function from one type to another; None if instances are not allowed here
      *)
}

val size : Scope.t -> int
(** A size for a chain, often that of an array in scope. *)

val make : Scope.t -> makers -> ?last:Type.t -> int -> binding list
(** A chain of arrays with this many elements, in dependency order. If [last] is given, the last
    binding is an array with elements of this type. The chain also uses the arrays of this size in
    scope. *)

val result : Scope.t -> makers -> binding list -> Type.t -> string
(** A value of this type that depends on most of the chain. *)
