(** Entry point of the resolver: turns a file into a whole program in which all names are resolved.
*)

val load :
  Fact.t Basis.Facts.t ->
  files:Files.t ->
  remember:(file:string -> string -> unit) ->
  library:string ->
  ?also:string ->
  ?given:Parameters.setting list ->
  ?partial:bool ->
  string ->
  Ir.program option
(** [load facts ~files ~remember ~library ~also ~given main] reads the module in the file [main],
    its imports, the module in [also] (if any) and the prelude, from [files] and the folder
    [library], and sets the parameters in [given]. For rendering diagnostics, it passes each text
    that it reads to [remember], together with the file name that spans use. Reports the errors in
    all modules. The result is [None] after an error. With [partial], for editors, erroneous parts
    become [()] instead. *)
