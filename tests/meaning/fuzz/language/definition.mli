(** Random definitions at top level: their text, and the scope after them. *)

val function_ : Signal_function.scope -> string -> string * Signal_function.scope
(** Of that name. *)

val signal_function :
  Signal_function.scope ->
  parameters:Signal_function.parameter list ->
  input:Type.t ->
  signals:Type.t list ->
  result:Signal_function.output ->
  string ->
  string * Signal_function.scope
(** Of that name, with equations for signals of these types. *)

val wide : Signal_function.scope -> string * Signal_function.scope
(** See {!Wide}. *)

val modes : Signal_function.scope -> string * Signal_function.scope
(** Signal functions that switch into each other in tail position, with parameters. *)

val tasks : Signal_function.scope -> string * Signal_function.scope
(** Tasks that go on as each other, and signal functions that run them. *)

val instances : Signal_function.scope -> Type.t -> string
(** Of the shared classes, for a declared type; some methods are left to their defaults. *)
