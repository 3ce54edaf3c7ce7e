(** The same work in several processes at once. *)

val run :
  jobs:int ->
  folder:string ->
  enough:('a -> bool) ->
  (int -> folder:string -> 'a) ->
  ('a, string) result list
(** [run ~jobs ~folder ~enough work]: what [work i] gives for each i below [jobs], each in a process
    and a folder of its own. The error tells how a process died. With an answer that is [enough] the
    other processes are ended, and their answers left out. If this process exits before, so do they.
*)
