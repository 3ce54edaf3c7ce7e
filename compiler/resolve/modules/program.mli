(** The resolver's entry: a file to a whole program without open names. *)

val load :
  Basis.Diagnostic.sink ->
  files:Files.t ->
  remember:(file:string -> string -> unit) ->
  library:string ->
  ?also:string ->
  ?given:Parameters.setting list ->
  ?partial:bool ->
  string ->
  Ir.program option
(** [load sink ~files ~remember ~library ~also ~given main] reads the module in the file [main],
    what it imports, the module in [also], if any, and the prelude, from [files] and the folder
    [library], and gives parameters values; each text read is also given to [remember] with the name
    that spans use, for rendering. [None] after any error; all errors of all modules are emitted
    (E01xx by the parser, E02xx here). With [partial] what is right of a program is given after
    errors too, for editors; what is wrong has become [()]. *)
