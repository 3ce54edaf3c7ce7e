(** An undefined unqualified name, with the data that the rules for its message need. *)

open Basis

type t = {
  module_ : Module_syntax.t;
  namespace : Resolve.Interface.namespace;
  name : Syntax.Ir.name;
  names : string list Lazy.t;  (** the names in scope at the unknown name, including local ones *)
  locals : string list Lazy.t;
  signals : Proc_signals.t list Lazy.t;
      (** the signals of all [proc]s in the definition; those in scope are also in [locals] *)
  is_in : Resolve.Interface.names -> bool;  (** whether these names include the unknown name *)
}

val create :
  Module_syntax.t ->
  Resolve.Interface.any_space ->
  Syntax.Ir.name ->
  locals:string list Lazy.t ->
  around:Syntax.Ir.right list ->
  t

val text : t -> string
(** The source text of the module. *)

val is_unit : t -> string -> bool

val diagnostic : t -> Diagnostic.t
(** The diagnostic without hints. *)

val c_declaration : t -> Proc_signals.c_declaration option
(** The C declaration of the name, such as [int m = n + 1], which parses as the definition of a
    function [int]. *)
