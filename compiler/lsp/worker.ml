type 'a t = { pid : int; descriptor : Unix.file_descr; received : Buffer.t; chunk : Bytes.t }
type 'a progress = Running | Done of 'a | Lost

let descriptor t = t.descriptor

(* Only the server keeps the editor's streams open, so that they close when the server ends. *)
let leave_streams () =
  let nothing = Unix.openfile "/dev/null" [ O_RDWR ] 0 in
  Unix.dup2 nothing Unix.stdin;
  Unix.dup2 nothing Unix.stdout;
  Unix.close nothing

(* Makes the garbage collector run rarely, so that it does not write to memory that the two
   processes share (copy-on-write). The process ends before it needs to reclaim memory. *)
let work compute into =
  leave_streams ();
  Gc.set { (Gc.get ()) with space_overhead = 1000 };
  (* Both processes run the same program at the same addresses, so results may contain closures. *)
  let result = Marshal.to_bytes (compute ()) [ Closures ] in
  let rec write from =
    if from < Bytes.length result then
      write (from + Unix.write into result from (Bytes.length result - from))
  in
  write 0

let start compute =
  let descriptor, into = Unix.pipe ~cloexec:true () in
  match Unix.fork () with
  | 0 ->
      Unix.close descriptor;
      let status = match work compute into with () -> 0 | exception _ -> 1 in
      Unix._exit status
  | pid ->
      Unix.close into;
      { pid; descriptor; received = Buffer.create 65536; chunk = Bytes.create 65536 }

let rec reap pid =
  match Unix.waitpid [] pid with
  | _, status -> status
  | exception Unix.Unix_error (EINTR, _, _) -> reap pid
  | exception Unix.Unix_error _ -> WEXITED 1

let ended t =
  Unix.close t.descriptor;
  reap t.pid

let progress t =
  match Unix.read t.descriptor t.chunk 0 (Bytes.length t.chunk) with
  | 0 -> (
      match ended t with
      | WEXITED 0 -> Done (Marshal.from_string (Buffer.contents t.received) 0)
      | WEXITED _ | WSIGNALED _ | WSTOPPED _ -> Lost)
  | n ->
      Buffer.add_subbytes t.received t.chunk 0 n;
      Running
  | exception Unix.Unix_error (EINTR, _, _) -> Running
  | exception Unix.Unix_error _ ->
      ignore (ended t);
      Lost

let stop t =
  (try Unix.kill t.pid Sys.sigkill with Unix.Unix_error _ -> ());
  ignore (ended t)
