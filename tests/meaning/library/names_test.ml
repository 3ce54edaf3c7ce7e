(* Checks that each name of the library has a comment and that some test runs it. *)

open Basis

let root = "../../.."
let ( / ) = Filename.concat
let stdlib = root / "stdlib"

let read file =
  let channel = open_in_bin file in
  Fun.protect
    ~finally:(fun () -> close_in channel)
    (fun () -> really_input_string channel (in_channel_length channel))

(* Tests that run programs in both engines and state or compare the results. *)
let tests =
  let files folder extension =
    Sys.readdir (root / folder)
    |> Array.to_list
    |> List.filter (fun file -> Filename.check_suffix file extension)
    |> List.map (fun file -> read (root / folder / file))
  in
  read (root / "docs" / "semantics.md")
  :: (files "tests/meaning/interp" ".frob"
     @ List.concat_map
         (fun area -> files ("tests" / area) ".t")
         [
           "meaning/library";
           "meaning/arrays";
           "meaning/switch";
           "meaning/tasks";
           "meaning/capabilities";
           "meaning/paper";
           "robots/run";
         ])

let is_name_character c =
  match c with 'a' .. 'z' | 'A' .. 'Z' | '0' .. '9' | '_' | '\'' -> true | _ -> false

let is_word name = is_name_character name.[0]

(* Looks for whole words; for operators, anywhere. *)
let occurs name text =
  let n = String.length name in
  let apart i = i < 0 || i >= String.length text || not (is_name_character text.[i]) in
  let rec from i =
    i + n <= String.length text
    && ((String.sub text i n = name && ((not (is_word name)) || (apart (i - 1) && apart (i + n))))
       || from (i + 1))
  in
  from 0

let load name =
  let sink = Diagnostic.sink () in
  let file = stdlib / (name ^ ".frob") in
  match
    Resolve.Program.load (Advice.Of_resolve.into sink) ~files:Resolve.Files.on_disk
      ~remember:(fun ~file:_ _ -> ())
      ~library:stdlib file
  with
  | Some program -> program
  | None -> Alcotest.fail (file ^ " does not load")

type declared = {
  name : string;
  doc : string option;
  runs : bool;
  takes_input : bool;  (** a function, a signal function or a task *)
}

let takes_input (scheme : Resolve.Ir.scheme option) =
  match scheme with
  | Some { ty = { desc = Function _; _ }; _ } -> true
  | Some { ty = { desc = Named { tycon; _ }; _ }; _ } -> List.mem tycon.name [ "SF"; "Task" ]
  | _ -> false

(* The names that a module itself declares. *)
let declared module_ (program : Resolve.Ir.program) =
  let own (g : Resolve.Ir.Global.t) = String.equal g.module_ module_ in
  let value ?scheme (g : Resolve.Ir.Global.t) doc =
    if own g then [ { name = g.name; doc; runs = true; takes_input = takes_input scheme } ] else []
  in
  let of_type (t : Resolve.Ir.type_declaration) =
    if own t.tycon && t.definition <> Builtin then
      [ { name = t.tycon.name; doc = t.doc; runs = false; takes_input = false } ]
    else []
  in
  (* The comment of a class with a single method also documents the method. *)
  let method_ (c : Resolve.Ir.class_) (m : Resolve.Ir.method_) =
    value m.name (match (m.doc, c.methods) with None, [ _ ] -> c.doc | doc, _ -> doc)
  in
  let of_class (c : Resolve.Ir.class_) =
    if not (own c.class_) then []
    else
      { name = c.class_.name; doc = c.doc; runs = false; takes_input = false }
      :: List.concat_map (method_ c) c.methods
  in
  let of_binding (b : Resolve.Ir.binding) =
    match b.name with
    | Top (g, _) -> value ?scheme:b.signature g b.doc
    | Inner _ | Destructure _ -> []
  in
  let of_primitive (p : Resolve.Ir.primitive) = value ~scheme:p.scheme p.name p.doc in
  List.concat
    [
      List.concat_map of_type program.types;
      List.concat_map of_primitive program.primitives;
      List.concat_map of_class program.classes;
      List.concat_map
        (fun (g : Resolve.Ir.binding_group) -> List.concat_map of_binding g.bindings)
        program.groups;
    ]

let names suits declared = List.filter_map (fun d -> if suits d then Some d.name else None) declared

(* The modules of robots are tested with the robots, in the simulator. *)
let general =
  [
    "Prelude";
    "Control";
    "Geometry";
    "Sources";
    "Past";
    "Angles";
    "Filters";
    "Logic";
    "Pid";
    "Integration";
    "Behaviour";
    "Motion";
    "Arrays";
    "Matrix";
    "Kalman";
    "Driving";
    "Lidar";
    "Imu";
  ]

(* The sentences that state facts for warnings in a form that the compiler does not recognize. *)
let sentences module_ =
  let program = load module_ in
  let facts = Typing.Doc_facts.of_program program in
  let quotations marker doc =
    let after k = String.sub doc k (String.length doc - k) in
    match
      List.find_opt
        (fun k -> String.starts_with ~prefix:marker (after k))
        (List.init (String.length doc) Fun.id)
    with
    | None -> 0
    | Some k ->
        let sentence = List.hd (String.split_on_char '.' (after k)) in
        Int.div (List.length (String.split_on_char '`' sentence) - 1) 2
  in
  let wrong (g : Resolve.Ir.Global.t) doc =
    let doc = Option.value doc ~default:"" in
    if
      String.equal g.module_ module_
      && (quotations "Requires:" doc <> List.length (Typing.Doc_facts.requirements facts g)
         || quotations "For angles that wrap" doc
            > 0
            <> (Typing.Doc_facts.for_angles facts g <> None))
    then [ g.name ]
    else []
  in
  let binding (b : Resolve.Ir.binding) =
    match b.name with Top (g, _) -> wrong g b.doc | Inner _ | Destructure _ -> []
  in
  let data (t : Resolve.Ir.type_declaration) =
    match t.definition with Data [ c ] -> wrong c.constructor t.doc | _ -> []
  in
  List.concat
    [
      List.concat_map (fun (p : Resolve.Ir.primitive) -> wrong p.name p.doc) program.primitives;
      List.concat_map
        (fun (g : Resolve.Ir.binding_group) -> List.concat_map binding g.bindings)
        program.groups;
      List.concat_map data program.types;
    ]

(* Tests use these primitives through the methods of classes, and need not mention their names. *)
let primitives_of_classes = [ "consoleImu"; "consoleLidar" ]

let check module_ =
  let declared = declared module_ (load module_) in
  let case what suits =
    Alcotest.test_case
      (module_ ^ ": " ^ what)
      `Quick
      (fun () -> Alcotest.(check (list string)) what [] (names suits declared))
  in
  case "without a doc comment" (fun d -> d.doc = None)
  :: Alcotest.test_case (module_ ^ ": facts") `Quick (fun () ->
         Alcotest.(check (list string)) "not understood" [] (sentences module_))
  ::
  (if List.mem module_ general then
     [
       case "in no test" (fun d ->
           d.runs
           && (not (List.mem d.name primitives_of_classes))
           && not (List.exists (occurs d.name) tests));
       case "without an example" (fun d ->
           module_ <> "Prelude" && d.takes_input
           && (not (List.mem d.name primitives_of_classes))
           && not (occurs "Example" (Option.value d.doc ~default:"")));
     ]
   else [])

let () =
  let modules = Resolve.Files.on_disk.modules_in stdlib in
  Alcotest.run "names of the library" [ ("modules", List.concat_map check modules) ]
