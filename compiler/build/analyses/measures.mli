(** The measurements of a trial's judge: the numbers that equations in its module compute with the
    library's measuring functions, for example [error = meanOf e]. A run reports their final values.
*)

type t = {
  name : string;  (** for example [error]; preceded by its path if the name is not unique *)
  unit_ : string;  (** such as [m/s]; may be empty *)
  probe : string;  (** name of the probe that contains it in the judge's output *)
}

val of_judge : Typing.Ir.program -> Core.Ir.program -> Probe.Catalogue.probe list -> t list
(** The measurements, in source order. *)
