(** The C compiler tcc, which comes with frobc as [frob-tcc] for computers without another C
    compiler. *)

val is_named : string -> bool
(** Whether a C compiler is tcc, judging by the name of its program. *)

val is_own : string -> bool
(** Whether a C compiler is [frob-tcc]. It compiles what frobc generates, but not the user's files.
*)

val adapted : string -> string
(** Adapts generated C to avoid two bugs of tcc 0.9.27. *)

val archive : string -> string
(** Replaces the path of [libfrob.a] with the path of an archive that tcc can link; other paths are
    unchanged. *)
