(** The step of a node that is C code of the user's: from the node's leaves to what
    {!Foreign_interface} says that C takes, the call, and back.

    The address of a foreign value may be that of none where a program computes what it then does
    not choose (of an event that did not occur, say): C is never given one, nothing is called then.
*)

val step : Vocabulary.t -> int -> Foreign_interface.t -> Ir.function_
