(** Rewrites an unknown name from another language, and the words around it in the source text, as
    Frob code. A result with a {!Basis.Span.t} consists of a place in the text and the text that
    replaces it. *)

open Basis

val unit_after_number : Unknown.t -> Name_in_text.unit_ option
(** The unit that contains the name, if the unit has no brackets, as in [0.5 m/s]. *)

val integral : Unknown.t -> (string * string * Span.t) option
(** If the name is a time step, such as [dt] in [x = x + v * dt]: [x], the integral to write
    instead, and the place of the right-hand side. *)

val member : Unknown.t -> (Span.t * string) option
(** [k] for [self.k]. *)

val controller : Unknown.t -> string option
(** The application of [pid] that replaces an application of another controller, such as
    [PID 0.5 0.1 0 e]. *)

val of_a_module : text:string -> Syntax.Ir.name -> (Span.t * string) option
(** [cos a] for [math.cos a], if the name is that of a module from another language and Frob has the
    module's functions built in. *)

val call : Unknown.t -> (Span.t * string) option
(** The Frob expression for a function call, such as [x ^ 2] for [pow(x, 2)]. *)

val import_of : Unknown.t -> string -> string
(** The end of a hint about this rewritten application, such as the import that it requires; may be
    empty. *)

val is_time_step : string -> bool
(** Is this a usual name of the length of a time step, such as [dt]? *)
