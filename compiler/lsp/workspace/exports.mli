(** The names that a module can export. *)

type entry = { name : string; space : Mentions.space; module_ : string  (** declaring module *) }

type t = {
  groups : (string * entry list) list;
      (** maps each name that an import list may contain to the entries it imports *)
  tree : Syntax.Ir.program;
}

val groups : string -> Syntax.Ir.program -> (string * entry list) list
(** The names that a module with this name and tree declares. *)

val of_text : module_:string -> path:string -> string -> t option
(** [None] if the text cannot be parsed. *)
