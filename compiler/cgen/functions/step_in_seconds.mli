(** The step for callers that only have a dt in seconds, such as [wall_follow_step]. *)

val of_step : Program_names.t -> root:int -> Ir.function_ -> Ir.function_
(** A function that rounds dt to whole nanoseconds and calls the root's step. If the program can
    observe the first dt, the function replaces it with 0. It contains only the conversions that the
    step needs. *)
