(** Options that a command passes on to the host that it starts.

    The term evaluates to the arguments for the host, starting with the option's name, or to an
    empty list if the option is not given. This way each option is declared only once, and the
    command does not need a record for the values. *)

open Cmdliner

val flag : string -> doc:string -> string list Term.t

val one :
  'a Arg.conv ->
  ?print:('a -> string) ->
  ?absent:string ->
  string ->
  docv:string ->
  doc:string ->
  string list Term.t
(** [print] formats a value for the host; the default is the converter's printer. [absent] is the
    host's own default, shown in the manual page. *)

val many : string -> docv:string -> doc:string -> string list Term.t
(** An option that may be repeated. *)

val time_span : string -> docv:string -> doc:string -> string list Term.t
(** The user specifies a time span; the host receives it in seconds. *)

val all : string list Term.t list -> string list Term.t
(** The arguments of all these options, in this order. *)
