open Basis

let report_place (scope : Scope.t) kind span =
  Diagnostic.error ~code:"E0234" ~at:span "an `%s` is only allowed among the equations of a `proc`"
    (Labels.word kind)
  |> Diagnostic.hint
       (Printf.sprintf
          "move it into a `proc`, as in `proc x -> y where` with `%s \"label\" (y > 0)` in the \
           lines below"
          (Labels.word kind))
  |> Context.emit scope.context

let check_label (scope : Scope.t) (label : Syntax.Ir.name) =
  let is_control c = Char.code c < 32 || c = '\127' in
  if String.trim label.text = "" || String.exists is_control label.text then
    Diagnostic.error ~code:"E0235" ~at:label.span "this label is empty or contains a line break"
    |> Diagnostic.hint
         "describe in a few words what must hold; the summary of a run shows the label"
    |> Context.emit scope.context

(* `trial name = Trial { … }` without quotes around the label, which parses as the definition of a
   function `trial`. *)
let check_quotes (scope : Scope.t) (d : Syntax.Ir.declaration) =
  let rec is_a_check (e : Syntax.Ir.expr) =
    match e.desc with
    | Record { constructor = { name = { text = "Trial" | "Test"; _ }; _ }; _ } -> true
    | Variable { name = { text = "during" | "trace"; _ }; _ } -> true
    | Apply (head, _) | Parenthesized head -> is_a_check head
    | _ -> false
  in
  match d.desc with
  | Binding
      {
        left =
          Function_name
            {
              name = { text = ("trial" | "test") as word; _ };
              parameters = [ { desc = Bound label; _ } ];
            };
        right = { body = Plain value; _ };
        _;
      }
    when is_a_check value ->
      let text = Printf.sprintf "\"%s\"" label.text in
      Diagnostic.error ~code:"E0235" ~at:label.span "the label of a `%s` must be in quotes" word
      |> Diagnostic.hint (Printf.sprintf "write `%s %s = …`" word text)
      |> Diagnostic.write label.span text |> Context.emit scope.context
  | _ -> ()

let check scope (program : Syntax.Ir.program) =
  let rec visit ~in_proc (node : Syntax.Node.t) =
    (match node with
    | Declaration { desc = Claim { kind; label; _ }; span; _ } ->
        if in_proc then check_label scope label else report_place scope kind span
    | Declaration { desc = Check { label; _ }; _ } -> check_label scope label
    | Declaration d -> check_quotes scope d
    | _ -> ());
    let in_proc = match node with Expression { desc = Proc _; _ } -> true | _ -> false in
    List.iter (visit ~in_proc) (Syntax.Node.children node)
  in
  List.iter (fun d -> visit ~in_proc:false (Declaration d)) program.declarations
