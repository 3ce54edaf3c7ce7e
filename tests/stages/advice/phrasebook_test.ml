(* Checks that each row of the phrasebook has an effect: compiles a program that contains the word at
   its place, and looks for the hint. *)

open Basis
open Advice

(* {1 One program for each row} *)

let in_proc value =
  Printf.sprintf "main :: SF Float Float\nmain = proc i -> y where\n  y = %s\n" value

let applied (row : Phrase.t) = String.concat " " (row.word :: row.arguments)
let in_function ty (row : Phrase.t) = Printf.sprintf "f :: %s -> %s\nf x = %s g x\n" ty ty row.word

let as_field (row : Phrase.t) =
  Printf.sprintf "import Robot\nmain :: SF RobotInput Float\nmain = proc i -> i.%s\n" row.word

let program (row : Phrase.t) =
  match row.place with
  (* Directly after `=`, this word begins a loop of another language. *)
  | Value when row.word = "while" -> in_proc "(while)"
  | Value | Robot | Constructor -> in_proc row.word
  | Call | Reading | Controller -> in_proc (applied row)
  | Speed -> in_proc (Printf.sprintf "roMake (%s)" (applied row))
  | In_array -> in_function "Array 2 Float" row
  | In_event -> in_function "Event Float" row
  | In_task -> in_function "Task () () Float" row
  | Operator -> in_proc (Printf.sprintf "i %s i" row.word)
  | Object -> in_proc (row.word ^ ".k")
  | Type -> Printf.sprintf "f :: %s\nf = 1\n" row.word
  | Class -> Printf.sprintf "f :: %s a => a -> a\nf x = x\n" row.word
  | Qualifier -> in_proc (row.word ^ ".x")
  | Module | Library -> Printf.sprintf "import %s\n" row.word
  | Unit -> in_proc (Printf.sprintf "3[%s]" row.word)

(* A part of the hint. *)
let expected (row : Phrase.t) =
  let replacement = Option.value row.replacement ~default:"" in
  match row.place with
  | Value | Robot | Constructor | Type | Qualifier | Module -> Phrasebook.hint row
  (* The fix after the colon can be the program's own signature without the class. *)
  | Class -> List.hd (String.split_on_char ':' (Phrasebook.hint row))
  | Call -> Printf.sprintf "write `%s`%s" replacement (Option.value row.hint ~default:"")
  | Reading | Speed | In_array | In_event | In_task -> Printf.sprintf "write `%s`" replacement
  | Controller -> Printf.sprintf "use `%s`" replacement
  | Operator -> Printf.sprintf "write `%s` instead of `%s`" replacement row.word
  | Object -> "write `k` alone"
  | Library -> Printf.sprintf "write `import %s`" replacement
  | Unit -> Printf.sprintf "`%s`" replacement

(* {1 The messages} *)

let read path =
  match Resolve.Files.on_disk.read path with
  | Ok text -> text
  | Error _ -> failwith ("cannot read " ^ path)

let library = "../../../stdlib"

let library_texts =
  lazy
    (Array.to_list (Sys.readdir library)
    |> List.filter (fun file -> Filename.check_suffix file ".frob")
    |> List.map (fun file -> ("stdlib/" ^ file, read (Filename.concat library file))))

let diagnostics text =
  let sink = Diagnostic.sink () in
  let files = Resolve.Files.in_memory (("main.frob", text) :: Lazy.force library_texts) in
  let files = { files with parsed = Prepared.Library.tree } in
  let remember ~file:_ _ = () in
  (match
     Resolve.Program.load (Of_resolve.into sink) ~files ~remember ~library:"stdlib" "main.frob"
   with
  | Some resolved -> ignore (Typing.Of_resolved.program (Of_typing.into sink) ~real:Double resolved)
  | None -> ());
  Diagnostic.all sink

let contains part text =
  let n = String.length part in
  let rec from i = i + n <= String.length text && (String.sub text i n = part || from (i + 1)) in
  from 0

let has_hint row program =
  let hints =
    List.concat_map
      (fun (d : Diagnostic.t) ->
        List.map (fun (h : Diagnostic.hint) -> Diagnostic.for_display h.text) d.hints)
      (diagnostics program)
  in
  List.exists (contains (expected row)) hints

let is_without_effect (row : Phrase.t) =
  not (has_hint row (program row) || (row.place = Robot && has_hint row (as_field row)))

let has_effect () =
  let rows = List.filter is_without_effect (Lazy.force Phrasebook.rows) in
  let show (row : Phrase.t) = Printf.sprintf "%s%s\n" (program row) (expected row) in
  Alcotest.(check (list string)) "rows without an effect" [] (List.map show rows)

let is_unique () =
  let seen = Hashtbl.create 1024 in
  let again (row : Phrase.t) =
    let key = (row.word, row.place, List.length row.arguments) in
    let known = Hashtbl.mem seen key in
    Hashtbl.replace seen key ();
    if known then Some row.word else None
  in
  let twice = List.filter_map again (Lazy.force Phrasebook.rows) in
  Alcotest.(check (list string)) "words with two rows" [] twice

let () =
  Alcotest.run "phrasebook"
    [
      ( "rows",
        [
          Alcotest.test_case "each row has an effect" `Quick has_effect;
          Alcotest.test_case "no word has two rows for a place" `Quick is_unique;
        ] );
    ]
