(** Random signal functions with events, from the event library and from switches. *)

type maker = {
  values : Scope.t;  (** static *)
  signal_function : Scope.t -> int -> Type.t -> Type.t -> string;
      (** makes a signal function of these types, of limited depth, that may use the scope's
          variables as static values *)
}

val alternatives : maker -> int -> Type.t -> Type.t -> (int * (unit -> string)) list
(** Ways to make a signal function of these types, with weights; empty if there is none. *)

val ending : maker -> slow:bool -> int -> Type.t -> Type.t -> Type.t -> string
(** [ending m ~slow fuel a b c] has type [SF a (b, Event c)]. If [slow], its event does not occur at
    its first instant, and the compiler can prove it. *)

val time : maker -> string
(** A constant time, sometimes an extreme one. *)

val mode :
  maker -> earlier:bool -> continuation:(Scope.t -> string) -> int -> Type.t -> Type.t -> string
(** A switch in tail position into the text of [continuation], whose scope includes the event's
    value. If [earlier], it leads back to an earlier mode, so it takes time. *)
