open Basis
open Common_options
open Reporting

(* Prints only the messages that are not yet in [told], and adds them to it. *)
let check_one general ?robot ~library ~told file =
  let* () = Program_file.check file in
  let sink = Diagnostic.sink () and sources = Source.create () in
  Queries.check sink sources (Request.make ~options:general ?robot ~library file);
  let is_new d = not (List.exists (Diagnostic.is_same d) !told) in
  let fresh = Diagnostic.sink () in
  List.iter (Diagnostic.emit fresh) (List.filter is_new (Diagnostic.all sink));
  told := Diagnostic.all sink @ !told;
  print_diagnostics general.format sources fresh;
  status sink

(* Checks a program together with its test file. If they were checked separately, the messages about
   the program would be printed twice. *)
let check_all general ?robot ~library files =
  let of_program program file = Resolve.Test_file.program_or_self file = program in
  let rec next = function
    | [] -> []
    | program :: others ->
        let program_file = Resolve.Test_file.program_or_self program in
        let tests, others =
          match others with
          | file :: rest when of_program program_file file -> ([ file ], rest)
          | _ -> ([], others)
        in
        let told = ref [] in
        let check = check_one general ?robot ~library ~told in
        let first = check program in
        (first :: (if first = Exit_status.ok then List.map check tests else [])) @ next others
  in
  next (Program_file.with_tests files)

let check general files =
  let* resources = Installation.find () in
  let* robot = Robots.known general.robot in
  let statuses = check_all general ?robot ~library:resources.library files in
  (* The exit status for errors in a program takes precedence over the one for a missing file. *)
  if List.mem Exit_status.rejected statuses then Exit_status.rejected
  else List.fold_left max Exit_status.ok statuses

(* Reports an error if [-o] names a file, as it does for other compilers, and not a folder. *)
let not_a_file ~folder file =
  let name = C_file.name file in
  let is_c = List.exists (Filename.check_suffix folder) [ ".c"; ".h" ] in
  if (not is_c) || (Sys.file_exists folder && Sys.is_directory folder) then Ok ()
  else
    Error
      (Printf.sprintf
         "-o takes the folder for %s.c and %s.h, but %s is the name of a file: write -o %s" name
         name folder (Filename.dirname folder))

let compile general entry ~batch ~standalone folder file =
  let* () = not_a_file ~folder file in
  let* resources = Installation.find () in
  Compiled.to_c ~batch ~banner:true general resources ~entry file (fun (files : Cgen.Emit.t) ->
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

let wire_of (program : Step.Ir.program) : Report.Wire.t option =
  match Cgen.Robot.of_shape program.output with
  | None | Some { steps = []; _ } -> None
  | Some robot ->
      let step (s : Cgen.Robot.step) : Report.Wire.step =
        { quantity = s.quantity; size = s.size; unit_ = s.unit_ }
      in
      Some { robot = robot.name; steps = List.map step robot.steps }

type diagram = Dot | Svg

let report general ~entry ~states file =
  let* resources = Installation.find () in
  let draw print =
    Compiled.accepted Queries.flow general resources ~entry file (fun _ program ->
        Format.printf "%t@?" (fun ppf ->
            print ppf ~name:program.Flow.Ir.name (Report.Machines.of_program program));
        Exit_status.ok)
  in
  match states with
  | Some Dot -> draw Report.Diagram.print
  | Some Svg -> draw Report.Drawing.print
  | None ->
      Compiled.accepted Queries.watched general resources ~entry file (fun _ (program, watched) ->
          (if general.dump = None then
             let bounds = Report.Bounds.of_program program in
             let judged program =
               Report.Judged.of_programs ~plain:bounds ~watched:(Report.Bounds.of_program program)
             in
             let judged = Option.map judged watched in
             let wire = wire_of program in
             match general.format with
             | Text -> print_string (Printable.text (Report.Text.to_string ?judged ?wire bounds))
             | Json -> print_endline (Report.For_tools.to_string ?judged ?wire bounds));
          Exit_status.ok)

let header robot =
  let* resources = Installation.find () in
  let* robot = Robots.known (Some robot) in
  let text, sink, sources = Compiled.header_of resources (Option.get robot) in
  match text with
  | Some text ->
      print_string text;
      Exit_status.ok
  | None when Diagnostic.has_errors sink ->
      prerr_string (Render_text.diagnostics ~colour:(colour ()) sources (Diagnostic.all sink));
      status sink
  | None -> Diagnostic.bug ~stage:"Build" "no header for this robot"

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
