(** The module-level names that a module can use, and their meanings. The module's own declarations
    hide imported names. Two imports of the same name clash only if the name is used. *)

open Basis

type t = {
  context : Context.t;
  visible : Visible.t;
  library : bool;
  complete : bool;
      (** whether every import was found; if not, unknown names are not reported, because they may
          belong to a missing module *)
  used : unit String_table.t;  (** imported names that the module uses *)
  records_of : Ir.Global.t list Interface.String_map.t Lazy.t;
      (** the record types in scope, by field name; uses of a field share one list, because it may
          be long *)
  params : Syntax.Ir.name list Lazy.t;  (** the parameters that the module declares *)
}

val create : Context.t -> library:bool -> complete:bool -> Visible.t -> t

val look : t -> 'a Interface.space -> Syntax.Ir.name -> 'a option
(** Looks up an unqualified name. Reports it only if it is ambiguous, not if it is unknown. *)

val records_with : t -> string list -> Ir.Global.t list
(** The record types in scope that have all these fields, sorted by name. *)

(** {1 For lookups} *)

val choose : t -> 'a Interface.space -> Syntax.Ir.name -> (Visible.import * 'a) list -> 'a option
(** Returns the name's first meaning, if there is one, and records that the name is used. If there
    are several meanings, reports that the name is ambiguous. *)

val size_named : t -> Syntax.Ir.name -> int option
(** Like {!Visible.size_named}, but also records that the name is used. *)
