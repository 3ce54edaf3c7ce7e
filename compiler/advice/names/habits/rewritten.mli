(** Rewrites an unknown name of another language, together with the words around it in the source
    text, in Frob. Results with a {!Basis.Span.t} are a place in the text and its replacement. *)

open Basis

val unit_after_number : Unknown.t -> Name_in_text.unit_ option
(** The unit of [0.5 m/s], where the name is in a unit without brackets. *)

val integral : Unknown.t -> (string * string * Span.t) option
(** For a time step in the equation [x = x + v * dt]: [x], its integral, and the place of the
    right-hand side. *)

val member : Unknown.t -> (Span.t * string) option
(** [k] for [self.k]. *)

val controller : Unknown.t -> string option
(** Replaces a use of [pid] by [PID 0.5 0.1 0 e]. *)

val of_a_module : text:string -> Syntax.Ir.name -> (Span.t * string) option
(** [cos a] for [math.cos a], where the name is a module of another language whose functions are
    built in. *)

val call : Unknown.t -> (Span.t * string) option
(** The application of a function with its arguments, such as [x ^ 2] for [pow(x, 2)]. *)

val import_of : Unknown.t -> string -> string
(** The end of a hint that names the import required by this rewritten application; empty if it
    requires none. *)
