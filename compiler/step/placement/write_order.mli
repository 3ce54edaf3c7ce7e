(** The order in which a step writes its state: as the fields come, but everything that reads a
    field reads the old value. A write whose value needs a field that is written before it is
    [early].

    What it needs counts through all values that nothing else needs, because those are computed as
    late as possible; nothing but it, and the writes with which it shares an [If]. *)

type write = {
  write : Fragment.write;
  early : bool;  (** its values are computed before all writes *)
}

val of_usage : Usage.t -> write list

val written : write list -> Fragment.atom -> Usage.t -> bool
(** Does the value need a field that these write? *)
