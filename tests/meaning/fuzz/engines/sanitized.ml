type compiler = Gcc | Clang

let name = function Gcc -> "gcc" | Clang -> "clang"
let ( / ) = Filename.concat
let ( let* ) = Result.bind

let flags =
  [
    "-std=c99";
    "-O3";
    "-ffp-contract=off";
    "-fsanitize=address,undefined,float-cast-overflow";
    "-fno-sanitize-recover=all";
  ]

(* Generated C promises to compile without these warnings. *)
let warnings = [ "-Wall"; "-Wextra"; "-Wpedantic"; "-Wconversion"; "-Wshadow"; "-Werror" ]

let host_sources runtime =
  List.map
    (fun file -> runtime / file)
    [
      "hosts/trace/main.c";
      "hosts/common/streams.c";
      "hosts/common/csv.c";
      "hosts/common/dialect.c";
      "hosts/common/load.c";
      "hosts/common/params.c";
      "hosts/common/claims.c";
      "hosts/common/frames.c";
      "hosts/common/packed.c";
      "hosts/common/seconds.c";
      "core/text.c";
      "core/cell_read.c";
      "core/cell_write.c";
      "core/frame.c";
      "core/trace.c";
      "core/console.c";
    ]

let sees (_, text) =
  match Str.search_forward (Str.regexp_string "struct frob_image") text 0 with
  | _ -> true
  | exception Not_found -> false

let sources_in folder =
  List.filter_map
    (fun file -> if Filename.check_suffix file ".c" then Some (folder / file) else None)
    (Array.to_list (Sys.readdir folder))

let executed program arguments =
  match Build.Process.run program arguments with
  | Ok () -> Ok ()
  | Error (Not_found program) -> Error ("there is no " ^ program)
  | Error (Failed { status; errors }) ->
      Error (Printf.sprintf "%s ends with status %d:\n%s" program status errors)

let host compiler ~runtime ~folder =
  let built = folder / ("trace-" ^ name compiler) in
  if Sys.file_exists built then Ok built
  else
    let* () =
      executed (name compiler)
        (flags
        @ [ "-D_POSIX_C_SOURCE=200809L"; "-I"; runtime / "include"; "-o"; built ]
        @ host_sources runtime @ [ "-ldl"; "-lm" ])
    in
    Ok built

let write path text =
  let channel = open_out_bin path in
  Fun.protect ~finally:(fun () -> close_out channel) (fun () -> output_string channel text)

let read path =
  let channel = open_in_bin path in
  Fun.protect
    ~finally:(fun () -> close_in channel)
    (fun () -> really_input_string channel (in_channel_length channel))

let run compiler ~runtime ~folder files recordings =
  let* host = host compiler ~runtime ~folder in
  List.iter (fun (file, text) -> write (folder / file) text) files;
  let sources = List.filter (fun (file, _) -> Filename.check_suffix file ".c") files in
  let generated = List.map (fun (file, _) -> folder / file) sources in
  (* The C must also compile as C++, and in single precision it must not contain doubles. *)
  let* () =
    executed
      (match compiler with Gcc -> "g++" | Clang -> "clang++")
      ([ "-x"; "c++"; "-std=c++17"; "-fsyntax-only"; "-I"; runtime / "include" ]
      @ ("-Wdouble-promotion" :: warnings)
      @ generated)
  in
  let program = folder / "sanitized.so" in
  let* () =
    executed (name compiler)
      (flags @ warnings
      @ [ "-fPIC"; "-shared"; "-I"; runtime / "include"; "-o"; program ]
      @ generated
      @ sources_in (runtime / "elementary")
      @ (if List.exists sees files then sources_in (runtime / "vision") else [])
      @ [ "-lm" ])
  in
  let trace recording =
    let input = folder / "in.csv" and output = folder / "out.csv" in
    write input (Recording.csv recording);
    let* () = executed host [ program; input; output ] in
    Ok (read output)
  in
  let add recording found =
    let* found = found in
    let* trace = trace recording in
    Ok (trace :: found)
  in
  List.fold_right add recordings (Ok [])
