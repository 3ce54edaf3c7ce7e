(** What machines and their modes read, and passes over it. *)

val atoms : Ir.transition list -> Ir.atom list
(** Conditions and arguments. *)

val map : (Ir.atom -> Ir.atom) -> Ir.transition list -> Ir.transition list

val read_in_step : Ir.machine -> Ir.atom list
(** What the machine reads of its node at every instant: inputs and controls. *)

val map_machine : (Ir.atom -> Ir.atom) -> (Ir.signal -> Ir.signal) -> Ir.machine -> Ir.machine
(** The atoms it reads and the signals it defines. *)

val into : Ir.program -> Ir.machine -> (Ir.transition -> unit) -> unit
(** All transitions of a machine: at the start, by controls, and those of its modes. *)

val owners : Ir.program -> int option array
(** Of each node the node of the machine that it is a mode of. *)
