(* Writes programs, their recordings and the expected results as C that reads no files. For each
   program it makes a folder with its generated C, its table for hosts, expected.c and state.c
   (see expected.h); the folder for_tcc has the same C adapted to tcc. The programs are random
   ones, many in a module, and named files; PROGRAM:ROBOT is a program for the robot of that name
   or file. *)

open Fuzz

let ( / ) = Filename.concat

type settings = {
  mutable library : string;
  mutable runtime : string;
  mutable out : string;
  mutable seed : int;
  mutable count : int;
  mutable files : string list;
}

let settings () =
  let s = { library = ""; runtime = ""; out = "."; seed = 1; count = 0; files = [] } in
  let text name set doc = (name, Arg.String set, doc)
  and number name set doc = (name, Arg.Int set, doc) in
  Arg.parse
    [
      text "--library" (fun v -> s.library <- v) "DIR the standard library";
      text "--runtime" (fun v -> s.runtime <- v) "DIR the runtime's sources";
      text "--out" (fun v -> s.out <- v) "DIR where the folders are made";
      number "--count" (fun v -> s.count <- v) "N how many random programs";
      number "--seed" (fun v -> s.seed <- v) "S of the random programs and all inputs";
    ]
    (fun file -> s.files <- s.files @ [ file ])
    "emit [OPTIONS] [FILE.frob[:ROBOT]...]";
  s

let write path text =
  let channel = open_out_bin path in
  Fun.protect ~finally:(fun () -> close_out channel) (fun () -> output_string channel text)

(* The 64-bit FNV-1a hash, the same as in runner.c. *)
let hash text =
  let mix h c = Int64.mul (Int64.logxor h (Int64.of_int (Char.code c))) 0x100000001b3L in
  Seq.fold_left mix 0xcbf29ce484222325L (String.to_seq text)

let c_string text =
  let character = function
    | '"' -> "\\\""
    | '\\' -> "\\\\"
    | c when c >= ' ' && c <= '~' -> String.make 1 c
    | c -> Printf.sprintf "\\%03o" (Char.code c)
  in
  "\"" ^ String.concat "" (List.map character (List.of_seq (String.to_seq text))) ^ "\""

(* A function of the common type that calls the program's own step. *)
let step_single (program : Step.Ir.program) ~has_params =
  let name = program.name in
  let params, unused =
    if has_params then (Printf.sprintf "(const struct %s_params *)params, " name, "")
    else ("", "    (void)params;\n")
  in
  Printf.sprintf
    "static void step_single(void *state, const void *params, float dt, const void *input, void \
     *output)\n\
     {\n\
     %s    %s_step((struct %s_state *)state, %sdt, (const struct %s_input *)input, (struct \
     %s_output *)output);\n\
     }\n"
    unused name name params name name

let is_of_singles recording = Recording.precision recording = Single

let expected (program : Step.Ir.program) subject recordings =
  let has_params = List.exists (fun r -> Recording.params r <> []) recordings in
  let recording k r =
    let row { Recording.time_ns; cells; _ } seconds =
      Printf.sprintf "    { INT64_C(%d), UINT64_C(0x%Lx), (const char *const[]){ %s } },\n" time_ns
        (Int64.bits_of_float seconds)
        (String.concat ", " (List.map c_string cells @ [ "0" ]))
    in
    let params = List.map (fun (p : Recording.param) -> c_string p.cell) (Recording.params r) in
    Printf.sprintf
      "static const char *const params_%d[] = { %s };\n\
       static const struct row rows_%d[] = {\n\
       %s};\n"
      k
      (String.concat ", " (params @ [ "0" ]))
      k
      (String.concat "" (List.map2 row (Recording.rows r) (Recording.seconds r)))
  and entry k r =
    Printf.sprintf "    { rows_%d, %d, params_%d, UINT64_C(0x%Lx), %s },\n" k
      (List.length (Recording.rows r))
      k
      (hash (Engines.interpreted subject r))
      (if is_of_singles r then "step_single" else "0")
  in
  Printf.sprintf
    "#include \"expected.h\"\n\
     #include \"%s.h\"\n\n\
     %s%s\n\
     const struct recording recordings[] = {\n\
     %s};\n\
     const int recording_count = %d;\n"
    program.name
    (if List.exists is_of_singles recordings then step_single program ~has_params ^ "\n" else "")
    (String.concat "\n" (List.mapi recording recordings))
    (String.concat "" (List.mapi entry recordings))
    (List.length recordings)

let step ?robot (tools : Engines.tools) file =
  let options = { Build.Common_options.default with real = tools.real } in
  let request = Build.Request.make ~options ?robot ~library:tools.library file in
  let sink = Basis.Diagnostic.sink () and sources = Basis.Source.create () in
  match Build.Queries.step sink sources request with
  | Some step -> step
  | None -> failwith (file ^ " has no state to compare")

(* Whether to test the program also with steps of arbitrary dt: among many programs, for a third
   of them. Excludes programs for a robot, whose single-precision structs are not the program's
   own, and programs that end, because the interpreter prints only times for them. *)
let has_any_dt ?robot (program : Step.Ir.program) random ~many =
  let is_robot's shape = Option.is_some (Cgen.Robot.of_shape ?own:robot shape) in
  (not program.ends)
  && (not (is_robot's program.input))
  && (not (is_robot's program.output))
  && ((not many) || Choice.chance random 3)

let emit ?robot ?(many = false) s tools ~name ~seed file =
  match Engines.load ?robot tools ~entry:"main" file with
  | Error outcome ->
      prerr_endline (name ^ " " ^ Engines.describe outcome);
      exit 1
  | Ok subject ->
      let folder = s.out / name in
      Unix.mkdir folder 0o755;
      let random = Random.State.make [| s.seed; seed |] in
      let program = step ?robot tools file in
      let recordings = Engines.recordings random ~rows:25 subject in
      let recordings =
        if has_any_dt ?robot program random ~many then
          recordings @ [ Engines.with_dt random ~rows:25 tools subject ]
        else recordings
      in
      Unix.mkdir (folder / "for_tcc") 0o755;
      let write_file (file, text) =
        write (folder / file) text;
        write (folder / "for_tcc" / file) (Build.Tcc.adapted text)
      in
      List.iter write_file (Engines.files subject);
      write_file ("state.c", State.text program);
      write (folder / "expected.c") (expected program subject recordings)

let program_and_robot argument =
  match String.split_on_char ':' argument with
  | [ file; robot ] -> (
      match Build.Robots.known (Some robot) with
      | Ok robot -> (file, robot)
      | Error reason -> failwith reason)
  | _ -> (argument, None)

let () =
  let s = settings () in
  let tools real =
    { Engines.library = s.library; runtime = s.runtime; folder = s.out; real; probed = false }
  in
  let named file = Filename.remove_extension (Filename.basename file) in
  List.iteri
    (fun i argument ->
      let file, robot = program_and_robot argument in
      emit ?robot s (tools Basis.Real.Double) ~name:(named file) ~seed:i file;
      emit ?robot s (tools Single) ~name:(named file ^ "_single") ~seed:i file)
    s.files;
  let rec modules first =
    if first < s.count then (
      let count = min Batch.size (s.count - first) in
      let file = s.out / "program.frob" in
      let real : Basis.Real.t =
        if Int.rem (Int.div first Batch.size) 3 = 1 then Single else Double
      in
      write file (Constant.in_range real (Program.make ~seed:s.seed ~first ~count ()));
      emit ~many:true s (tools real)
        ~name:(Printf.sprintf "random_%d" first)
        ~seed:(-1 - first) file;
      modules (first + count))
  in
  modules 0
