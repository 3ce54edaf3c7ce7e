open Basis

type tools = { library : string; headers : string; trace_host : string; folder : string }

type outcome =
  | Agree
  | Rejected of string
  | Failed of string
  | Differ of { row : int; column : string; c : string; interpreted : string }

let describe outcome =
  match outcome with
  | Agree -> "agrees"
  | Rejected text -> "is rejected:\n" ^ text
  | Failed text -> "fails:\n" ^ text
  | Differ { row; column; c; interpreted } ->
      Printf.sprintf "differs in row %d of `%s`: C gives %s, the interpreter %s" row column c
        interpreted

let options =
  { Driver.Pipeline.dump = None; stop_after = None; lint = true; specialization_limit = 10_000 }

let read path =
  let channel = open_in_bin path in
  Fun.protect
    ~finally:(fun () -> close_in channel)
    (fun () -> really_input_string channel (in_channel_length channel))

let write path text =
  let channel = open_out_bin path in
  Fun.protect ~finally:(fun () -> close_out channel) (fun () -> output_string channel text)

(* A stage of the compiler on the file, or its diagnostics. *)
let through pipeline tools ~entry file =
  let sink = Diagnostic.sink () and sources = Source.create () in
  match pipeline options sink sources ~library:tools.library ~entry file with
  | Some result -> Ok result
  | None ->
      Error (Rejected (Render_text.diagnostics ~colour:false sources (Diagnostic.all sink)))

let characters text =
  let next = ref 0 in
  fun () ->
    if !next = String.length text then None
    else begin
      incr next;
      Some text.[!next - 1]
    end

let interpreted core ~entry input =
  let out = Buffer.create 65536 in
  match
    Interp.Trace.run core ~entry ~name:"input" ~read:(characters input)
      ~write:(Buffer.add_string out)
  with
  | Ok () -> Ok (Buffer.contents out)
  | Error texts -> Error (Failed (String.concat "\n" texts))

let ( let* ) = Result.bind
let ( / ) = Filename.concat

(* Of a program that is not run again: it is not kept. *)
let with_compiled tools ~name (files : Cgen.Emit.t) use =
  let* program =
    Driver.Toolchain.shared_object ~headers:tools.headers ~name
      [
        (name ^ ".h", files.header);
        (name ^ ".c", files.source);
        (name ^ "_host.c", files.host_table);
      ]
    |> Result.map_error (fun text -> Failed text)
  in
  Fun.protect ~finally:(fun () -> Sys.remove program) (fun () -> use program)

let compiled tools program input =
  write (tools.folder / "in.csv") input;
  let output = tools.folder / "out.csv" in
  match Driver.Process.run tools.trace_host [ program; tools.folder / "in.csv"; output ] with
  | Ok () -> Ok (read output)
  | Error (Not_found program) -> Error (Failed ("there is no " ^ program))
  | Error (Failed { errors; _ }) -> Error (Failed errors)

let cells text =
  let csv = Interp.Csv.reader (characters text) in
  let rec rows found =
    match Interp.Csv.next csv with
    | Ok (Some row) -> rows (List.map (fun (c : Interp.Csv.cell) -> c.text) row.cells :: found)
    | Ok None | Error _ -> List.rev found
  in
  rows []

let first_difference c interpreted =
  let rec in_row row columns c interpreted =
    match (columns, c, interpreted) with
    | column :: columns, c :: cs, i :: is ->
        if String.equal c i then in_row row columns cs is
        else Some (Differ { row; column; c; interpreted = i })
    | _, _, _ -> None
  in
  let rec in_rows row columns c interpreted =
    match (c, interpreted) with
    | c :: cs, i :: is -> (
        match in_row row columns c i with
        | Some difference -> difference
        | None -> in_rows (row + 1) columns cs is)
    | _, _ -> Failed "the traces differ, but no cell does"
  in
  match (cells c, cells interpreted) with
  | columns :: c, _ :: interpreted -> in_rows 0 columns c interpreted
  | _, _ -> Failed "a trace is empty"

(* In a bug of the compiler the programs to look at are those that show it. *)
let internal_error : exn -> string option = function
  | Diagnostic.Bug { stage; message } -> Some (Printf.sprintf "internal error in %s: %s" stage message)
  | Invalid_argument reason | Failure reason -> Some ("internal error: " ^ reason)
  | Not_found -> Some "internal error: something is not found"
  | Stack_overflow -> Some "internal error: the stack overflowed"
  | _ -> None

let compare tools random ~rows ~entry file =
  let outcome () =
    let* core, global = through Driver.Pipeline.interpretable tools ~entry file in
    let* files = through Driver.Pipeline.compile tools ~entry file in
    let shape = Interp.Shape.of_type core (fst (Interp.Execution.interface core global)) in
    with_compiled tools ~name:(Driver.Pipeline.c_name file) files (fun program ->
        let on kind =
          let input = Input.make random kind shape ~rows in
          let* c = compiled tools program input in
          let* interpreted = interpreted core ~entry:global input in
          if String.equal c interpreted then Ok () else Error (first_difference c interpreted)
        in
        let* () = on Tame in
        on Wild)
  in
  match outcome () with
  | Ok () -> Agree
  | Error outcome -> outcome
  | exception exn when internal_error exn <> None -> Failed (Option.get (internal_error exn))
