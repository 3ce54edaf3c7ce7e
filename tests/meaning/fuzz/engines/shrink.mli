(** Reduces a failing program to a small one that fails in the same way. *)

type failing = {
  text : string;  (** with the entry [main] *)
  outcome : Engines.outcome;
  recordings : Recording.t list;  (** a set of recordings on which it fails *)
}

val program :
  Engines.tools -> Engines.c_engine list -> seconds:float -> first:string list -> failing -> failing
(** Returns a smaller program, with few rows. The search starts with the first text of [first] that
    fails in the same way, or with the program itself if none does. It ends after [seconds]. *)
