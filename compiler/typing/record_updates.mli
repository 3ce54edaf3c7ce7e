(** The updates of records may not be too many for their sizes.

    Core has no updates: it writes each as the whole record, with the fields that stay. So a program
    of many updates of a large record is far longer in Core than in its source. *)

val most_fields : int
(** The largest number of fields in the records of all updates together. *)

val check : Basis.Diagnostic.sink -> Ir.program -> unit
(** Emits [E0413], at the first update that exceeds {!most_fields}. Linear in the program. *)
