(* Checks that the syntax trees built into the compiler match the library's files. *)

open Basis

let stdlib = "../../../stdlib"

let read file =
  let channel = open_in_bin file in
  Fun.protect
    ~finally:(fun () -> close_in channel)
    (fun () -> really_input_string channel (in_channel_length channel))

let modules = Resolve.Files.on_disk.modules_in stdlib
let text module_ = read (Filename.concat stdlib (module_ ^ ".frob"))
let shown module_ = "stdlib/" ^ module_ ^ ".frob"

let parsed module_ =
  let sink = Diagnostic.sink () in
  let tree =
    Syntax.Parse.program (Advice.Of_syntax.into sink) ~file:(shown module_) (text module_)
  in
  Alcotest.(check int) "no diagnostics" 0 (List.length (Diagnostic.all sink));
  tree

let prepared module_ text = Prepared.Library.tree ~file:(shown module_) text

(* Compares everything, including positions, numbers and comments. *)
let is_a_fresh_parse module_ () =
  let tree = prepared module_ (text module_) in
  Alcotest.(check bool) "prepared" true (Option.is_some tree);
  Alcotest.(check bool) "the same" true (tree = parsed module_)

let changed_text () =
  let changed = text "Prelude" ^ "\n" in
  Alcotest.(check bool) "not prepared" true (prepared "Prelude" changed = None)

(* If the file's name differs, there is no prepared tree, because messages would show the wrong
   name. *)
let other_file () =
  let tree = Prepared.Library.tree ~file:"elsewhere/Prelude.frob" (text "Prelude") in
  Alcotest.(check bool) "not prepared" true (tree = None)

let () =
  let fresh module_ = Alcotest.test_case module_ `Quick (is_a_fresh_parse module_) in
  Alcotest.run "prepared library"
    [
      ("a fresh parse", List.map fresh modules);
      ( "anything else",
        [
          Alcotest.test_case "a changed text" `Quick changed_text;
          Alcotest.test_case "another folder" `Quick other_file;
        ] );
    ]
