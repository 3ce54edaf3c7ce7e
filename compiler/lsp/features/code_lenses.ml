open Basis

let operations cost =
  List.fold_left (fun n (_, kind) -> n + Report.Cost.count cost kind) 0 Report.Bounds.operations
  + List.fold_left (fun n (_, calls) -> n + calls) 0 (Report.Cost.calls cost)

let plural n noun = Printf.sprintf "%d %s%s" n noun (if n = 1 then "" else "s")

let needs (bounds : Report.Bounds.t) =
  let state = Report.State.definition bounds.state (Report.State.root bounds.state) in
  Printf.sprintf "%s of state, at most %s in a step" (plural state.bytes "byte")
    (plural (operations bounds.operations.step) "operation")

let lens range title command arguments : Json.t =
  Object
    [
      ("range", range);
      ( "command",
        Object
          [
            ("title", String title);
            ("command", String command);
            ("arguments", List (List.map (fun text -> Json.String text) arguments));
          ] );
    ]

let bounds ws (doc : Document.t) =
  let files = { Build.Program_file.files with read = Workspace.read ws } in
  let request = { (Build.Request.make ~library:ws.library doc.path) with files } in
  Option.map Report.Bounds.of_program
    (Build.Queries.step (Diagnostic.sink ()) (Source.create ()) request)

(* A program that does not specify its robot is incomplete: it cannot be run, and its costs are
   unknown. *)
let of_main ws (doc : Document.t) view range =
  let report =
    match bounds ws doc with
    | Some bounds -> [ lens range (needs bounds) "frob.report" [ doc.path ] ]
    | None -> [ lens range "report" "frob.report" [ doc.path ] ]
  in
  let is_robot =
    match View.facts view with
    | None -> false
    | Some facts -> (
        let main : Resolve.Ir.Global.t =
          { module_ = (View.program view).main_module; name = "main" }
        in
        match Place_types.global facts main with
        | Some { ty = Data { tycon = { name = "Program"; _ }; _ }; _ } -> true
        | Some _ | None -> false)
  in
  let run =
    if is_robot && Uri.is_file doc.uri then
      [ lens range "run in the simulator" "frob.run" [ doc.path ] ]
    else []
  in
  report @ run

let answer ws (doc : Document.t) : Json.t =
  match (doc.typed, doc.latest) with
  | Some { view; since }, Some { typed = Some _; _ } ->
      let seen = View.seen view doc.text since in
      let of_declaration (d : Syntax.Ir.declaration) =
        let above = Option.value (View.range seen d.span) ~default:(0, 0) in
        let range = Workspace.range ws doc.text (fst above, fst above) in
        match d.desc with
        | Binding { left = Name n | Function_name { name = n; _ }; _ } when n.text = "main" ->
            of_main ws doc view range
        | Check { kind; label; _ } when Uri.is_file doc.uri ->
            let title = match kind with Test -> "run this test" | Trial -> "run this trial" in
            [ lens range title "frob.test" [ doc.path; label.text ] ]
        | _ -> []
      in
      List (List.concat_map of_declaration (View.tree view).declarations)
  | _ -> List []
