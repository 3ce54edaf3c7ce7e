(** Generated C that needs no other files of frobc, so that only two files need to be copied to a
    board. *)

val files : Resources.t -> real:Basis.Real.t -> Cgen.Emit.t -> (Cgen.Emit.t, string) result
(** The source contains its helpers and elementary functions ({!Cgen.Helpers.standalone}), and the
    header contains the types of its robot. There is no separate header for a user-defined robot. *)
