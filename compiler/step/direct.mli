(** Machines of which a mode that is entered is stepped just once more in that
    instant: at its first instant none of its transitions can occur.

    What enters such a mode can step it at once, at a dt of 0; so C needs no
    loop around the modes. *)

val is_direct : Ir.run -> bool
(** False as well where what modes put out may be dropped, for that takes the
    order of a loop. *)
