(** Lists the parameters of a program ([param]), and sets them to the values given on the command
    line. *)

type setting = {
  name : string;  (** [k] or [M.k] *)
  text : string;  (** the source text of the expression *)
}

val split : string -> setting option
(** Parses [k=text]. Spaces around the name are ignored. *)

val shown : string -> string
(** The name to show to the user. The definition of a value that overrides a parameter's default is
    shown under the parameter's name. *)

val give :
  Context.t ->
  remember:(file:string -> string -> unit) ->
  setting list ->
  Modules.t list ->
  Modules.t list
(** For each parameter that is set, adds a second definition of the same type, whose value is the
    given expression. Its name cannot occur in source code. See {!Ir.param}. *)

val of_modules : Modules.t list -> Ir.param list
(** All parameters, in the order of the modules and, within a module, in source order. *)
