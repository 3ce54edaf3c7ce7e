(** Random top-level definitions. The functions return their text, and the scope that includes them.
*)

val function_ : Signal_function.scope -> string -> string * Signal_function.scope
(** A function of this name. *)

val signal_function :
  Signal_function.scope ->
  parameters:Signal_function.parameter list ->
  input:Type.t ->
  signals:Type.t list ->
  result:Signal_function.output ->
  string ->
  string * Signal_function.scope
(** A signal function of this name, with equations for signals of these types. *)

val wide : Signal_function.scope -> string * Signal_function.scope
(** See {!Wide}. *)

val modes : Signal_function.scope -> string * Signal_function.scope
(** Signal functions with parameters that switch into each other in tail position. *)

val tasks : Signal_function.scope -> string * Signal_function.scope
(** Tasks that continue as each other, and signal functions that run them. *)

val instances : Signal_function.scope -> Type.t -> string
(** Instances of the shared classes for a declared type; some methods keep their defaults. *)
