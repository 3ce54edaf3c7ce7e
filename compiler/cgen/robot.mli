(** The robots whose input and output types are declared in a module of the
    standard library, and as C structs in a header that is installed with
    [frobc]. *)

type t = {
  module_ : string;  (** [Pioneer]: it declares [PioneerInput], [PioneerOutput] *)
  name : string;  (** [pioneer], for hosts *)
  header : string;  (** [frob/pioneer.h] *)
}

val of_shape : Flow.Ir.shape -> t option
(** The robot that a program's whole input or output belongs to. *)


val names : string list
val of_name : string -> t option
