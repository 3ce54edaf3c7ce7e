(** Hints about records and their fields. *)

val without_names : Found.rule
(** The values of a record without the names of their fields. *)

val in_a_unit : Found.rule
(** [kg.m], where a product of units is meant. *)

val without_comma : Found.rule
(** Two fields without a comma between them. *)

val typed : Found.rule
(** A field with `::`, in a value or after another field. *)

val block_in_braces : Found.rule
(** A block in braces. *)

val without_equation : Found.rule
(** A name in braces that no `=` follows. *)

val changed : Found.rule
(** [r { speed + 1 }]. *)

val strict : Found.rule
(** A strict field, as in Haskell. *)

val capital : Found.rule
(** The name of a field that begins with a capital. *)
