(** Prints the faulty program of the page that explains a code, and the message about it. The
    argument is the code. *)
