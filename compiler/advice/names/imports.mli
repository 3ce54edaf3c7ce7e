(** Imports that a module has or lacks. *)

open Basis

val without_imported : Resolve.Visible.t -> string -> string
(** The hint without the imports that the module already has. *)

val add : Syntax.Ir.program -> string -> Diagnostic.t -> Diagnostic.t
(** Adds the fix that inserts this import below the module's imports. *)

type absent
(** A library name that is not imported. *)

val absent : Unknown.t -> absent option
(** [Some] if a library module defines the name. *)

val missing : Syntax.Ir.program -> absent list -> Diagnostic.t list
(** One diagnostic for each missing import, with all the names that need it. *)
