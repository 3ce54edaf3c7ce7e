open Basis

let printable () =
  let shown = Alcotest.(check string) in
  shown "an escape" "red\\027[31m" (Printable.name "red\027[31m");
  shown "a line's end in a name" "a\\010b" (Printable.name "a\nb");
  shown "in a text" "a\nb" (Printable.text "a\nb");
  shown "what UTF-8 has in two bytes" "a\\155b" (Printable.name "a\xc2\x9bb");
  shown "letters" "größe.frob" (Printable.name "größe.frob")

(* A shell parses each quoted word back to the original, and the quoted word contains no control
   characters. *)
let words () =
  let of_shell word =
    let channel =
      Unix.open_process_args_in "/bin/bash" [| "bash"; "-c"; "printf %s " ^ Printable.word word |]
    in
    let text = Buffer.create 16 in
    (try Buffer.add_channel text channel 1000 with End_of_file -> ());
    ignore (Unix.close_process_in channel : Unix.process_status);
    Buffer.contents text
  in
  List.iter
    (fun word ->
      Alcotest.(check string) "the same word" word (of_shell word);
      Alcotest.(check string)
        "without control characters" (Printable.word word)
        (Printable.name (Printable.word word)))
    [
      "plain.frob";
      "a b";
      "it's";
      "$(date) `x`";
      "-";
      "";
      "e\\027";
      "red\027[31m";
      "l\nb'c\\";
      "\xc2\x9b";
    ]

let read path =
  let channel = open_in_bin path in
  let text = really_input_string channel (in_channel_length channel) in
  close_in channel;
  text

(* The page must list the functions that a program may call without a C file. *)
let pure () =
  let page = read "../../../docs/foreign.md" in
  let list = String.concat ", " (List.map (Printf.sprintf "`%s`") C_names.pure) in
  let n = String.length list in
  let rec within k =
    k + n <= String.length page && (String.sub page k n = list || within (k + 1))
  in
  Alcotest.(check bool) list true (within 0)

let () =
  Alcotest.run "texts"
    [
      ( "printable",
        [
          Alcotest.test_case "control characters" `Quick printable;
          Alcotest.test_case "words of a command" `Quick words;
        ] );
      ("C", [ Alcotest.test_case "pure functions are documented" `Quick pure ]);
    ]
