(** Loop fusion: joins loops over the same elements into one.

    [foldl min 0 (zipWith max a (map f b))] consists of three loops with an array between each two
    of them. The joined loop needs no arrays, and reads each element once. Two loops with the same
    count are joined if one reads the elements that the other computes, or both read the same array.
    They are not joined if one needs another result of the other loop (the whole array, or the final
    value of an accumulator), or if only one of them is known at the start, because a delay may
    start from its result. The node of the new loop has an instance of each node that the loops ran.

    Skips nodes that contain a cycle of items, which {!Inline} opens later. *)

val program : Ir.program -> Ir.program
(** Returns the same program, physically, if no loops were joined. *)
