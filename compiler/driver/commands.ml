open Basis
open General

let check_one general ?robot ~library file =
  let* () = Program_file.check file in
  let sink = Diagnostic.sink () and sources = Source.create () in
  Pipeline.check sink sources (request general ?robot ~library file);
  print_diagnostics general.format sources sink;
  status sink

let check general files =
  let* resources = Resources.find () in
  let* robot = Robots.known general.robot in
  let statuses = List.map (check_one general ?robot ~library:resources.library) files in
  (* A rejected program outranks a missing file. *)
  if List.mem Exit_status.rejected statuses then Exit_status.rejected
  else List.fold_left max Exit_status.ok statuses

(* As other compilers' [-o] takes a file. *)
let not_a_file ~folder file =
  let name = C_file.name file in
  let is_c = List.exists (Filename.check_suffix folder) [ ".c"; ".h" ] in
  if (not is_c) || (Sys.file_exists folder && Sys.is_directory folder) then Ok ()
  else
    Error
      (Printf.sprintf "-o takes the folder for %s.c and %s.h; %s is the name of a file (-o %s)" name
         name folder (Filename.dirname folder))

let compile general entry ~batch ~standalone folder file =
  let* () = not_a_file ~folder file in
  let* resources = Resources.find () in
  Compiled.to_c ~batch general resources ~entry file (fun (files : Cgen.Emit.t) ->
      if general.dump <> None then Exit_status.ok
      else
        let path extension = Filename.concat folder (C_file.name file ^ extension) in
        let* files =
          if standalone then Standalone.files resources ~real:general.real files else Ok files
        in
        let robot_header =
          Option.map (fun (name, text) -> (Filename.concat folder name, text)) files.robot_header
        in
        let texts =
          [ (path ".h", files.header); (path ".c", files.source) ] @ Option.to_list robot_header
        in
        let output (path, _) = Output.asked C "compile" path in
        let* () = Output.check ~reads:[ file ] (List.map output texts) in
        let* () = Output.folder folder in
        let* () = Output.write texts in
        Exit_status.ok)

(* {1 Reporting} *)

let report general ~entry ~states file =
  let* resources = Resources.find () in
  if states then
    Compiled.accepted Pipeline.flow general resources ~entry file (fun _ program ->
        Format.printf "%a@?" Report.Diagram.print program;
        Exit_status.ok)
  else
    Compiled.accepted Pipeline.watched general resources ~entry file (fun _ (program, watched) ->
        (if general.dump = None then
           let bounds = Report.Bounds.of_program program in
           let judged program =
             Report.Judged.of_programs ~plain:bounds ~watched:(Report.Bounds.of_program program)
           in
           let judged = Option.map judged watched in
           match general.format with
           | Text -> print_string (Report.Text.to_string ?judged bounds)
           | Json -> print_endline (Report.For_tools.to_string ?judged bounds));
        Exit_status.ok)

let header robot =
  let* resources = Resources.find () in
  let* robot = Robots.known (Some robot) in
  let text, sink, sources = Compiled.header_of resources (Option.get robot) in
  match text with
  | Some text ->
      print_string text;
      Exit_status.ok
  | None when Diagnostic.has_errors sink ->
      prerr_string (Render_text.diagnostics ~colour:(colour ()) sources (Diagnostic.all sink));
      status sink
  | None -> Diagnostic.bug ~stage:"Driver" "no header for this robot"

let explain code =
  let is_number = code <> "" && String.for_all (fun c -> c >= '0' && c <= '9') code in
  let code = if is_number then Printf.sprintf "E%04d" (int_of_string code) else code in
  match Explain.find (String.uppercase_ascii code) with
  | Some page ->
      print_string page;
      Exit_status.ok
  | None ->
      let hint =
        match Suggest.closest (String.uppercase_ascii code) Explain.codes with
        | Some near -> Printf.sprintf "; did you mean `%s`?" near
        | None -> ""
      in
      wrong_use (Printf.sprintf "there is no diagnostic `%s`%s" code hint)
