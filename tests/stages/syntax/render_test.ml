(* Tests how diagnostics are rendered, as text and as JSON. *)

open Basis

let at ?(file = "main.frob") line column line' column' =
  Span.make ~file ~start:(Span.position ~line ~column)
    ~stop:(Span.position ~line:line' ~column:column')

let source =
  let source = Source.create () in
  Source.add source ~file:"main.frob"
    "first = 1\n\
     speed = gain * err\n\
     err   = target - speed\n\
     x = case y of\n\
    \  A -> 1\n\
    \  B -> 2\n\
     \ty = 1\n\
     s = \"é日本\" + \027[31m + a\n\
     last = 9";
  Source.add source ~file:"other.frob" "one\ntwo\nthree\r\n";
  Source.add source ~file:"long.frob" (String.make 5000 'a' ^ "!" ^ String.make 5000 'b');
  Source.add source ~file:"marked.frob" "\xef\xbb\xbfx = 1\n";
  source

let error at = Diagnostic.error ~code:"E0999" ~at "something is wrong"

let shows name d expected =
  Alcotest.test_case name `Quick (fun () ->
      Alcotest.(check string)
        name
        (String.concat "\n" expected ^ "\n")
        (Render_text.diagnostic ~colour:false source d))

let text =
  [
    shows "a place and another one"
      (error (at 2 1 2 6)
      |> Diagnostic.label ~at:(at 3 1 3 4) "`err` reads it here"
      |> Diagnostic.hint "use `delay`")
      [
        "error[E0999]: something is wrong";
        " --> main.frob:2:1";
        "  |";
        "2 | speed = gain * err";
        "  | ^^^^^";
        "3 | err   = target - speed";
        "  | --- `err` reads it here";
        "  |";
        "  = hint: use `delay`";
      ];
    shows "a text beside the place"
      (error (at 2 9 2 13) |> Diagnostic.here "this")
      [
        "error[E0999]: something is wrong";
        " --> main.frob:2:9";
        "  |";
        "2 | speed = gain * err";
        "  |         ^^^^ this";
      ];
    shows "two places on a line"
      (error (at 2 16 2 19)
      |> Diagnostic.here "b"
      |> Diagnostic.label ~at:(at 2 9 2 13) "a"
      |> Diagnostic.label ~at:(at 2 1 2 6) "c")
      [
        "error[E0999]: something is wrong";
        " --> main.frob:2:16";
        "  |";
        "2 | speed = gain * err";
        "  | -----   ----   ^^^ b";
        "  | |       |";
        "  | |       a";
        "  | c";
      ];
    shows "lines between are left out"
      (error (at 8 1 8 2)
      |> Diagnostic.label ~at:(at 1 1 1 6) "far"
      |> Diagnostic.label ~at:(at 3 1 3 4) "near")
      [
        "error[E0999]: something is wrong";
        " --> main.frob:8:1";
        "  |";
        "1 | first = 1";
        "  | ----- far";
        "2 | speed = gain * err";
        "3 | err   = target - speed";
        "  | --- near";
        "...";
        "8 | s = \"é日本\" + \xef\xbf\xbd[31m + a";
        "  | ^";
      ];
    shows "a place of several lines"
      (error (at 4 5 6 9) |> Diagnostic.here "this `case`")
      [
        "error[E0999]: something is wrong";
        " --> main.frob:4:5";
        "  |";
        "4 | x = case y of";
        "  |     ^^^^^^^^^";
        "5 |   A -> 1";
        "6 |   B -> 2";
        "  |   ^^^^^^ this `case`";
      ];
    shows "a tab is four blanks wide"
      (error (at 7 2 7 3))
      [
        "error[E0999]: something is wrong";
        " --> main.frob:7:2";
        "  |";
        "7 |     y = 1";
        "  |     ^";
      ];
    shows "columns are characters, marks stand under wide ones"
      (error (at 8 27 8 28))
      [
        "error[E0999]: something is wrong";
        " --> main.frob:8:22";
        "  |";
        "8 | s = \"é日本\" + \xef\xbf\xbd[31m + a";
        "  |                        ^";
      ];
    shows "two files"
      (error (at 1 1 1 6)
      |> Diagnostic.label ~at:(at ~file:"other.frob" 3 1 3 6) "the other"
      |> Diagnostic.note "a note\nof two lines")
      [
        "error[E0999]: something is wrong";
        " --> main.frob:1:1";
        "  |";
        "1 | first = 1";
        "  | ^^^^^";
        "  |";
        " ::: other.frob:3:1";
        "  |";
        "3 | three";
        "  | ----- the other";
        "  |";
        "  = note: a note";
        "          of two lines";
      ];
    shows "a file without text"
      (error (at ~file:"gone.frob" 3 4 3 5) |> Diagnostic.here "here")
      [ "error[E0999]: something is wrong"; " --> gone.frob:3:4"; "  | here" ];
    shows "past the end of the file"
      (error (at 12 3 12 4))
      [ "error[E0999]: something is wrong"; "  --> main.frob:12:3"; "   |"; "12 |"; "   |   ^" ];
    Alcotest.test_case "a very long line is cut" `Quick (fun () ->
        let text =
          Render_text.diagnostic ~colour:false source (error (at ~file:"long.frob" 1 5001 1 5002))
        in
        Alcotest.(check bool) "short" true (String.length text < 400);
        Alcotest.(check bool) "shows the place" true (String.contains text '!'));
    shows "a byte order mark is no character"
      (error (at ~file:"marked.frob" 1 4 1 5))
      [ "error[E0999]: something is wrong"; " --> marked.frob:1:1"; "  |"; "1 | x = 1"; "  | ^" ];
    Alcotest.test_case "colour adds only colour" `Quick (fun () ->
        let d = error (at 2 1 2 6) |> Diagnostic.hint "h" in
        let coloured = Render_text.diagnostic ~colour:true source d in
        let plain = Buffer.create 100 in
        let inside = ref false in
        String.iter
          (fun c ->
            if c = '\027' then inside := true
            else if !inside then (if c = 'm' then inside := false)
            else Buffer.add_char plain c)
          coloured;
        Alcotest.(check string)
          "plain"
          (Render_text.diagnostic ~colour:false source d)
          (Buffer.contents plain));
    Alcotest.test_case "the summary counts" `Quick (fun () ->
        let warning = Diagnostic.warning ~code:"W0999" ~at:(at 1 1 1 2) "hm" in
        let e = error (at 1 1 1 2) in
        Alcotest.(check (list string))
          "summaries"
          [ ""; "1 error\n"; "2 errors, 1 warning\n" ]
          (List.map Render_text.summary [ []; [ e ]; [ e; warning; e ] ]));
  ]

(* Cuts off the last field, which repeats the text. *)
let before_rendered text =
  let field = {|"rendered":"|} in
  let n = String.length field in
  let rec find i = if String.sub text i n = field then String.sub text 0 i else find (i + 1) in
  find 0

let json =
  [
    Alcotest.test_case "one object a line" `Quick (fun () ->
        let d =
          error (at 8 5 8 15)
          |> Diagnostic.here "say \"x\""
          |> Diagnostic.label ~at:(at 1 1 1 6) "other"
          |> Diagnostic.note "n" |> Diagnostic.hint "h"
        in
        Alcotest.(check string)
          "json"
          ({|{"message":"something is wrong","code":{"code":"E0999","explanation":null},"level":"error",|}
         ^ {|"spans":[{"file_name":"main.frob","byte_start":95,"byte_end":105,"line_start":8,"line_end":8,|}
         ^ {|"column_start":5,"column_end":10,"is_primary":true,"text":[{"text":"s = \"é日本\" + |}
         ^ {|\u001b[31m + a","highlight_start":5,"highlight_end":10}],"label":"say \"x\""},|}
         ^ {|{"file_name":"main.frob","byte_start":0,"byte_end":5,"line_start":1,"line_end":1,"column_start":1,|}
         ^ {|"column_end":6,"is_primary":false,"text":[{"text":"first = 1","highlight_start":1,"highlight_end":6}],|}
         ^ {|"label":"other"}],"children":[{"message":"n","code":null,"level":"note","spans":[],"children":[],|}
         ^ {|"rendered":null},{"message":"h","code":null,"level":"help","spans":[],"children":[],"rendered":null}],|}
         ^ {|"fixes":[],|})
          (before_rendered (Render_json.diagnostics source [ d ])));
  ]

let () = Alcotest.run "rendering" [ ("text", text); ("json", json) ]
