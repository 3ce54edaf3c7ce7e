let generated ~name (files : Cgen.Emit.t) =
  (name ^ ".h") :: List.map fst (Option.to_list files.robot_header)

(* Checks that a C file finds the same headers as the program. The generated header includes the
   headers that the program names, and when a C file includes the generated header, the C compiler
   searches that C file's folder first. *)
let check_same ~generated ~folders (headers : Flow.Ir.header list) file =
  let found folders (h : Flow.Ir.header) =
    List.find_opt Sys.file_exists (List.map (fun folder -> Filename.concat folder h.header) folders)
  in
  let other h =
    match (found [ Filename.dirname file ] h, found folders h) with
    | Some own, Some chosen when Included.identity own <> Included.identity chosen ->
        Some (own, chosen)
    | _ -> None
  in
  match List.find_map other headers with
  | Some (own, chosen) when Own_headers.includes generated ~folders file ->
      let shown = Basis.Printable.name in
      Error
        (Printf.sprintf
           "%s includes the program's generated header, which includes %s, but the folder of %s \
            contains another file with that name, %s: rename one of them"
           (shown file) (shown chosen) (shown file) (shown own))
  | Some _ | None -> Ok ()

let checked ~name ~sources (files : Cgen.Emit.t) =
  let open Basis.Let_syntax.Result in
  let { Cgen.Emit.calls; headers } = files.foreign in
  let generated = generated ~name files in
  let with_calls refusal =
    let reached = Own_headers.reached ~generated ~folders:[] sources in
    match Foreign_symbols.unknown ~calls reached with
    | [] -> refusal
    | first :: others ->
        let name = Printf.sprintf "`%s`" in
        let shown = List.filteri (fun k _ -> k < 2) others in
        Printf.sprintf "%s; the program also calls %s, whose C files are missing too" refusal
          (Basis.Enumeration.some
             (List.map name (first :: shown))
             ~more:(List.length others - List.length shown))
  in
  let* { Foreign_headers.folders; headers } =
    Result.map_error with_calls (Foreign_headers.allowed ~generated ~sources headers)
  in
  let* () =
    List.fold_left
      (fun result file ->
        Result.bind result (fun () -> check_same ~generated ~folders files.foreign.headers file))
      (Ok ()) sources
  in
  let* () =
    Foreign_symbols.check ~calls (Own_headers.reached ~generated ~folders (sources @ headers))
  in
  let to_compile = List.filter (fun file -> not (Own_headers.is_header file)) sources in
  if calls = [] && files.foreign.headers = [] && sources = [] then Ok None
  else Ok (Some { Toolchain.sources = to_compile; folders; allowed = sources @ headers })

let refused_headers ~name (files : Cgen.Emit.t) =
  Foreign_headers.refused ~generated:(generated ~name files) ~sources:[] files.foreign.headers
