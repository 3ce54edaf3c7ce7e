(* Tests the pages that explain the parser's diagnostics: the faulty example must have exactly
   the code of the page, and the corrected one must parse. (Later stages test its meaning.) *)

open Programs

let block kind page =
  let rec outside = function
    | [] -> None
    | line :: rest -> if line = "```" ^ kind then inside [] rest else outside rest
  and inside text = function
    | [] -> None
    | "```" :: _ -> Some (String.concat "\n" (List.rev ("" :: text)))
    | line :: rest -> inside (line :: text) rest
  in
  outside (String.split_on_char '\n' page)

(* No short example is nested ten thousand levels deep. *)
let without_example = [ "E0106" ]

let check code =
  let page = Option.get (Basis.Explain.find code) in
  let check () =
    (match block "frob-error" page with
    | Some text ->
        Alcotest.(check (list string))
          "the example" [ code ]
          (List.sort_uniq String.compare (codes text))
    | None -> Alcotest.(check bool) "has an example" true (List.mem code without_example));
    match block "frob" page with
    | Some text -> Alcotest.(check (list string)) "the fixed example" [] (codes text)
    | None -> Alcotest.fail "no fixed example"
  in
  Alcotest.test_case code `Quick check

let () =
  let pages = List.filter (String.starts_with ~prefix:"E01") Basis.Explain.codes in
  Alcotest.run "pages on syntax" [ ("pages", List.map check pages) ]
