(** Reports a program that is too large. *)

val report_work : Context.t -> Core.Ir.definition -> unit
(** Specialization has reached its step limit ({!Basis.Work}). Reports the probable cause: the
    elements of an array, the modes of a state machine, the specializations of a definition, values
    that consist of very many numbers, or the calls. The definition is the entry point to compile.
*)

val report_type : Context.t -> Core.Ir.definition -> Core.Ir.ty -> unit
(** A value of this type has too many signals. *)

val report_nesting : Context.t -> Core.Ir.definition -> Core.Ir.ty -> unit
(** This type nests data too deeply. *)
