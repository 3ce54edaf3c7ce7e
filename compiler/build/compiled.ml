open Basis
open Reporting

let accepted ?(quiet = false) ?banner query (options : Common_options.t) ?batch
    (resources : Resources.t) ~entry file continue =
  let* robot = Robots.known options.robot in
  let* () = Program_file.check file in
  let sink = Diagnostic.sink () and sources = Source.create () in
  let request =
    Request.make ~options ?robot ?batch ?banner ~entry ~library:resources.library file
  in
  let result = query sink sources request in
  print_diagnostics options.format sources (if quiet then Diagnostic.errors sink else sink);
  match result with Some result -> continue request result | None -> status sink

(* The header can be generated from any signal function from the robot's input type to its output
   type, such as [atRest] in the robot's module. *)
let header_of (resources : Resources.t) (robot : Robots.t) =
  let sink = Diagnostic.sink () and sources = Source.create () and library = resources.library in
  let file = Option.value robot.file ~default:(Filename.concat library (robot.module_ ^ ".frob")) in
  let request = { (Request.make ~library file) with robot = Some robot; entry = "atRest" } in
  (Option.map (Cgen.Interface_header.text robot) (Queries.step sink sources request), sink, sources)

let robot_header resources (robot : Robots.t) =
  match header_of resources robot with
  | Some text, _, _ -> Ok (robot.header, text)
  | None, sink, sources ->
      Error
        (Printf.sprintf "%s cannot be compiled:\n%s"
           (Option.value robot.file ~default:robot.module_)
           (Render_text.diagnostics ~colour:(colour ()) sources (Diagnostic.all sink)))

let to_c ?quiet ?batch ?banner options resources ~entry file continue =
  let* () = C_file.check file in
  accepted ?quiet ?banner Queries.compile options ?batch resources ~entry file (fun request files ->
      match Request.own_robot request with
      | None -> continue files
      | Some robot ->
          let* header = robot_header resources robot in
          continue { files with robot_header = Some header })

let rec settings = function
  | [] -> Ok []
  | text :: others -> (
      match Resolve.Parameters.split text with
      | Some setting -> Result.map (fun others -> setting :: others) (settings others)
      | None ->
          Error (Printf.sprintf "--param takes NAME=VALUE, as in `kTurn=4[1/m]`, not `%s`" text))

let with_params (options : Common_options.t) (resources : Resources.t) ~entry file continue =
  if options.params = [] then continue []
  else
    let* given = settings options.params in
    let* () = Program_file.check file in
    let sink = Diagnostic.sink () and sources = Source.create () in
    (* Parameters are the same for all robots, so the robot does not matter here. *)
    let options = { options with dump = None; stop_after = None } in
    let request = Request.make ~options ~entry ~library:resources.library file in
    match Queries.params sink sources { request with settings = given } with
    | Some set -> continue set
    | None ->
        print_diagnostics options.format sources sink;
        Exit_status.wrong_use
