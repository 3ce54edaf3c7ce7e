(** Programs compiled to C, and by the C compiler with the runtime and the user's own files. *)

type linked = {
  machine : Toolchain.machine option;  (** this one if [None] *)
  inputs : string list;
  includes : string list;
  generated : (string * string) list;  (** more files, name and content *)
  sees : bool;  (** it has hosts for programs with cameras *)
}
(** What generated C is linked with, and for what; see {!Toolchain.build}. *)

val host_table : entry:string -> Cgen.Emit.t -> (string, string) result
(** The table by which hosts read and write the program's values. *)

val for_robot : name:string -> sees:bool -> Cgen.Emit.t -> (unit, string) result
(** Executables and boards drive a robot, and boards have no camera; an error of a program [name]
    for no robot, or with a camera where the host has none. *)

val built :
  ?quiet:bool ->
  ?batch:bool ->
  General.t ->
  Toolchain.kind ->
  entry:string ->
  sources:string list ->
  linked:(Resources.t -> name:string -> linked) ->
  string ->
  (Resources.t -> string -> int) ->
  int
(** Compiles a file, to C and by the C compiler with the user's own [sources], and goes on with the
    path of the result; tells what is wrong with it otherwise. [name] is that of the C files. *)

val shared :
  ?quiet:bool ->
  ?batch:bool ->
  ?generated:(string * string) list ->
  ?options:string list ->
  General.t ->
  entry:string ->
  sources:string list ->
  string ->
  (Resources.t -> string -> int) ->
  int
(** Likewise, of a shared object for a host. [quiet]: only errors are told, no warnings;
    [generated]: more C files; [options]: for the C compiler. *)

val hosted :
  General.t ->
  entry:string ->
  sources:string list ->
  string ->
  host:(Resources.t -> string) ->
  arguments:(Resources.t -> string -> string list) ->
  int
(** Hands over to a host, which runs the program as a shared object; [arguments]: of the path of
    that. *)

val missing_host : string -> int
(** The status, when it is told. *)
