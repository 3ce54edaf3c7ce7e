open Basis

type setting = { name : string; text : string }

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

(* The names by which a command line can refer to the parameter. *)
let names (m : Modules.t) (name : Syntax.Ir.name) = [ name.text; m.name ^ "." ^ name.text ]

let report context setting problem =
  let at = Span.start_of_file (file_of setting) in
  Context.report context (Setting { name = setting.name; at; problem })

(* The module of the parameter that the setting refers to. A parameter of the program's own module
   takes precedence over imported ones. *)
let owner context modules setting =
  let has (m : Modules.t) = List.exists (fun n -> List.mem setting.name (names m n)) (declared m) in
  match List.filter has (List.rev modules) with
  | [] ->
      let own (m : Modules.t) = List.map (fun (n : Syntax.Ir.name) -> n.text) (declared m) in
      report context setting (No_parameter { known = List.concat_map own modules });
      None
  | main :: _ when main == List.hd (List.rev modules) -> Some main
  | [ owner ] -> Some owner
  | several ->
      let qualified (m : Modules.t) = m.name ^ "." ^ setting.name in
      report context setting (Several_modules { qualified = List.map qualified several });
      None

(* Parses the setting as a definition whose name is a placeholder. The placeholder is as wide as the
   setting's name, so that spans also match the text shown in diagnostics. *)
let expression context setting =
  let width = String.length setting.name in
  let value =
    (* hosts and recordings write these values in lower case *)
    match String.trim setting.text with
    | "true" -> "True"
    | "false" -> "False"
    | _ -> setting.text
  in
  let text = "x" ^ String.make (max 0 (width - 1)) '_' ^ "= " ^ value in
  match Context.parse context ~file:(file_of setting) text with
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
      report context setting (Invalid_value { value = String.trim setting.text });
      None
  | None -> None

let set context ~remember modules setting =
  remember ~file:(file_of setting) (setting.name ^ "= " ^ setting.text);
  match owner context modules setting with
  | None -> modules
  | Some owner -> (
      match expression context setting with
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

let give context ~remember settings modules =
  List.fold_left (set context ~remember) modules settings

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
