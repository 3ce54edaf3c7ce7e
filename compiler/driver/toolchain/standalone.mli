(** Generated C that needs none of frobc's files, for who copies two files to a board. *)

val files : Resources.t -> real:Basis.Real.t -> Cgen.Emit.t -> (Cgen.Emit.t, string) result
(** The source has its helpers and elementary functions within ({!Cgen.Helpers.standalone}), the
    header the types of its robot; no header of a user's own robot is left to write. *)
