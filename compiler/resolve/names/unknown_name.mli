(** Reports names without a meaning, with advice: a similar name, the module to import, the word of
    Frob for one of another language, or the place where the name would have a meaning. *)

val report :
  Scope.t ->
  'a Interface.space ->
  locals:string list Lazy.t ->
  signals:Proc_signals.t list Lazy.t ->
  Syntax.Ir.name ->
  unit
(** An unqualified name. [locals] and [signals] as in {!Lookup.find_value}. *)

val report_module : Scope.t -> Syntax.Ir.name -> Syntax.Ir.name -> unit
(** The name of a module, before a qualified name, that is not imported. *)
