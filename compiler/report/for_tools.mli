(** The report as one JSON object.

    [program]; [entry] ([name], [file], [line]); [state_bytes]; [structs], the root's first: each
    [name], [file], [line], [bytes], [members], and a member [name], [line], [offset], [bytes] and
    [holds], which is [value] (with [purpose]), [struct] (with [struct], an index into [structs]),
    [structs] (likewise, and [count]), [mode] or [modes] (with [modes], each with [name], [bytes],
    [members]); [step_operations] by kind, and in it [calls] by elementary function;
    [reset_stack_bytes], [step_stack_bytes]; [library], the functions of the C library; [machines]
    ([name], [file], [line], [modes], [steps] and [transitions], each with [from], [to], [line],
    [at_first_instant], which says whether it may occur at the first instant of the mode that it
    leaves, and [event], the signal function that says when, where it may not); [assertions], how
    many, and [assertion_operations] and [assertion_bytes], which a step and the state have more
    where they are judged. *)

val to_string : ?judged:Judged.t -> Bounds.t -> string
(** Without a line end. *)
