let check_label (scope : Scope.t) (label : Syntax.Ir.name) =
  let is_control c = Char.code c < 32 || c = '\127' in
  if String.trim label.text = "" || String.exists is_control label.text then
    Context.report_definition scope.context (Bad_label label.span)

(* Does this name occur in the expression? *)
let rec mentions name (node : Syntax.Node.t) =
  match node with
  | Qualified { qualifier = None; name = { text; _ }; _ } -> String.equal text name
  | Expression { desc = Variable { qualifier = None; name = { text; _ }; _ }; _ }
    when String.equal text name ->
      true
  | _ -> List.exists (mentions name) (Syntax.Node.children node)

let is_a_condition (e : Syntax.Ir.expr) =
  match e.desc with
  | Binary { operator = { name = { text; _ }; _ }; _ } ->
      List.mem text [ "=="; "/="; "<"; "<="; ">"; ">="; "&&"; "||" ]
  | _ -> false

(* Reports `trial name = Trial { … }` and `test name = f 4 == 2`. Without quotes around the label,
   they parse as definitions of a function `trial` or `test`. *)
let check_quotes (scope : Scope.t) ~has_signature (d : Syntax.Ir.declaration) =
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
              name = { text = ("trial" | "test") as kind; _ };
              parameters = [ { desc = Bound label; _ } ];
            };
        right = { body = Plain value; _ };
        _;
      }
    when is_a_check value
         || kind = "test" && is_a_condition value
            && (not (has_signature kind))
            && not (mentions label.text (Expression value)) ->
      Context.report_definition scope.context (Label_without_quotes { label; kind })
  | _ -> ()

let check (scope : Scope.t) (program : Syntax.Ir.program) =
  let has_signature name =
    List.exists
      (fun (d : Syntax.Ir.declaration) ->
        match d.desc with
        | Signature { names; _ } ->
            List.exists (fun (n : Syntax.Ir.name) -> String.equal n.text name) names
        | _ -> false)
      program.declarations
  in
  let rec visit ~in_proc (node : Syntax.Node.t) =
    (match node with
    | Declaration { desc = Claim { kind; label; _ }; span; _ } ->
        if in_proc then check_label scope label
        else Context.report_definition scope.context (Misplaced_claim { at = span; kind })
    | Declaration { desc = Check { label; _ }; _ } -> check_label scope label
    | Declaration d -> check_quotes scope ~has_signature d
    | _ -> ());
    let in_proc = match node with Expression { desc = Proc _; _ } -> true | _ -> false in
    List.iter (visit ~in_proc) (Syntax.Node.children node)
  in
  List.iter (fun d -> visit ~in_proc:false (Declaration d)) program.declarations
