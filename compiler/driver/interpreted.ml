let ( let* ) = Result.bind

(* [Sys_error] says the file and the reason. *)
let opened how what path =
  match how path with
  | channel -> Ok channel
  | exception Sys_error reason -> Error [ Printf.sprintf "cannot %s %s" what reason ]

let with_input path run =
  if String.equal path "-" then run ~name:"standard input" stdin
  else
    let* channel = opened open_in_bin "read" path in
    Fun.protect ~finally:(fun () -> close_in_noerr channel) (fun () -> run ~name:path channel)

(* A wrong header must not cost the output of a run before: the file is opened
   when there is something to write. *)
let with_output path run =
  let name = Option.value path ~default:"standard output" in
  let channel =
    match path with None -> lazy (Ok stdout) | Some path -> lazy (opened open_out_bin "write" path)
  in
  let exception Unwritable of string list in
  let write text =
    match Lazy.force channel with
    | Error errors -> raise_notrace (Unwritable errors)
    | Ok channel -> (
        try output_string channel text
        with Sys_error reason ->
          raise_notrace (Unwritable [ Printf.sprintf "cannot write %s: %s" name reason ]))
  in
  let finish () =
    match (path, Lazy.is_val channel) with
    | _, false -> Ok ()
    | _, true -> (
        let* channel = Lazy.force channel in
        match if Option.is_none path then flush channel else close_out channel with
        | () -> Ok ()
        | exception Sys_error reason -> Error [ Printf.sprintf "cannot write %s: %s" name reason ])
  in
  match run write with
  | exception Unwritable errors -> Error errors
  | result ->
      let finished = finish () in
      let* () = result in
      finished

let trace core ~entry ~input ~output =
  with_input input (fun ~name channel ->
      let read () = match input_char channel with c -> Some c | exception End_of_file -> None in
      with_output output (fun write -> Interp.Trace.run core ~entry ~name ~read ~write))
