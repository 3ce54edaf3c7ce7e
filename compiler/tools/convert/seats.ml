type seat = { column : string; x : float; y : float; heading : float; half_angle : float }

(* Robots whose module defines [sonarPoses], each with a column that occurs only in its
   recordings. *)
let robots = [ ("Pioneer", "in.rearBumper"); ("Scout", "in.bumpers[5]") ]

let program module_ =
  Printf.sprintf "import Geometry\nimport %s\nmain = proc () -> (sonarPoses, sonarHalfAngle)\n"
    module_

(* The interpreter evaluates the library's definitions for one instant. *)
let asked (resources : Resources.t) module_ =
  let file = Filename.concat (Temporary.folder ()) "seats.frob" in
  let sink = Basis.Diagnostic.sink () and sources = Basis.Source.create () in
  let written = Buffer.create 4096 in
  let open Basis.Let_syntax.Result in
  let input = ref (List.of_seq (String.to_seq "time\n0\n")) in
  let read () =
    match !input with
    | [] -> None
    | c :: rest ->
        input := rest;
        Some c
  in
  let* () = Output.write [ (file, program module_) ] in
  match Queries.interpretable sink sources (Request.make ~library:resources.library file) with
  | None ->
      Basis.Diagnostic.bug ~stage:"Tools.Seats" "%s does not describe where its sonars are" module_
  | Some (core, entry, _) ->
      Interp.Trace.run core ~entry ~name:file ~read ~write:(Buffer.add_string written)
      |> Result.map_error (String.concat "\n")
      |> Result.map (fun () -> Buffer.contents written)

let table text =
  match String.split_on_char '\n' text with
  | names :: values :: _ ->
      List.combine (String.split_on_char ',' names) (String.split_on_char ',' values)
  | _ -> []

let rec seats columns table k =
  let value path = Option.map float_of_string (List.assoc_opt path table) in
  let of_pose part = value (Printf.sprintf "out.1[%d].%s" k part) in
  match (of_pose "position.x", of_pose "position.y", of_pose "heading", value "out.2") with
  | Some x, Some y, Some heading, Some half_angle ->
      let column = Printf.sprintf "in.sonar[%d]" k in
      let others = seats columns table (k + 1) in
      if List.mem column columns then { column; x; y; heading; half_angle } :: others else others
  | _ -> []

let of_columns resources columns =
  match List.find_opt (fun (_, column) -> List.mem column columns) robots with
  | None -> []
  | Some (module_, _) -> (
      match asked resources module_ with Ok text -> seats columns (table text) 0 | Error _ -> [])
