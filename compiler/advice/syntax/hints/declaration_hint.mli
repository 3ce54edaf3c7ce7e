(** Hints about declarations, and about reserved words used as names. *)

val choices : Found.rule
(** A `data` whose constructors begin with lower-case letters. *)

val defined_word : Found.rule
(** A definition whose name is a reserved word. *)

val without_where : Found.rule
(** A class or an instance without `where`. *)

val type_of_choices : Found.rule
(** A `type` with several alternatives. *)

val foreign_import : Found.rule
(** [foreign import], as in Haskell. *)

val without_value : Found.rule
(** A `param` without its default value, or a `foreign` without its C name. *)

val alias : Found.t -> Basis.Diagnostic.hint option
(** [type alias], as in Elm. *)

val capital : Found.rule
(** A type name that begins with a lower-case letter. *)

val local : Found.rule
(** A declaration inside a definition. *)

val word_as_name : Found.rule
(** Any other use of a reserved word as a name. *)

val reserved_word : string -> string
(** The hint for a reserved word used as a name. *)
