(* Programs with recordings and what they must answer, as C that needs no files:
   for each program a folder with its generated C, its table for hosts, expected.c
   and state.c (see expected.h); in for_tcc the same C
   such as tcc compiles it. Programs are random ones, many in a module, and files that
   are named; PROGRAM:ROBOT is a program for the robot of that name or file. *)

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

(* FNV-1a of 64 bits, as runner.c has it. *)
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

let expected subject recordings =
  let recording k r =
    let rows = Recording.rows r in
    let row { Recording.time_ns; cells; _ } =
      Printf.sprintf "    { INT64_C(%d), (const char *const[]){ %s } },\n" time_ns
        (String.concat ", " (List.map c_string cells @ [ "0" ]))
    in
    Printf.sprintf "static const struct row rows_%d[] = {\n%s};\n" k
      (String.concat "" (List.map row rows))
  and entry k r =
    Printf.sprintf "    { rows_%d, %d, UINT64_C(0x%Lx) },\n" k
      (List.length (Recording.rows r))
      (hash (Engines.interpreted subject r))
  in
  Printf.sprintf
    "#include \"expected.h\"\n\n%s\nconst struct recording recordings[] = {\n%s};\n\
     const int recording_count = %d;\n"
    (String.concat "\n" (List.mapi recording recordings))
    (String.concat "" (List.mapi entry recordings))
    (List.length recordings)

let machine ?robot (tools : Engines.tools) file =
  let options =
    {
      Driver.Pipeline.dump = None;
      stop_after = None;
      lint = false;
      specialization_limit = 10_000;
      real = tools.real;
    }
  in
  let sink = Basis.Diagnostic.sink () and sources = Basis.Source.create () in
  match Driver.Pipeline.machine options sink sources ~library:tools.library ?robot ~entry:"main" file with
  | Some machine -> machine
  | None -> failwith (file ^ " has no state to compare")

let emit ?robot s tools ~name ~seed file =
  match Engines.load ?robot tools ~entry:"main" file with
  | Error outcome ->
      prerr_endline (name ^ " " ^ Engines.describe outcome);
      exit 1
  | Ok subject ->
      let folder = s.out / name in
      Unix.mkdir folder 0o755;
      let random = Random.State.make [| s.seed; seed |] in
      let recordings = Engines.recordings random ~rows:25 subject in
      Unix.mkdir (folder / "for_tcc") 0o755;
      let write_file (file, text) =
        write (folder / file) text;
        write (folder / "for_tcc" / file) (In_process.for_tcc text)
      in
      List.iter write_file (Engines.files subject);
      write_file ("state.c", State.text (machine ?robot tools file));
      write (folder / "expected.c") (expected subject recordings)

let program_and_robot argument =
  match String.split_on_char ':' argument with
  | [ file; robot ] -> (
      match Driver.Robots.known (Some robot) with
      | Ok robot -> (file, robot)
      | Error reason -> failwith reason)
  | _ -> (argument, None)

let () =
  let s = settings () in
  let tools real = { Engines.library = s.library; runtime = s.runtime; folder = s.out; real } in
  let named file = Filename.remove_extension (Filename.basename file) in
  List.iteri
    (fun i argument ->
      let file, robot = program_and_robot argument in
      emit ?robot s (tools Basis.Real.Double) ~name:(named file) ~seed:i file;
      emit ?robot s (tools Single) ~name:(named file ^ "_single") ~seed:i file)
    s.files;
  let rec modules first =
    if first < s.count then begin
      let count = min Batch.size (s.count - first) in
      let file = s.out / "program.frob" in
      let real : Basis.Real.t = if Int.rem (Int.div first Batch.size) 3 = 1 then Single else Double in
      write file (Constant.in_range real (Program.make ~seed:s.seed ~first ~count ()));
      emit s (tools real) ~name:(Printf.sprintf "random_%d" first) ~seed:(-1 - first) file;
      modules (first + count)
    end
  in
  modules 0
