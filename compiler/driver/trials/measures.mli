(** What the judge of a trial measures: the numbers that its module's equations name and make by a
    measuring function of the library, as [error = meanOf e] does. A run tells what each is at its
    end. *)

type t = {
  name : string;  (** [error]; with the way to it where several are called so *)
  unit_ : string;  (** [m/s], or empty *)
  probe : string;  (** by which the judge shows it *)
}

val of_judge : Typing.Ir.program -> Core.Ir.program -> Probe.Catalogue.probe list -> t list
(** In the order of the text. *)
