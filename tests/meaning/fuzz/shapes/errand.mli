(** Small programs that consist of one task.

    They concentrate on cases that are rare in larger programs: a task that ends immediately
    although it has state, an [if] between tasks with more tasks after it, a task inside
    [untilRight], and a task that runs until the largest possible time and outputs the time. *)

val definitions : Scope.t -> input:Type.t -> string * string
(** The text, and the name of a signal function with this input that runs the task. It returns an
    [Either Float Float]. *)
