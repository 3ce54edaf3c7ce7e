(** A small program that fails as a large one does. *)

type failing = {
  text : string;  (** with an entry [main] *)
  outcome : Engines.outcome;
  recordings : Recording.t list;  (** on which it fails, all together *)
}

val program :
  Engines.tools -> Engines.c_engine list -> seconds:float -> first:string list -> failing -> failing
(** A smaller one, with few rows. The first of the texts [first] that fails alike is what the search
    begins with; if none does, it begins with the program itself. It ends after some time. *)
