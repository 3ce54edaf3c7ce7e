(** Builds Typed programs by hand, to test the stages after inference. *)

open Typing.Ir

val float : ty
val local : int -> string -> Local.t

(** {1 Expressions} *)

val var : Local.t -> ty -> expr
val number : int -> expr
val boolean : bool -> expr
val tuple : expr list -> expr

val apply : expr -> expr -> expr
(** Applies a function or runs a signal function, depending on the type of the first expression. *)

val plus : expr -> expr -> expr

val delay : expr -> expr -> expr
(** [delay x0 s], with the delay run on [s]. *)

val case : expr -> (pattern * expr) list -> expr
val guards : (expr * expr) list -> expr option -> expr
val let_ : binding list -> expr -> expr
val lambda : pattern list -> expr -> expr
val proc : pattern -> binding list -> expr -> expr

(** {1 Patterns and bindings} *)

val any : ty -> pattern
val bound : Local.t -> ty -> pattern
val pair : pattern -> pattern -> pattern
val literal : int -> ty -> pattern
val construct : constructor -> ty -> pattern list -> pattern
val binding : pattern -> expr -> binding

(** {1 Data: [Maybe], in the main module} *)

val nothing : constructor
val just : constructor
val maybe_of : ty -> ty
val program : (string * expr) list -> program

(** {1 Messages} *)

val messages : (Basis.Diagnostic.sink -> program -> unit) -> (string * expr) list -> string
(** The messages of a pass: one line for each message, and one for each of its labels. *)
