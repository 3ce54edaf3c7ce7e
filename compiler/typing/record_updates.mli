(** Limits the total size of record updates.

    Core does not have updates: each one becomes the construction of a whole record, including its
    unchanged fields. A program with many updates of a large record is therefore far larger in Core
    than in its source. *)

val most_fields : int
(** The maximum total number of fields in the records that all updates construct. *)

val check : Fact.t Basis.Facts.t -> Ir.program -> unit
(** Reports [E0413] at the update where the total first exceeds {!most_fields}. Takes time linear in
    the size of the program. *)
