let with_input path run =
  if String.equal path "-" then run ~name:"standard input" stdin
  else Packed.with_input path (run ~name:path)

(* The file is opened when the first output is written, so that an input with an invalid header does
   not destroy the output of an earlier run. After a write error, the channel is closed, so that
   nothing more is written to it when the process ends. *)
let with_output path run =
  let name = Option.value path ~default:"standard output" in
  let writer =
    lazy
      (match path with
      | None -> Ok { Packed.channel = stdout; close = (fun () -> flush stdout) }
      | Some path -> (
          match Packed.writer path with
          | writer -> Ok writer
          (* The reason already contains the file name. *)
          | exception Sys_error reason -> Error [ "cannot write " ^ Basis.Printable.name reason ]))
  in
  let exception Unwritable of string list in
  let using act =
    match Lazy.force writer with
    | Error errors -> raise_notrace (Unwritable errors)
    | Ok writer -> (
        try act writer
        with Sys_error reason ->
          close_out_noerr writer.channel;
          raise_notrace
            (Unwritable [ Printf.sprintf "cannot write %s: %s" (Basis.Printable.name name) reason ])
        )
  in
  match
    let result = run (fun text -> using (fun writer -> output_string writer.channel text)) in
    if Lazy.is_val writer then using (fun writer -> writer.close ());
    result
  with
  | result -> result
  | exception Unwritable errors -> Error errors

let trace ~params ~dialect core ~entry ~marks ~input ~output =
  let warn text = Printf.eprintf "warning: %s\n" (Basis.Printable.text text) in
  with_input input (fun ~name channel ->
      let read () = match input_char channel with c -> Some c | exception End_of_file -> None in
      with_output output (fun write ->
          try Interp.Trace.run ~marks ~params ~warn ~dialect core ~entry ~name ~read ~write
          with Stack_overflow ->
            Error [ "this program is nested too deeply for the interpreter; use `--engine c`" ]))

let no_interpreter = "E0505"

let refusal ~at (flow : Flow.Ir.program) =
  let refuse at what =
    Basis.Diagnostic.error ~code:no_interpreter ~at "the interpreter cannot run this program: %s"
      what
    |> Basis.Diagnostic.hint "run it with `--engine c`"
    |> Option.some
  in
  let calls (node : Flow.Ir.node) =
    match node.foreign with
    | Some { import; _ } -> not (Kernels.is_known import.symbol)
    | None -> false
  in
  match List.find_opt calls (Array.to_list flow.nodes) with
  | Some node -> refuse node.span (Printf.sprintf "`%s` is written in C" node.origin)
  | None when not (List.for_all (Flow.Shape.for_hosts flow.sums) [ flow.input; flow.output ]) ->
      refuse at "its input or output has a foreign type"
  | None -> None
