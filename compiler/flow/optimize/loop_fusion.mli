(** Loop fusion: joins loops over the same elements into one.

    [foldl min 0 (zipWith max a (map f b))] consists of three loops that pass two arrays between
    them. The joined loop does not need these arrays, and reads each element once. Two loops with
    the same count are joined if one reads the elements that the other computes, or if both read the
    same array. They are not joined if one needs more of the other than its current element: the
    whole array, or the final value of an accumulator. Nor are they joined if only one of them can
    run at the start, because its result may be the initial value of a delay. The node of the joined
    loop has an instance of each node that the original loops ran.

    The pass skips nodes that contain a cycle of items, which {!Inline} breaks later. *)

val program : Ir.program -> Ir.program
(** The result is physically equal to the argument if no loops were joined. *)
