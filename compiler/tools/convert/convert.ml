open Reporting

let ( >>= ) = Result.bind

type form = Recording | Mcap

let form path =
  match String.lowercase_ascii (Filename.extension (Packed.stem path)) with
  | ".csv" -> Ok Recording
  | ".mcap" when Packed.stem path = path -> Ok Mcap
  | _ ->
      Error
        (Printf.sprintf
           "the name of %s must end in .csv, .csv.gz or .csv.zst for a recording, or in .mcap for \
            MCAP"
           (Basis.Printable.name path))

let readable path =
  let name = Basis.Printable.name path in
  if not (Sys.file_exists path) then Error (Printf.sprintf "there is no file %s" name)
  else if Sys.is_directory path then Error (Printf.sprintf "%s is a folder" name)
  else Ok ()

let tell_torn (t : Recorded.t) =
  Option.iter
    (Printf.eprintf "warning: %s: %s; everything before that was converted\n"
       (Basis.Printable.name t.path))
    t.torn

let copy from into =
  let part = Bytes.create 65536 in
  let rec go () =
    match input from part 0 (Bytes.length part) with
    | 0 -> ()
    | n ->
        output into part 0 n;
        go ()
  in
  go ()

let copy_file from at =
  let input = open_in_bin from and output = open_out_bin at in
  let finally () =
    close_in_noerr input;
    close_out_noerr output
  in
  Fun.protect ~finally (fun () ->
      copy input output;
      flush output)

(* Calls [write] with the channel for the recording. The extension of [path] determines whether the
   output is compressed. *)
let writing path at write =
  let writer = Packed.writer ~named:path at in
  match write writer.channel with
  | result ->
      writer.close ();
      result
  | exception exn ->
      (try writer.close () with Sys_error _ -> close_out_noerr writer.channel);
      raise exn

(* {1 Recording to recording} *)

(* Keeps the complete rows of a truncated recording, and translates dialects to Frob's format. *)
let rows (t : Recorded.t) out =
  if t.torn = None && t.dialect = Interp.Dialect.ours then
    Packed.with_input t.path (fun channel -> Ok (copy channel out))
    |> Result.map_error (String.concat "\n")
  else Recorded.lines t (fun line -> output_string out (line ^ "\n"))

let again ~dialect from path =
  Recorded.survey ~dialect from >>= fun t ->
  Output.stream path (fun at -> writing path at (rows t)) >>= fun () -> Ok (tell_torn t)

(* {1 Recording to MCAP} *)

let to_mcap resources ~dialect from path =
  Recorded.survey ~dialect from >>= fun t ->
  Output.stream path (fun at ->
      let out = open_out_bin at in
      match To_mcap.write resources t out with
      | result ->
          close_out out;
          result
      | exception exn ->
          close_out_noerr out;
          raise exn)
  >>= fun () -> Ok (tell_torn t)

(* {1 MCAP to recording} *)

let write_frame folder message =
  match Foxglove.file_of message with
  | Some (name, text) when Frame_cell.is_name name ->
      let path = Filename.concat folder name in
      Output.folder folder >>= fun () ->
      (* The name contains a hash of the content, so if the file exists, it already has the right
         content. *)
      if Sys.file_exists path then Ok () else Output.write [ (path, text) ]
  | Some _ | None -> Error "it contains an image that is not a frame of a recording"

let of_mcap from path =
  let folder = Temporary.folder () and attached = ref None in
  let frames = Frame_cell.folder_of path in
  let take : Mcap_reader.record -> (unit, string) result = function
    | Attachment { name; copy } when form name = Ok Recording && !attached = None ->
        let kept = Filename.concat folder (Filename.basename name) in
        let out = open_out_bin kept in
        copy out;
        close_out out;
        attached := Some kept;
        Ok ()
    | Message { topic; data } when String.starts_with ~prefix:"/image/" topic ->
        write_frame frames data
    | Attachment _ | Message _ -> Ok ()
  in
  Mcap_reader.iter from take >>= fun () ->
  match !attached with
  | None ->
      Error (Printf.sprintf "cannot read %s: it contains no recording" (Basis.Printable.name from))
  | Some kept ->
      let is_as_it_was = Filename.extension kept = Filename.extension path in
      Output.stream path (fun at ->
          if is_as_it_was then Ok (copy_file kept at)
          else
            let damaged =
              Printf.eprintf "warning: the recording in %s: %s\n" (Basis.Printable.name from)
            in
            writing path at (fun out ->
                Packed.with_input ~damaged kept (fun channel -> Ok (copy channel out))
                |> Result.map_error (String.concat "\n")))

(* {1 MCAP from another program to recording} *)

(* Writes the table that the Python package frob extracts from the file. The extension of [path]
   determines whether the output is compressed. *)
let of_others from path =
  let name = Basis.Printable.name from in
  let cannot reason = Error (Printf.sprintf "cannot read %s: %s" name reason) in
  let table = Filename.concat (Temporary.folder ()) "table.csv" in
  let other = "it was written by another program" in
  match Extras.python ~modules:[ "mcap" ] with
  | None ->
      cannot
        (other
       ^ ", and reading it needs Python: on Debian, run `sudo apt-get install python3-venv`, then \
          `frobc extras install mcap`")
  | Some python -> (
      match Process.result python [ "-m"; "frob.mcap_command"; from; table ] with
      | Ok _ ->
          Output.stream path (fun at ->
              writing path at (fun out ->
                  Packed.with_input table (fun channel -> Ok (copy channel out))
                  |> Result.map_error (String.concat "\n")))
      | Error (Failed { errors; _ }) -> cannot (other ^ ", and " ^ String.trim errors)
      | Error (Not_found _) -> cannot (python ^ " is missing"))

(* {1 The command} *)

let content = function Recording -> Output.Table | Mcap -> Output.Mcap

let convert resources ~dialect from path =
  readable from >>= fun () ->
  form from >>= fun of_what ->
  form path >>= fun to_what ->
  Output.check ~reads:[ from ] [ { path; content = content to_what; asked = "convert" } ]
  >>= fun () ->
  match (of_what, to_what) with
  | Recording, Recording -> again ~dialect from path
  | Recording, Mcap -> to_mcap resources ~dialect from path
  | Mcap, Recording when not (Mcap_reader.is_ours from) -> of_others from path
  | Mcap, Recording -> of_mcap from path
  | Mcap, Mcap -> Error (Printf.sprintf "%s is already an MCAP file" (Basis.Printable.name from))

let run dialect from path =
  let* resources = Installation.find () in
  let* () = convert resources ~dialect from path in
  Exit_status.ok
