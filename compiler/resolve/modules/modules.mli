(** Finds and reads the modules of a program.

    [import M] refers to [M.frob] in the folder of the importing module or, if there is none, in the
    library. The prelude always comes from the library, and every other module imports it
    implicitly. *)

type import = {
  declaration : Syntax.Ir.import option;  (** [None] for the implicit import of the prelude *)
  module_ : string;
}

type t = {
  name : string;
  file : string;
      (** the name shown in diagnostics; library files are shown under the library folder's name *)
  text : string;  (** the source text *)
  library : bool;
  syntax : Syntax.Ir.program;
  imports : import list;  (** the imports whose modules were found *)
  complete : bool;  (** whether all imports were found *)
  program : string option;  (** if this module is in a {!Test_file}: the module that it tests *)
}

val load :
  Context.t ->
  files:Files.t ->
  remember:(file:string -> string -> unit) ->
  library:string ->
  ?also:string ->
  string ->
  t list
(** The modules of the program in a file: imported modules before those that import them, the
    program last. A module that cannot be read or parsed is reported and left out. A test file
    requires its program, comes after it, and must not have a header or a [main]. A program is
    loaded without its test file. The module in the file [also] is included whether or not it is
    imported, and an import of its name refers to it. A file with the same content as a library
    module is treated as that module. *)
