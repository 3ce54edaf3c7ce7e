open Basis
open General

(* Goes on with what a pipeline gives, or gives the status with which to end. *)
let accepted ?(quiet = false) pipeline general ?batch (resources : Resources.t) ~entry file continue
    =
  let* robot = Robots.known general.robot in
  let* () = Program_file.check file in
  let sink = Diagnostic.sink () and sources = Source.create () in
  let request = request general ?robot ?batch ~entry ~library:resources.library file in
  let result = pipeline sink sources request in
  if Option.is_none result || not quiet then print_diagnostics general.format sources sink;
  match result with Some result -> continue request result | None -> status sink

(* Of the robot's types: those of any signal function from one to the other, such as
   [atRest] in its module. *)
let header_of (resources : Resources.t) (robot : Robots.t) =
  let sink = Diagnostic.sink () and sources = Source.create () and library = resources.library in
  let file = Option.value robot.file ~default:(Filename.concat library (robot.module_ ^ ".frob")) in
  let request = { (Request.make ~library file) with robot = Some robot; entry = "atRest" } in
  (Option.map (Cgen.Interface_header.text robot) (Pipeline.step sink sources request), sink, sources)

let robot_header resources (robot : Robots.t) =
  match header_of resources robot with
  | Some text, _, _ -> Ok (robot.header, text)
  | None, sink, sources ->
      Error
        (Printf.sprintf "%s cannot be compiled:\n%s"
           (Option.value robot.file ~default:robot.module_)
           (Render_text.diagnostics ~colour:(colour ()) sources (Diagnostic.all sink)))

let to_c ?quiet ?batch general resources ~entry file continue =
  let* () = C_file.check file in
  accepted ?quiet Pipeline.compile general ?batch resources ~entry file (fun request files ->
      match Request.own_robot request with
      | None -> continue files
      | Some robot ->
          let* header = robot_header resources robot in
          continue { files with robot_header = Some header })
