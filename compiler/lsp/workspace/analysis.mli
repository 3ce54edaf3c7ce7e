(** The results of compiling one text as the main module of a program. *)

open Basis

type t = {
  path : string;  (** the path of the file, which may have different contents or not exist *)
  text : Text.t;
  shown : string;  (** the file name in the spans of this text *)
  tree : Syntax.Ir.program option;  (** [None] if it cannot be parsed *)
  diagnostics : Diagnostic.t list;
  sources : Source.t;  (** all texts that the compiler read *)
  resolved : Resolve.Ir.program option;  (** [None] if name resolution failed *)
  typed : Typing.Ir.program option;  (** [None] if type checking failed *)
  fault : string option;  (** a crash or timeout of the compiler *)
}

val check :
  library:string ->
  read:(string -> (string, Resolve.Files.error) result) ->
  path:string ->
  string ->
  t
(** Analyses the text. [read] returns the texts of other modules. Never raises an exception. *)

val partial : library:string -> read:(string -> (string, Resolve.Files.error) result) -> t -> t
(** Analyses the valid parts of a text that has errors. The result contains the trees of these
    parts. *)

val path_of : library:string -> string -> string
(** The path of a file, given its name in spans. *)

val guarded : (unit -> 'a) -> ('a, string) result
(** Runs a function of the compiler. Returns an error if it raises an exception or runs for longer
    than {!patience}. *)

val given_up : path:string -> string -> string -> t
(** The analysis of a text that could not be checked, for the given reason. *)

val at_once : (unit -> 'a) -> 'a option
(** The function's result, or [None] if it takes more than 80 ms of processor time, the longest that
    other requests should have to wait. The function may be interrupted anywhere, so it must not
    have lasting side effects. *)

val patience : float ref
(** Time limit in seconds, 30 by default. *)
