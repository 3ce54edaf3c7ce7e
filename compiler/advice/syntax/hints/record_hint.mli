(** Hints about records and their fields. *)

val without_names : Found.rule
(** A record's values without the field names. *)

val with_points : Found.rule
(** [P { .x = 1 }], as in C. *)

val in_a_unit : Found.rule
(** [kg.m], meant as a product of units. *)

val without_comma : Found.rule
(** Two fields without a comma between them. *)

val typed : Found.rule
(** A field with `::`, in a record value or after another field without a comma. *)

val without_constructor : Found.t -> string
(** The hint for a record value that lacks its constructor. *)

val constructor_of_data : Found.rule
(** [data P = { x :: Float }], without a constructor. *)

val type_before_name : Found.rule
(** [data P = P { Float x }], a field as in C. *)

val changed_copy : Found.t -> Basis.Diagnostic.hint option
(** [{ r | speed = 1 }] or [{ r with speed = 1 }]. *)

val block_in_braces : Found.t -> Basis.Diagnostic.hint option
(** A block in braces, as in C. *)

val without_equation : Found.rule
(** A name in braces without an `=` after it. *)

val changed : Found.rule
(** [r { speed + 1 }], without an `=`. *)

val strict : Found.rule
(** A strict field, as in Haskell. *)

val capital : Found.rule
(** A field name that begins with a capital letter. *)
