open Basis

type setting = { name : string; text : string }

let no_such = "E0507"

let split text =
  match String.index_opt text '=' with
  | None | Some 0 -> None
  | Some i ->
      let rest = String.sub text (i + 1) (String.length text - i - 1) in
      Some { name = String.trim (String.sub text 0 i); text = rest }

let file_of setting = "--param " ^ setting.name
let is_given name = String.contains name '='
let given name = name ^ "="
let shown name = if is_given name then String.sub name 0 (String.index name '=') else name

let declared (m : Modules.t) =
  List.filter_map
    (fun (d : Syntax.Ir.declaration) ->
      match d.desc with Parameter p when not (is_given p.name.text) -> Some p.name | _ -> None)
    m.syntax.declarations

(* The names that a command line can use for the parameter. *)
let names (m : Modules.t) (name : Syntax.Ir.name) = [ name.text; m.name ^ "." ^ name.text ]

let report sink setting ?note ?hint format =
  let at = Span.start_of_file (file_of setting) in
  Printf.ksprintf
    (fun text ->
      Diagnostic.error ~code:no_such ~at "%s" text
      |> Option.fold ~none:Fun.id ~some:Diagnostic.note note
      |> Option.fold ~none:Fun.id ~some:Diagnostic.hint hint
      |> Diagnostic.emit sink)
    format

let report_unknown sink setting modules =
  let own (m : Modules.t) = List.map (fun (n : Syntax.Ir.name) -> n.text) (declared m) in
  let all = List.concat_map own modules in
  let quoted = List.map (Printf.sprintf "`%s`") (List.sort_uniq String.compare all) in
  let note =
    if all = [] then "the program has no parameters; declare one by `param NAME :: TYPE = VALUE`"
    else "the program has " ^ Enumeration.all quoted
  in
  let hint = Option.map (Printf.sprintf "did you mean `%s`?") (Suggest.closest setting.name all) in
  report sink setting ~note ?hint "the program has no parameter `%s`" setting.name

(* The module whose parameter the setting refers to. A parameter of the program's own module takes
   precedence over imported ones. *)
let owner sink modules setting =
  let has (m : Modules.t) = List.exists (fun n -> List.mem setting.name (names m n)) (declared m) in
  match List.filter has (List.rev modules) with
  | [] ->
      report_unknown sink setting modules;
      None
  | main :: _ when main == List.hd (List.rev modules) -> Some main
  | [ owner ] -> Some owner
  | several ->
      let qualified (m : Modules.t) = Printf.sprintf "`%s.%s`" m.name setting.name in
      report sink setting "several modules have a parameter `%s`" setting.name
        ~hint:
          ("write the name of its module too: " ^ Enumeration.one_of (List.map qualified several));
      None

(* In diagnostics, the span of the value covers the whole setting. Replacing the name with a
   placeholder of the same width turns the setting into a definition. *)
let expression sink setting =
  let width = String.length setting.name in
  let value =
    (* the spelling that hosts and recordings use *)
    match String.trim setting.text with
    | "true" -> "True"
    | "false" -> "False"
    | _ -> setting.text
  in
  let text = "x" ^ String.make (max 0 (width - 1)) '_' ^ "= " ^ value in
  match Syntax.Parse.program sink ~file:(file_of setting) text with
  | Some
      {
        declarations =
          [ { desc = Binding { left = Name _; right = { body = Plain e; where = [] }; _ }; _ } ];
        header = None;
        imports = [];
        file = _;
      } ->
      Some e
  | Some _ ->
      report sink setting "`%s` is not an expression" (String.trim setting.text)
        ~hint:(Printf.sprintf "write the value as in `--param %s=5`" setting.name);
      None
  | None -> None

let set sink ~remember modules setting =
  remember ~file:(file_of setting) (setting.name ^ "= " ^ setting.text);
  match owner sink modules setting with
  | None -> modules
  | Some owner -> (
      match expression sink setting with
      | None -> modules
      | Some value ->
          let is_it (d : Syntax.Ir.declaration) =
            match d.desc with
            | Parameter p -> List.mem setting.name (names owner p.name)
            | _ -> false
          in
          let beside (d : Syntax.Ir.declaration) : Syntax.Ir.declaration =
            match d.desc with
            | Parameter p ->
                let name : Syntax.Ir.name = { p.name with text = given p.name.text } in
                { d with desc = Parameter { p with name; value }; span = value.span }
            | _ -> d
          in
          let is_same (d : Syntax.Ir.declaration) (e : Syntax.Ir.declaration) =
            match (d.desc, e.desc) with
            | Parameter p, Parameter q -> String.equal p.name.text q.name.text
            | _ -> false
          in
          let own = owner.syntax.declarations in
          let added = beside (List.find is_it own) in
          let others = List.filter (fun d -> not (is_same added d)) own in
          let syntax = { owner.syntax with declarations = others @ [ added ] } in
          List.map
            (fun (m : Modules.t) -> if String.equal m.name owner.name then { m with syntax } else m)
            modules)

let give sink ~remember settings modules = List.fold_left (set sink ~remember) modules settings

let of_modules modules =
  let of_module (m : Modules.t) =
    let parameters = String_table.create 16 in
    List.iter
      (fun (d : Syntax.Ir.declaration) ->
        match d.desc with Parameter p -> String_table.replace parameters p.name.text () | _ -> ())
      m.syntax.declarations;
    let has_given (name : Syntax.Ir.name) = String_table.mem parameters (given name.text) in
    let global name : Ir.Global.t = { module_ = m.name; name } in
    List.map
      (fun (name : Syntax.Ir.name) : Ir.param ->
        {
          param = global name.text;
          given = (if has_given name then Some (global (given name.text)) else None);
          span = name.span;
        })
      (declared m)
  in
  List.concat_map of_module modules
