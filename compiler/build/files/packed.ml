type format = {
  tool : string;
  ending : string;
  magic : string;  (** first bytes of the file *)
  packing : string;  (** options of the tool; without [-n], gzip would store the time *)
}

let formats =
  [
    { tool = "gzip"; ending = ".gz"; magic = "\x1f\x8b"; packing = "-cqn" };
    { tool = "zstd"; ending = ".zst"; magic = "\x28\xb5\x2f\xfd"; packing = "-cq" };
  ]

let is_named name format =
  Filename.check_suffix name format.ending && String.length name > String.length format.ending

let format_of name = List.find_opt (is_named name) formats

let stem name =
  match format_of name with Some format -> Filename.chop_suffix name format.ending | None -> name

let not_installed format =
  Printf.sprintf "this needs the program %s, which is not installed%s" format.tool
    (if format.tool = "gzip" then "" else Printf.sprintf " (`apt install %s`)" format.tool)

let start (life : Child.life) format option ~stdin ~stdout ~stderr =
  match Child.start life format.tool [ option ] ~stdin ~stdout ~stderr with
  | process -> Ok process
  | exception Unix.Unix_error (ENOENT, _, _) -> Error (not_installed format)
  | exception Unix.Unix_error (reason, _, _) -> Error (Unix.error_message reason)

let rec status_of process =
  match Unix.waitpid [] process with
  | _, status -> status
  | exception Unix.Unix_error (EINTR, _, _) -> status_of process

(* {1 Reading} *)

(* Checks that the first bytes of the file match its extension. *)
let named_rightly path channel =
  let magic = List.map (fun f -> (f, f.magic)) formats in
  let begins : type a. a * string -> bool =
   fun (_, magic) ->
    let n = String.length magic in
    seek_in channel 0;
    in_channel_length channel >= n && String.equal (really_input_string channel n) magic
  in
  match (format_of path, List.find_opt begins magic) with
  | _, None when begins ((), "\x89MCAP") ->
      Error "it is an MCAP file; convert it to a recording with `frobc convert`"
  | None, None -> Ok ()
  | Some format, Some (found, _) when found.tool = format.tool -> Ok ()
  | Some format, _ when in_channel_length channel > 0 ->
      Error (Printf.sprintf "its name says that it is compressed by %s, but it is not" format.tool)
  | Some _, _ -> Ok ()
  | None, Some _ -> Error "it is compressed; rename it so that its name ends in .gz or .zst"

let cannot_read path reason =
  Error [ Printf.sprintf "cannot read %s: %s" (Basis.Printable.name path) reason ]

(* Reads at most 64 MiB, because a small archive may expand to a huge amount of data. *)
let reach_end channel =
  let some = Bytes.create 65536 in
  let rec from read =
    match input channel some 0 (Bytes.length some) with
    | 0 -> true
    | n -> read + n < 64 * 1024 * 1024 && from (read + n)
  in
  from 0

let unpacked ?damaged path format file run =
  let read, write = Unix.pipe ~cloexec:true () in
  let null = Unix.openfile "/dev/null" [ Unix.O_WRONLY; Unix.O_CLOEXEC ] 0 in
  let started = start Ends_with_us format "-dcq" ~stdin:file ~stdout:write ~stderr:null in
  Unix.close write;
  Unix.close null;
  let channel = Unix.in_channel_of_descr read in
  match started with
  | Error reason ->
      close_in channel;
      cannot_read path reason
  | Ok process -> (
      let ended = ref false and status = ref (Unix.WEXITED 0) in
      let finally () =
        ended := !ended || input channel (Bytes.create 1) 0 1 = 0;
        close_in channel;
        status := status_of process
      in
      (* A damaged archive may be the cause of the reader's error. *)
      let read () =
        let result = run channel in
        if Result.is_error result then ended := reach_end channel;
        result
      in
      let result = Fun.protect ~finally read in
      match !status with
      | status when !ended && status <> WEXITED 0 -> (
          let reason = "the archive is truncated or damaged" in
          match damaged with
          | None -> cannot_read path (reason ^ " (`frobc convert` recovers its complete rows)")
          | Some tell ->
              tell reason;
              result)
      | _ -> result)

let with_input ?damaged path run =
  match open_in_bin path with
  | exception Sys_error reason -> Error [ "cannot read " ^ Basis.Printable.name reason ]
  | channel ->
      let finally () = close_in_noerr channel in
      Fun.protect ~finally (fun () ->
          let is_file = (Unix.fstat (Unix.descr_of_in_channel channel)).st_kind = Unix.S_REG in
          match if is_file then named_rightly path channel else Ok () with
          | Error reason -> cannot_read path reason
          | Ok () -> (
              if is_file then seek_in channel 0;
              match format_of path with
              | None -> run channel
              | Some format ->
                  let file = Unix.descr_of_in_channel channel in
                  if is_file then ignore (Unix.lseek file 0 SEEK_SET);
                  unpacked ?damaged path format file run))

let too_large most = Printf.sprintf "it is larger than %d MB" (most / 1024 / 1024)

let read ~most path =
  let all channel =
    let text = Buffer.create 65536 and block = Bytes.create 65536 in
    let rec more () =
      match input channel block 0 (Bytes.length block) with
      | 0 -> Ok (Buffer.contents text)
      | n when Buffer.length text + n > most ->
          Error [ Printf.sprintf "cannot read %s: %s" (Basis.Printable.name path) (too_large most) ]
      | n ->
          Buffer.add_subbytes text block 0 n;
          more ()
    in
    more ()
  in
  Result.map_error (String.concat "\n") (with_input path all)

(* {1 Writing} *)

type writer = { channel : out_channel; close : unit -> unit }

let packing format file =
  let read, write = Unix.pipe ~cloexec:true () in
  let started = start Outlives format format.packing ~stdin:read ~stdout:file ~stderr:Unix.stderr in
  Unix.close read;
  let channel = Unix.out_channel_of_descr write in
  set_binary_mode_out channel true;
  (* Truncates an existing file only at this point, when everything else has succeeded. *)
  if Result.is_ok started && (Unix.fstat file).st_kind = Unix.S_REG then Unix.ftruncate file 0;
  (* If the tool exits early, writing must return an error instead of raising SIGPIPE. *)
  let before = Sys.signal Sys.sigpipe Sys.Signal_ignore in
  match started with
  | Error reason ->
      close_out_noerr channel;
      Error reason
  | Ok process ->
      let close () =
        let closed = try Ok (close_out channel) with Sys_error reason -> Error reason in
        let status = status_of process in
        Sys.set_signal Sys.sigpipe before;
        match (status, closed) with
        | WEXITED 0, Ok () -> ()
        | WEXITED 0, Error reason -> raise (Sys_error reason)
        | _ -> raise (Sys_error (format.tool ^ " ended early"))
      in
      Ok { channel; close }

let writer ?named path =
  match format_of (Option.value named ~default:path) with
  | None ->
      let channel = open_out_bin path in
      { channel; close = (fun () -> close_out channel) }
  | Some format -> (
      let opened =
        match Unix.openfile path [ O_WRONLY; O_CREAT; O_CLOEXEC ] 0o666 with
        | file -> Fun.protect ~finally:(fun () -> Unix.close file) (fun () -> packing format file)
        | exception Unix.Unix_error (reason, _, _) -> Error (Unix.error_message reason)
      in
      match opened with
      | Ok writer -> writer
      | Error reason -> raise (Sys_error (path ^ ": " ^ reason)))

let packed ~named text =
  match format_of named with
  | None -> Ok text
  | Some _ -> (
      let path = Filename.concat (Temporary.folder ()) "packed" in
      match
        let writer = writer ~named path in
        Fun.protect ~finally:writer.close (fun () -> output_string writer.channel text)
      with
      | () ->
          let channel = open_in_bin path in
          Fun.protect
            ~finally:(fun () -> close_in channel)
            (fun () -> Ok (really_input_string channel (in_channel_length channel)))
      | exception (Sys_error reason | Fun.Finally_raised (Sys_error reason)) ->
          Error (Printf.sprintf "cannot write %s: %s" (Basis.Printable.name named) reason))
