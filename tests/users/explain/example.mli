(** The programs on the page that explains a diagnostic. *)

type t = {
  code : string;
  files : (string * string) list;
      (** names and texts: the file with the mistake, then the modules that it imports *)
  fixed : string;  (** the corrected text of the first file *)
}

val find : string -> t
(** The example of the page for this code, which must have a page. *)

val faulty : library:string -> t -> Basis.Source.t * Basis.Diagnostic.t list
(** Writes the files to a new folder, and runs the command that produces the diagnostic. [library]:
    the folder with Frob's library. *)

val fixed : library:string -> t -> Basis.Source.t * Basis.Diagnostic.t list
(** The same for the corrected file. *)
