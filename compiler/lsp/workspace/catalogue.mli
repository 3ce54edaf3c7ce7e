(** The names in scope in a source text, and those that it could import. *)

type entry = Exports.entry = { name : string; space : Mentions.space; module_ : string }

type import = {
  of_module : string;
  alias : string option;
  qualified : bool;
  items : string list option;
}

val imports : Tokens.token array -> import list
(** The imports of a text, which may contain syntax errors. *)

val exports : Workspace.t -> directory:string -> string -> entry list
(** The names that a module exports, as seen from this folder. *)

val in_scope : Workspace.t -> Document.t -> import list -> entry list
(** The names that can be used without a qualifier: the module's own names, and those of the prelude
    and the imports. *)

val library : Workspace.t -> (string * entry list) list
(** All library modules except the prelude, with their exports. *)

val modules : Workspace.t -> directory:string -> string list
(** The modules that a program in this folder can import. *)
