(** Random chains of array functions: arrays of one size, each made of earlier ones and of the
    numbers that came out of them, each used several times.

    They are what the compiler makes loops of, joins, and must not join. *)

type binding = { name : string; ty : Type.t; text : string }

type makers = {
  expression : Scope.t -> int -> Type.t -> string;
  instances : (Type.t -> Type.t -> string) option;
      (** signal functions from one type to another, where instances may stand *)
}

val size : Scope.t -> int
(** A size for one, often that of an array in scope. *)

val make : Scope.t -> makers -> ?last:Type.t -> int -> binding list
(** Of so many elements, each binding after those that it uses; the last one, if its type is given,
    is an array of elements of that type. The arrays of that size in scope are used as well. *)

val result : Scope.t -> makers -> binding list -> Type.t -> string
(** A value of this type that most of the chain takes part in. *)
