open Basis
module Robot = Cgen.Robot
module Fit = Typing.Fit

type t = Robot.t

let unfit = "E0503"
let names = List.map (fun (robot : t) -> robot.name) Robot.all
let is_file name = Filename.check_suffix name ".frob"

let own file =
  let robot = Robot.own file in
  if not (Sys.file_exists file) then
    Error (Printf.sprintf "there is no file %s" (Basis.Printable.name file))
  else if Robot.of_name robot.name <> None then
    Error (Printf.sprintf "there is already a robot `%s`: rename %s" robot.name file)
  else Ok (Some robot)

let known = function
  | None -> Ok None
  | Some file when is_file file -> own file
  | Some name -> (
      match Robot.of_name name with
      | Some robot -> Ok (Some robot)
      | None ->
          Error
            (Printf.sprintf
               "there is no robot `%s`; the robots are %s; for your own robot, give the file of \
                its module"
               name (String.concat ", " names)))

let own_of asked =
  match known asked with Ok (Some robot) when Robot.is_own robot -> Some robot | _ -> None

type program = {
  typed : Typing.Ir.program;
  core : Core.Ir.program;
  entry : Core.Ir.Global.t;
  signed : bool;
  own : t option;
}

let all p = Option.to_list p.own @ Robot.all
let input (robot : t) : Core.Ir.Global.t = { module_ = robot.module_; name = Robot.input robot }
let output (robot : t) : Core.Ir.Global.t = { module_ = robot.module_; name = Robot.output robot }

(* Checks that a user-defined robot defines everything that programs, hosts and this module
   need. *)
let check_own sink (typed : Typing.Ir.program) (robot : t) =
  let record (tycon : Core.Ir.Global.t) =
    let is_record (d : Typing.Ir.data) =
      d.tycon = tycon && match d.constructors with [ c ] -> c.record | _ -> false
    in
    List.exists is_record typed.data
  in
  let is_output (i : Typing.Ir.instance) =
    String.equal i.class_.name "RobotOutput"
    && match i.head with Data { tycon; _ } -> tycon = output robot | _ -> false
  in
  let file = Option.value robot.file ~default:robot.module_ in
  let lacks format =
    Printf.ksprintf
      (fun what ->
        Diagnostic.error ~code:unfit ~at:(Span.start_of_file file)
          "the module `%s` does not describe a robot: there is no %s" robot.module_ what
        |> Diagnostic.hint
             "define records `%s` and `%s`, and an instance for each capability of the robot"
             (Robot.input robot) (Robot.output robot)
        |> Diagnostic.emit sink)
      format
  in
  if not (record (input robot)) then lacks "record `%s`" (Robot.input robot)
  else if not (record (output robot)) then lacks "record `%s`" (Robot.output robot)
  else if not (List.exists is_output typed.instances) then
    lacks "instance `RobotOutput %s`" (Robot.output robot)

let typed_entry p =
  List.find (fun (d : Typing.Ir.definition) -> d.name = p.entry) p.typed.definitions

let lacks p robot =
  Fit.lacks p.typed (typed_entry p)
    ~others:(List.concat_map (fun robot -> [ input robot; output robot ]) (all p))
    { input = input robot; output = output robot }

let fits p robot = lacks p robot = Some []
let fitting p = List.filter (fits p) (all p)

let close p robot =
  let core_entry =
    List.find (fun (d : Core.Ir.definition) -> d.name = p.entry) p.core.definitions
  in
  let data tycon : Core.Ir.ty = Data (tycon, []) in
  Core.Closing.program p.core core_entry ~suffix:("@" ^ robot.Robot.name)
    ~input:(data (input robot))
    ~output:(data (output robot))

(* {1 Texts} *)

let quoted (robot : t) = Printf.sprintf "`%s`" robot.name
let option (robot : t) = Printf.sprintf "`--robot %s`" (Basis.Printable.word robot.name)
let entry_span p = (typed_entry p).span

let not_said p robots =
  Diagnostic.error ~code:"E0502" ~at:(entry_span p)
    "the type of `%s` does not say which robot it runs on" p.entry.name
  |> Diagnostic.hint "%s %s everything that the program needs: compile it with %s"
       (Enumeration.all (List.map quoted robots))
       (match robots with [ _ ] -> "has" | _ -> "have")
       (Enumeration.one_of (List.map option robots))

(* Lists the robots that the program's type allows and that have this capability. *)
let having p class_ diagnostic =
  let has robot =
    match lacks p robot with
    | None -> false
    | Some found -> not (List.exists (fun (l : Fit.lack) -> l.class_ = class_) found)
  in
  let robots = List.filter has (all p) in
  let with_fix d =
    if robots = [] then d
    else Diagnostic.hint "compile it with %s" (Enumeration.one_of (List.map option robots)) d
  in
  Diagnostic.note "%s"
    (match robots with
    | [] -> "no robot in the library has this capability"
    | [ robot ] -> Printf.sprintf "only %s has this capability" (quoted robot)
    | robots -> Printf.sprintf "%s have this capability" (Enumeration.all (List.map quoted robots)))
    diagnostic
  |> with_fix

(* Is the robot's module, which contains its instances, part of the program? *)
let is_loaded p robot = List.exists (fun (d : Typing.Ir.data) -> d.tycon = input robot) p.typed.data

let lacking p (robot : t) (lack : Fit.lack) =
  let error format = Diagnostic.error ~code:unfit ~at:lack.need.place format in
  if is_loaded p robot then
    error "%s has no `%s`" (quoted robot) lack.class_.name
    |> Diagnostic.here "%s needs it" lack.need.by
    |> having p lack.class_
    |> Diagnostic.note "`%s` is compiled for %s, but there is no instance `%s %s`" p.entry.name
         (quoted robot) lack.class_.name lack.of_.name
  else
    error "%s has no `%s` here, because the program does not import its module" (quoted robot)
      lack.class_.name
    |> Diagnostic.here "%s needs it" lack.need.by
    |> Diagnostic.hint "add `import Robot`, which contains the capabilities of all robots"

(* For each candidate, reports the first capability that it lacks. *)
let on_no_robot p candidates =
  let error =
    Diagnostic.error ~code:unfit ~at:(entry_span p) "no robot has everything that `%s` needs"
      p.entry.name
  in
  let add error (robot : t) =
    let first (lack : Fit.lack) =
      Printf.sprintf "%s has no `%s`, which %s needs" (quoted robot) lack.class_.name lack.need.by
    in
    match lacks p robot with
    | Some (lack :: _) -> Diagnostic.label ~at:lack.need.place "%s" (first lack) error
    | Some [] | None -> error
  in
  List.fold_left add error candidates
  |> Diagnostic.note "for your own robot, give the file of its module: `--robot FILE.frob`"

let another p (robot : t) others =
  Diagnostic.error ~code:unfit ~at:(entry_span p) "`%s` is a program for %s, not for %s"
    p.entry.name
    (Enumeration.all (List.map quoted others))
    (quoted robot)
  |> Diagnostic.hint "allow any robot, as in `main :: (HasSonar i, DiffDrive o) => Program i o`"

let mixed p (input : t) (output : t) =
  Diagnostic.error ~code:unfit ~at:(entry_span p) "`%s` has the input of %s but the output of %s"
    p.entry.name (quoted input) (quoted output)

(* {1 Choosing a robot} *)

(* The robots to which the input type and the output type of a closed program belong. *)
let robots_of (p : program) =
  let named found (t : Typing.Ir.ty) =
    match t with
    | Data { tycon; _ } ->
        Option.to_list (List.find_opt (fun r -> input r = tycon || output r = tycon) (all p))
        @ found
    | _ -> found
  in
  match (typed_entry p).scheme.ty with
  | Data { tycon = { name = "Program"; _ }; arguments = [ input; output ]; _ } ->
      (named [] input, named [] output)
  | _ -> ([], [])

let as_it_stands p = Some (p.core, p.entry)

let refuse sink diagnostics =
  List.iter (Diagnostic.emit sink) diagnostics;
  None

let closed_program sink asked p =
  match (robots_of p, asked) with
  | ([ input ], [ output ]), _ when input <> output -> refuse sink [ mixed p input output ]
  | ([ input ], _ | [], [ input ]), Some robot when input <> robot ->
      refuse sink [ another p robot [ input ] ]
  | _ -> as_it_stands p

let allowed p = List.filter (fun robot -> lacks p robot <> None) (all p)

let open_program sink asked p =
  let allowed = allowed p in
  let asked =
    match asked with
    | None when (not p.signed) && fits p Robot.default -> Some Robot.default
    | asked -> asked
  in
  match (allowed, asked) with
  (* If the types rule out every robot, leaves the program open. Running it will report the
     error. *)
  | [], _ -> as_it_stands p
  | _, Some robot -> (
      match lacks p robot with
      | Some [] -> Some (close p robot)
      | Some lacks -> refuse sink (List.map (lacking p robot) lacks)
      | None -> refuse sink [ another p robot allowed ])
  | [ robot ], None when fits p robot -> Some (close p robot)
  | _, None -> (
      match fitting p with
      | [] -> refuse sink [ on_no_robot p allowed ]
      | robots -> refuse sink [ not_said p robots ])

let is_open p = Fit.openness (typed_entry p) = Open_program

(* Whether a signal function requires capabilities that some robot has, and is therefore compiled
   for a robot. *)
let asks p = (typed_entry p).scheme.context <> [] && fitting p <> []

let closed sink asked p =
  match (Fit.openness (typed_entry p), asked) with
  | Open_program, _ | Open_signal_function, Some _ -> open_program sink asked p
  | Open_signal_function, None when asks p -> open_program sink asked p
  | Open_signal_function, None -> as_it_stands p
  | Closed, _ -> closed_program sink asked p

let sampled p =
  match (allowed p, fitting p) with
  | [], _ -> as_it_stands p
  | _, [] -> None
  | _, robot :: _ -> Some (close p robot)
