(** Finding and reading the modules of a program.

    [import M] means [M.frob] beside the importer, else in the library. The prelude comes from the
    library only, and every other module imports it without saying so. *)

type import = {
  declaration : Syntax.Ir.import option;  (** [None]: the prelude's, unwritten *)
  module_ : string;
}

type t = {
  name : string;
  file : string;  (** as diagnostics show it; the library's under its folder's name *)
  library : bool;
  syntax : Syntax.Ir.program;
  imports : import list;  (** those that were found *)
  complete : bool;  (** all were *)
}

val load :
  Basis.Diagnostic.sink ->
  files:Files.t ->
  remember:(file:string -> string -> unit) ->
  library:string ->
  ?also:string ->
  string ->
  t list
(** The modules that the program in a file consists of, imports before importers and the program
    last; what cannot be read or parsed is left out with a diagnostic (E0201 to E0203). The module
    in the file [also] is one of them whether it is imported or not, and an import of its name means
    it. A file that is, byte for byte, a module of the library counts as that module. *)
