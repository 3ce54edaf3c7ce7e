(** Which names a text may use, and which it could import. *)

type entry = { name : string; space : Mentions.space; module_ : string  (** that declares it *) }

type import = {
  of_module : string;
  alias : string option;
  qualified : bool;
  items : string list option;
}

val imports : Tokens.token array -> import list
(** That are written in a text, which may be broken. *)

val exports : Workspace.t -> directory:string -> string -> entry list
(** What a module gives to who imports it in this folder. *)

val in_scope : Workspace.t -> Document.t -> import list -> entry list
(** Without a qualifier: the module's own, the prelude's and the imports'. *)

val library : Workspace.t -> (string * entry list) list
(** The library's modules but the prelude, with what they export. *)

val modules : Workspace.t -> directory:string -> string list
(** That could be imported in this folder. *)
