(** Messages about undefined unqualified names, with advice: a similar name, the module to import,
    Frob's equivalent of a word from another language, or the place where the name would be valid.
*)

open Basis

type outcome =
  | Report of Diagnostic.t
  | Import of Imports.absent  (** to be reported together with other names from the same import *)
  | Class_as_type  (** reported once for each line *)
  | Silent  (** another diagnostic explains the problem *)

val outcome : Suggestion.t -> Unknown.t -> outcome

val class_as_type : Syntax.Ir.name -> Diagnostic.t
(** Reports a class that is used as a type, as in [SF HasSonar DiffDrive]. *)
