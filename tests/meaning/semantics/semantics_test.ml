(* Checks docs/semantics.md: each table shows what its program does in both engines, and each
   event primitive, switch and task has a section with its type. Checks the appendices of
   docs/language.md: they list every name of the prelude and of the described modules, with its
   type. *)

let root = "../../.."
let ( / ) = Filename.concat
let semantics = Page.parts (Page.read (root / "docs" / "semantics.md"))
let language = Page.parts (Page.read (root / "docs" / "language.md"))
let declared module_ = Library_module.declared (Page.read (root / "stdlib" / (module_ ^ ".frob")))
let prelude = declared "Prelude"

(* The modules that have a heading in appendix B. *)
let library =
  [
    "Control";
    "Geometry";
    "Driving";
    "Sources";
    "Past";
    "Integration";
    "Behaviour";
    "Motion";
    "Angles";
    "Arrays";
    "Kalman";
    "Matrix";
    "Filters";
    "Logic";
    "Pid";
    "TestRobot";
    "Trial";
    "WallFollow";
    "Display";
    "Imu";
    "Lidar";
    "Ros";
    "Vision";
    "Stereo";
    "Tags";
  ]

let modules = List.map (fun name -> (name, declared name)) library
let frobc = Sys.argv.(1)

let write file text =
  let channel = open_out_bin file in
  output_string channel text;
  close_out channel

(* Fields with a comma need quotes. *)
let csv rows =
  let field cell = if String.contains cell ',' then "\"" ^ cell ^ "\"" else cell in
  String.concat "" (List.map (fun row -> String.concat "," (List.map field row) ^ "\n") rows)

let of_csv text =
  let fields line =
    let rec go i quoted cell found =
      if i >= String.length line then List.rev (cell :: found)
      else
        match line.[i] with
        | '"' -> go (i + 1) (not quoted) cell found
        | ',' when not quoted -> go (i + 1) quoted "" (cell :: found)
        | other -> go (i + 1) quoted (cell ^ String.make 1 other) found
    in
    go 0 false "" []
  in
  String.split_on_char '\n' text |> List.filter (fun line -> line <> "") |> List.map fields

let rec transpose = function
  | [] | [] :: _ -> []
  | rows -> List.map List.hd rows :: transpose (List.map List.tl rows)

(* Times in the tables have no trailing zeros. *)
let short time =
  let rec go n = if n > 0 && time.[n - 1] = '0' then go (n - 1) else n in
  let n = if String.contains time '.' then go (String.length time) else String.length time in
  String.sub time 0 (if n > 0 && time.[n - 1] = '.' then n - 1 else n)

(* A row's label is its trace column in backticks; `time` has no backticks. *)
let label row =
  match (List.hd row, Page.code (List.hd row)) with
  | "time", [] -> "time"
  | _, name :: _ -> name
  | text, [] -> Alcotest.failf "the row %S names no column" text

let is_output row =
  let name = List.hd row in
  String.length name >= 3 && String.sub name 0 3 = "out"

let trace engine ~program ~input =
  write "program.frob" program;
  write "input.csv" (csv input);
  let command =
    Filename.quote_command frobc ~stdout:"output.csv"
      [ "trace"; "--lint"; "--engine"; engine; "--input"; "input.csv"; "program.frob" ]
  in
  if Sys.command command <> 0 then Alcotest.failf "rejected with --engine %s" engine;
  of_csv (Page.read "output.csv")

let same_as_the_program program (table : Page.table) () =
  let rows = List.map (fun row -> label row :: List.tl row) table.rows in
  let outputs, inputs = List.partition is_output rows in
  let expected = List.hd rows :: outputs in
  let columns = List.length (List.hd rows) in
  let whole row = List.length row = columns in
  Alcotest.(check bool) "all rows are of one length" true (List.for_all whole rows);
  Alcotest.(check bool) "there is an output" true (outputs <> []);
  let check engine =
    let output = transpose (trace engine ~program ~input:(transpose inputs)) in
    let output = match output with times :: values -> List.map short times :: values | [] -> [] in
    Alcotest.(check (list (list string))) ("--engine " ^ engine) expected output
  in
  List.iter check [ "c"; "interp" ]

type passage = {
  names : string list;
  signatures : string list;
  examples : (string * Page.table) list;
}

(* Each table shows the output of the code block before it. *)
let passages =
  let rec go current block found = function
    | [] -> List.rev (current :: found)
    | Page.Heading { text; _ } :: rest ->
        let next = { names = Page.code text; signatures = []; examples = [] } in
        go next None (current :: found) rest
    | Page.Block { language = "frob"; text; _ } :: rest -> go current (Some text) found rest
    | Page.Block { line; language; _ } :: _ ->
        failwith (Printf.sprintf "line %d: a block of %S" line language)
    | Page.Table ({ line; _ } as table) :: rest -> (
        match block with
        | Some program ->
            let examples = current.examples @ [ (program, table) ] in
            go { current with examples } None found rest
        | None -> failwith (Printf.sprintf "line %d: a table without a program" line))
    | Page.Text { text; _ } :: rest ->
        let whole =
          match Page.code text with [ code ] when "`" ^ code ^ "`" = text -> [ code ] | _ -> []
        in
        go { current with signatures = current.signatures @ whole } block found rest
  in
  let none = { names = []; signatures = []; examples = [] } in
  go none None [] semantics |> List.filter (fun passage -> passage.names <> [])

(* The tables of the appendices, each with the heading above it. *)
let appendix =
  let rec start = function
    | Page.Heading { depth = 2; text; _ } :: rest
      when String.length text > 8 && String.sub text 0 8 = "Appendix" ->
        rest
    | _ :: rest -> start rest
    | [] -> failwith "docs/language.md has no appendix"
  in
  start language

let tables =
  let rec go heading found = function
    | [] -> List.rev found
    | Page.Heading { text; _ } :: rest -> go text found rest
    | Page.Table table :: rest -> go heading ((heading, table) :: found) rest
    | (Page.Block _ | Page.Text _) :: rest -> go heading found rest
  in
  go "" [] appendix

let names row = Page.code (List.hd row)

(* The constructors in the second column, if it has any: `Name Type Type`. *)
let constructors = function
  | _ :: second :: _ ->
      List.map (fun code -> List.hd (String.split_on_char ' ' code)) (Page.code second)
  | _ -> []

let in_appendix =
  let of_part = function
    | Page.Text { text; _ } -> Page.code text
    | Page.Table { rows; _ } -> List.concat_map names rows
    | Page.Heading _ | Page.Block _ -> []
  in
  List.concat_map of_part appendix

let nothing what found = Alcotest.(check (list string)) what [] (List.sort String.compare found)

let every_name () =
  nothing "not in the appendix"
    (List.filter
       (fun name -> not (List.mem name in_appendix))
       (prelude.types @ List.map fst prelude.values))

let every_name_of (module_, (declared : Library_module.t)) () =
  let of_table (heading, (table : Page.table)) =
    if not (String.equal heading module_) then []
    else List.concat_map (fun row -> names row @ constructors row) (List.tl table.rows)
  in
  let described = List.concat_map of_table tables in
  nothing "not in the appendix"
    (List.filter
       (fun name -> not (List.mem name described))
       (declared.types @ List.map fst declared.values))

let types_of_the_library () =
  let wrong (declared : Library_module.t) row =
    match row with
    | _ :: type_ :: _ ->
        List.filter
          (fun name ->
            match List.assoc_opt name declared.values with
            | Some declared -> Page.code type_ <> [ declared ]
            | None -> not (List.mem name declared.types))
          (names row)
    | _ -> []
  in
  let of_table ((heading, table) : string * Page.table) =
    let declared = Option.value (List.assoc_opt heading modules) ~default:prelude in
    match table.rows with
    | ("name" :: "type" :: _) :: rows -> List.concat_map (wrong declared) rows
    | _ -> []
  in
  nothing "another type in the library" (List.concat_map of_table tables)

let each_has_a_passage () =
  let of_table ((heading, table) : string * Page.table) =
    match heading with
    | "Events" | "Switches" | "Tasks" -> List.concat_map names (List.tl table.rows)
    | _ -> []
  in
  let wanted = List.concat_map of_table tables in
  Alcotest.(check bool) "the appendix has events, switches and tasks" true (List.length wanted > 60);
  let shown name = List.exists (fun passage -> List.mem name passage.names) passages in
  nothing "without a passage" (List.filter (fun name -> not (shown name)) wanted)

let passage_is_complete passage () =
  let signature name = name ^ " :: " ^ List.assoc name prelude.values in
  Alcotest.(check (list string)) "types" (List.map signature passage.names) passage.signatures;
  Alcotest.(check bool) "has a table" true (passage.examples <> [])

let () =
  Unix.putenv "XDG_CACHE_HOME" (Sys.getcwd ());
  let cases passage =
    let title = String.concat ", " passage.names in
    Alcotest.test_case (title ^ ": type") `Quick (passage_is_complete passage)
    :: List.map
         (fun (program, (table : Page.table)) ->
           let name = Printf.sprintf "%s: the table at line %d" title table.line in
           Alcotest.test_case name `Quick (same_as_the_program program table))
         passage.examples
  in
  Alcotest.run
    ~argv:[| Sys.argv.(0) |]
    "semantics"
    [
      ( "appendix",
        Alcotest.test_case "has every name of the prelude" `Quick every_name
        :: List.map
             (fun (name, declared) ->
               Alcotest.test_case ("has every name of " ^ name) `Quick
                 (every_name_of (name, declared)))
             (* its table lists constructors with their type, but not the internals of its texts *)
             (List.remove_assoc "Display" modules)
        @ [
            Alcotest.test_case "has the library's types" `Quick types_of_the_library;
            Alcotest.test_case "has a passage for each event, switch and task" `Quick
              each_has_a_passage;
          ] );
      ("passages", List.concat_map cases passages);
    ]
