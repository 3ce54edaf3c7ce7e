(* Checks that the library's modules and the example programs pass all checks without a warning. *)

open Basis

let stdlib = "../../../stdlib"

let diagnostics file =
  let sink = Diagnostic.sink () in
  let remember ~file:_ _ = () in
  (match
     Resolve.Program.load (Advice.Of_resolve.into sink) ~files:Resolve.Files.on_disk ~remember
       ~library:stdlib file
   with
  | None -> ()
  | Some resolved ->
      Resolve.Lint.program resolved;
      let facts = Advice.Of_typing.into sink in
      ignore (Typing.Of_resolved.program facts ~real:Double resolved));
  List.map
    (fun (d : Diagnostic.t) ->
      Format.asprintf "%a: %s: %s" Span.pp d.at d.code (Diagnostic.for_display d.message))
    (Diagnostic.all sink)

let check file =
  Alcotest.test_case (Filename.basename file) `Quick (fun () ->
      Alcotest.(check (list string)) "nothing to say" [] (diagnostics file))

let () =
  let modules =
    List.map
      (fun name -> Filename.concat stdlib (name ^ ".frob"))
      (Resolve.Files.on_disk.modules_in stdlib)
  in
  Alcotest.run "library"
    [
      ("modules", List.map check modules);
      ( "examples",
        [
          check "../../../examples/wall_follow/wall_follow.frob";
          check "../../../examples/heading_hold/heading_hold.frob";
        ] );
    ]
