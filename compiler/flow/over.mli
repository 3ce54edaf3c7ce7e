(** Outputs of machines that tell that all is over.

    A mode that runs a task as a part of itself ends at the instant at which the task is over. Then
    nobody sees any more what the task's machine keeps, nor what else it puts out. *)

(** What becomes of an output of a machine in all nodes that run the machine's node as a part of
    themselves. *)
type use = {
  ends : bool;  (** they are modes, which end where the output is true *)
  drops : bool;  (** it is put out as it is, which is dropped where they end *)
}

val uses : Ir.program -> int -> use list
(** Of the outputs of that node's machine. Empty if it has none, if nobody runs it, or if not all
    that do are known to step it just once at each instant. *)

val outputs : Ir.program -> int option array
(** By mode, the number of its output that tells its machine's users that all is over, if where it
    is true everything else about the mode, its state and its other outputs, is dropped. *)
