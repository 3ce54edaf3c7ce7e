(** Loops over the same elements become one loop.

    [foldl min 0 (zipWith max a (map f b))] is three loops with an array between each two of them;
    as one it needs no arrays, and reads each element once. Two loops of the same count are joined
    if one takes the elements that the other gives, or if both take those of the same array; not if
    anything else that one of them needs comes out of the other: the whole array, or an
    accumulator's last value; and not if one is known at the start and the other is not, for a delay
    may start from it. The new loop's node has an instance of each node that the loops ran.

    Nodes in which a cycle of items has still to be opened (see {!Inline}) stay as they are. *)

val program : Ir.program -> Ir.program
(** The same program, physically, if there was nothing to join. *)
