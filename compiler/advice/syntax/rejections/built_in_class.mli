(** Instances of classes that are built in, such as [Eq]. *)

open Basis

val instance : at:Span.t -> string -> Diagnostic.t
(** E0366: the program cannot declare an instance of this class. *)
