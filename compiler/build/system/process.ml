type failure = Not_found of string | Failed of { status : int; errors : string }

let rec wait pid =
  match Unix.waitpid [] pid with
  | _, status -> Signals.status status
  | exception Unix.Unix_error (Unix.EINTR, _, _) -> wait pid

let start life program arguments ~stdin ~stdout ~stderr =
  match Child.start life program arguments ~stdin ~stdout ~stderr with
  | pid -> Ok pid
  | exception Unix.Unix_error ((Unix.ENOENT | Unix.EACCES), _, _) -> Error (Not_found program)
  (* for example ENOEXEC, for an executable built for another machine; shells use the exit status
     126 in this case *)
  | exception Unix.Unix_error (reason, _, _) ->
      Error (Failed { status = 126; errors = Unix.error_message reason })

let read_all channel =
  let text = Buffer.create 1024 and chunk = Bytes.create 1024 in
  let rec go () =
    match input channel chunk 0 1024 with
    | 0 -> Buffer.contents text
    | n ->
        Buffer.add_subbytes text chunk 0 n;
        go ()
  in
  go ()

let start_without_input program arguments ~stdout ~stderr =
  let null = Unix.openfile "/dev/null" [ O_RDONLY; O_CLOEXEC ] 0 in
  Fun.protect
    ~finally:(fun () -> Unix.close null)
    (fun () -> start Ends_with_all_it_started program arguments ~stdin:null ~stdout ~stderr)

let output program arguments =
  let read, write = Unix.pipe ~cloexec:true () in
  let started = start_without_input program arguments ~stdout:write ~stderr:write in
  Unix.close write;
  let channel = Unix.in_channel_of_descr read in
  let text = Fun.protect ~finally:(fun () -> close_in channel) (fun () -> read_all channel) in
  match Result.map wait started with
  | Ok 0 -> Ok text
  | Ok status -> Error (Failed { status; errors = text })
  | Error failure -> Error failure

(* Reads two streams to their ends at the same time, so that neither blocks the writer. *)
let read_both first second =
  let texts = [ (first, Buffer.create 1024); (second, Buffer.create 1024) ] in
  let chunk = Bytes.create 4096 in
  let rec go = function
    | [] -> ()
    | left -> (
        match Unix.select left [] [] (-1.) with
        | ready, _, _ ->
            let is_over stream =
              match Unix.read stream chunk 0 (Bytes.length chunk) with
              | 0 -> true
              | n ->
                  Buffer.add_subbytes (List.assoc stream texts) chunk 0 n;
                  false
            in
            let over = List.filter is_over ready in
            go (List.filter (fun stream -> not (List.mem stream over)) left)
        | exception Unix.Unix_error (Unix.EINTR, _, _) -> go left)
  in
  go [ first; second ];
  (Buffer.contents (List.assoc first texts), Buffer.contents (List.assoc second texts))

let result program arguments =
  let out_read, out = Unix.pipe ~cloexec:true () in
  let err_read, err = Unix.pipe ~cloexec:true () in
  let started = start_without_input program arguments ~stdout:out ~stderr:err in
  List.iter Unix.close [ out; err ];
  let finally () = List.iter Unix.close [ out_read; err_read ] in
  let text, errors = Fun.protect ~finally (fun () -> read_both out_read err_read) in
  match Result.map wait started with
  | Ok 0 ->
      prerr_string errors;
      Ok text
  | Ok status -> Error (Failed { status; errors })
  | Error failure -> Error failure

let run program arguments = Result.map ignore (output program arguments)

let hand_over program arguments =
  flush_all ();
  start Ends_with_us program arguments ~stdin:Unix.stdin ~stdout:Unix.stdout ~stderr:Unix.stderr
  |> Result.map wait

let become program arguments =
  flush_all ();
  Child.put_stack_back ();
  try Unix.execvp program (Array.of_list (program :: arguments))
  with Unix.Unix_error _ -> Not_found program
