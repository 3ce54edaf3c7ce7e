(** Lists and replaces the atoms that machines and their modes read. *)

val atoms : Ir.transition list -> Ir.atom list
(** The conditions and arguments of the transitions. *)

val map : (Ir.atom -> Ir.atom) -> Ir.transition list -> Ir.transition list

val read_in_step : Ir.machine -> Ir.atom list
(** The atoms that the machine reads in every instant: inputs and controls. *)

val map_machine : (Ir.atom -> Ir.atom) -> (Ir.signal -> Ir.signal) -> Ir.machine -> Ir.machine
(** Replaces the atoms that the machine reads and the signals that it defines. *)

val into : Ir.program -> Ir.machine -> (Ir.transition -> unit) -> unit
(** Visits all transitions of a machine: start, controls, and those of its modes. *)

val owners : Ir.program -> int option array
(** For each node that is a mode, the node that contains its machine. *)
