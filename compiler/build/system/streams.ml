let null mode = Unix.openfile "/dev/null" [ mode ] 0

let is_open stream =
  match Unix.fstat stream with _ -> true | exception Unix.Unix_error (Unix.EBADF, _, _) -> false

(* A newly opened file gets the lowest free descriptor. /dev/null is opened for the opposite
   direction, so that reading or writing the stream still fails. *)
let keep_numbers () =
  List.iter
    (fun (stream, mode) ->
      if not (is_open stream) then
        match null mode with _ -> () | exception Unix.Unix_error _ -> ())
    [ (Unix.stdin, Unix.O_WRONLY); (Unix.stdout, Unix.O_RDONLY); (Unix.stderr, Unix.O_RDONLY) ]

let output_fault () =
  match flush stdout with () -> None | exception Sys_error reason -> Some reason

let drop_unwritable () =
  List.iter
    (fun (channel, stream) ->
      try flush channel with Sys_error _ -> Unix.dup2 (null Unix.O_WRONLY) stream)
    [ (stdout, Unix.stdout); (stderr, Unix.stderr) ]
