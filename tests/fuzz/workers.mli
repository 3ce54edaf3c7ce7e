(** The same work in several processes at once. *)

val run : jobs:int -> folder:string -> (int -> folder:string -> 'a) -> ('a, string) result list
(** [run ~jobs ~folder work]: what [work i] gives for each i below [jobs], each in
    a process and a folder of its own. The error tells how a process died. *)
