(** Random signal functions of events: the event library and the switches. *)

type maker = {
  values : Scope.t;  (** static *)
  signal_function : Scope.t -> int -> Type.t -> Type.t -> string;
      (** a signal function of these types, no deeper than the number says, that may use the scope's
          variables as static values *)
}

val alternatives : maker -> int -> Type.t -> Type.t -> (int * (unit -> string)) list
(** With weights; none, if there is no way to make one of these types. *)

val ending : maker -> slow:bool -> int -> Type.t -> Type.t -> Type.t -> string
(** [ending m ~slow fuel a b c], of type [SF a (b, Event c)]; if [slow], its event does not occur at
    its first instant, and the compiler can tell. *)

val time : maker -> string
(** A constant time, odd ones too. *)

val mode :
  maker -> earlier:bool -> continuation:(Scope.t -> string) -> int -> Type.t -> Type.t -> string
(** A switch in tail position, into what the continuation makes in the scope of the event's value.
    If [earlier], it leads back, so it takes time. *)
