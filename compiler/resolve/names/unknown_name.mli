(** Reports names without a meaning, with advice: a similar name, the module to import, Frob's
    equivalent for a word of another language, or the place where the name would have a meaning. *)

val report :
  Scope.t ->
  'a Interface.space ->
  locals:string list Lazy.t ->
  signals:Proc_signals.t list Lazy.t ->
  Syntax.Ir.name ->
  unit
(** Reports an unqualified name. [locals] and [signals]: see {!Lookup.find_value}. *)

val report_module : Scope.t -> Syntax.Ir.name -> Syntax.Ir.name -> unit
(** Reports a qualifier, given with the name that it qualifies, whose module is not imported. *)
