open Basis

let verdict : Ir.Global.t = { module_ = "Prelude"; name = "verdict" }
let word : Syntax.Ir.claim -> string = function Assert -> "assert" | Assume -> "assume"
let name kind label = word kind ^ " " ^ label
let width = String.length (name Assert "")
let is_kind kind text = String.starts_with ~prefix:(name kind "") text
let is_assumption = is_kind Assume
let is_name text = is_kind Assert text || is_assumption text

let label text =
  if is_name text then Some (String.sub text width (String.length text - width)) else None

(* {1 Tests} *)

let check_word : Syntax.Ir.check -> string = function Test -> "test" | Trial -> "trial"
let check_type : Syntax.Ir.check -> string = function Test -> "Test" | Trial -> "Trial"
let check_name kind label = check_word kind ^ " " ^ label
let judge_of = "judge "
let judge name = judge_of ^ name

let is_measuring (g : Ir.Global.t) =
  g.module_ = "Trial" && List.mem g.name [ "meanOf"; "largestOf"; "smallestOf"; "lastOf" ]

let of_tests = "Trial"
let holding : Ir.Global.t = { module_ = of_tests; name = "holding" }

(* A qualifier that cannot occur in source code, so that no name of the program hides the imported
   ones. *)
let qualifier = "library " ^ of_tests

let of_library text (span : Span.t) : Syntax.Ir.qualified =
  { qualifier = Some { text = qualifier; span }; name = { text; span }; span }

let is_check (d : Syntax.Ir.declaration) = match d.desc with Check _ -> true | _ -> false

let import (program : Syntax.Ir.program) : Syntax.Ir.import option =
  if List.exists is_check program.declarations then
    let span = Span.start_of_file program.file in
    let named text : Syntax.Ir.name = { text; span } in
    Some
      {
        module_ = named of_tests;
        qualified = true;
        alias = Some (named qualifier);
        items = None;
        span;
      }
  else None

let kind_of_check text =
  let of_kind kind =
    let prefix = check_name kind "" in
    let n = String.length prefix in
    if String.starts_with ~prefix text then Some (kind, String.sub text n (String.length text - n))
    else None
  in
  match of_kind Test with Some found -> Some found | None -> of_kind Trial

let checked (d : Syntax.Ir.declaration) : (Syntax.Ir.name * Syntax.Ir.expr) list =
  match d.desc with
  | Check { kind; label; value } ->
      let span = label.span in
      let named text : Syntax.Ir.name = { text; span } in
      let name = check_name kind label.text in
      let whole : Syntax.Ir.qualified = { qualifier = None; name = named name; span } in
      let record : Syntax.Ir.expr = { desc = Variable whole; span } in
      let field : Syntax.Ir.expr = { desc = Field { record; field = named "judge" }; span } in
      let value : Syntax.Ir.expr =
        match kind with
        | Trial -> value
        | Test ->
            let function_ = of_library holding.name span in
            let head : Syntax.Ir.expr = { desc = Variable function_; span } in
            { desc = Apply (head, value); span = value.span }
      in
      [ (named name, value); (named (judge name), field) ]
  | _ -> []

let check_signature (d : Syntax.Ir.declaration) : (Syntax.Ir.name * Syntax.Ir.qualified_type) list =
  match d.desc with
  | Check { kind; label = { text; span }; _ } ->
      let name = of_library (check_type kind) span in
      let ty : Syntax.Ir.ty = { desc = Type { name; units = None; arguments = [] }; span } in
      [ ({ text = check_name kind text; span }, { context = []; ty }) ]
  | _ -> []
