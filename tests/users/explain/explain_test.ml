(* Tests the pages that explain diagnostics: the faulty example of each page must have exactly
   the code of the page, and the corrected one must have none. Each code that the compiler can
   emit must have a page, and a session that shows its message. *)

let read path =
  let channel = open_in_bin path in
  Fun.protect
    ~finally:(fun () -> close_in channel)
    (fun () -> really_input_string channel (in_channel_length channel))

let library = "../../../stdlib"

let codes (_, diagnostics) =
  List.sort_uniq String.compare (List.map (fun (d : Basis.Diagnostic.t) -> d.code) diagnostics)

let check_page code () =
  let example = Example.find code in
  Alcotest.(check (list string)) "the example" [ code ] (codes (Example.faulty ~library example));
  Alcotest.(check (list string)) "the fixed example" [] (codes (Example.fixed ~library example))

(* Finds the codes in the compiler's sources. *)
let emitted () =
  let pattern text i =
    i + 6 < String.length text
    && text.[i] = '"'
    && (text.[i + 1] = 'E' || text.[i + 1] = 'W')
    && String.for_all (function '0' .. '9' -> true | _ -> false) (String.sub text (i + 2) 4)
    && text.[i + 6] = '"'
  in
  let codes_in path =
    let text = read path in
    List.filter_map
      (fun i -> if pattern text i then Some (String.sub text (i + 1) 5) else None)
      (List.init (String.length text) Fun.id)
  in
  let rec sources path =
    if Sys.is_directory path then
      List.concat_map
        (fun name -> sources (Filename.concat path name))
        (Array.to_list (Sys.readdir path))
    else if Filename.check_suffix path ".ml" && Filename.basename path <> "explain_pages.ml" then
      [ path ]
    else []
  in
  List.sort_uniq String.compare (List.concat_map codes_in (sources "../../../compiler"))

let check_complete () =
  Alcotest.(check (list string)) "codes with a page" (emitted ()) Basis.Explain.codes

let check_sessions () =
  let code name =
    if Filename.check_suffix name ".t" then Some (Filename.chop_suffix name ".t") else None
  in
  let codes = List.filter_map code (Array.to_list (Sys.readdir "../messages/codes")) in
  Alcotest.(check (list string))
    "codes with a session in tests/users/messages/codes" Basis.Explain.codes
    (List.sort String.compare codes)

let () =
  let pages = List.map (fun c -> Alcotest.test_case c `Quick (check_page c)) Basis.Explain.codes in
  Alcotest.run "explain"
    [
      ("pages", pages);
      ( "completeness",
        [
          Alcotest.test_case "every code has a page" `Quick check_complete;
          Alcotest.test_case "every code has a session" `Quick check_sessions;
        ] );
    ]
