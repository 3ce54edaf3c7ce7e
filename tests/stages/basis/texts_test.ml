open Basis

let printable () =
  let shown = Alcotest.(check string) in
  shown "an escape" "red\\027[31m" (Printable.name "red\027[31m");
  shown "a line's end in a name" "a\\010b" (Printable.name "a\nb");
  shown "in a text" "a\nb" (Printable.text "a\nb");
  shown "what UTF-8 has in two bytes" "a\\155b" (Printable.name "a\xc2\x9bb");
  shown "letters" "größe.frob" (Printable.name "größe.frob")

let read path =
  let channel = open_in_bin path in
  let text = really_input_string channel (in_channel_length channel) in
  close_in channel;
  text

(* The page lists what a program may call without a file. *)
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
      ("printable", [ Alcotest.test_case "control characters" `Quick printable ]);
      ("C", [ Alcotest.test_case "pure functions are documented" `Quick pure ]);
    ]
