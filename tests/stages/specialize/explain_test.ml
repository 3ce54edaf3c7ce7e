(* Tests the pages that explain the specializer's diagnostics: the faulty example must have
   exactly the code of the page, and the corrected one none. *)

open Basis

let library = "../../../stdlib"

(* The lines from a fence with this word to the next fence. *)
let block word page =
  let rec skip = function
    | [] -> failwith ("no block " ^ word)
    | line :: rest -> if String.equal line ("```" ^ word) then take [] rest else skip rest
  and take lines = function
    | [] | "```" :: _ -> String.concat "\n" (List.rev ("" :: lines))
    | line :: rest -> take (line :: lines) rest
  in
  skip (String.split_on_char '\n' page)

let codes text =
  let on_disk = Resolve.Files.on_disk in
  let read path = if String.equal path "main.frob" then Ok text else on_disk.read path in
  let sink = Diagnostic.sink () in
  let files = { on_disk with read } in
  ignore (Pipeline.flow sink (Source.create ()) ~files ~library "main.frob");
  List.sort_uniq String.compare (List.map (fun (d : Diagnostic.t) -> d.code) (Diagnostic.all sink))

let check_page code () =
  let page = Option.get (Explain.find code) in
  Alcotest.(check (list string)) "the example" [ code ] (codes (block "frob-error" page));
  Alcotest.(check (list string)) "the fixed example" [] (codes (block "frob" page))

let () =
  let page code = Alcotest.test_case code `Quick (check_page code) in
  Alcotest.run "explain" [ ("pages", List.map page [ "E0410"; "E0412"; "E0413"; "E0414" ]) ]
