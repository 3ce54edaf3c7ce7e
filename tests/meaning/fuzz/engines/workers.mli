(** Runs the same work in several processes in parallel. *)

val run :
  jobs:int ->
  folder:string ->
  enough:('a -> bool) ->
  (int -> folder:string -> 'a) ->
  ('a, string) result list
(** [run ~jobs ~folder ~enough work] returns the results of [work i] for each [i] below [jobs], each
    computed in its own process and folder. The error says how a process died. When a result is
    [enough], the other processes are ended and their results omitted. If this process exits early,
    so do the others. *)
