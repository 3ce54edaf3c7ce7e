(** The parameters of a program ([param]), and values for them from outside, as a command line gives
    them. *)

type setting = { name : string;  (** [k] or [M.k] *) text : string  (** the expression *) }

val no_such : string
(** E0507: the program has no parameter of that name, or two. *)

val split : string -> setting option
(** Of [k=text]; blanks around the name do not count. *)

val shown : string -> string
(** A name as it stands in a source: of a parameter's value from outside that of the parameter. *)

val give :
  Basis.Diagnostic.sink ->
  remember:(file:string -> string -> unit) ->
  setting list ->
  Modules.t list ->
  Modules.t list
(** Beside each parameter that is set there is another one then, which no source can mention, of its
    type and with the expression as its value: see {!Ir.param}. *)

val of_modules : Modules.t list -> Ir.param list
(** In the order of the modules and of their sources. *)
