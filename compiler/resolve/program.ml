open Basis
open Interface

(* A resolved module. *)
type resolved = {
  info : Ir.module_;
  types : Ir.type_declaration list;
  units : Ir.unit_declaration list;
  primitives : Ir.primitive list;
  groups : Ir.binding_group list;
  classes : Ir.class_ list;
  instances : Ir.instance list;
}

(* The names that each library module declares or re-exports, for hints about missing imports. Reads
   the library on first use. *)
let library_names ~(files : Files.t) ~library =
  let read module_ =
    match files.read (Filename.concat library (module_ ^ ".frob")) with
    | Error _ -> None
    | Ok text ->
        let context = Context.create (Facts.ignored ()) in
        Option.map
          (fun (syntax : Syntax.Ir.program) ->
            let own = Declared.program context ~module_ syntax in
            (module_, own, Option.bind syntax.header (fun header -> header.exports)))
          (Context.parse context ~file:module_ text)
  in
  let names_of modules =
    let everything = List.fold_left (fun all (_, own, _) -> union all own) (none ()) modules in
    List.map
      (fun (module_, own, exports) ->
        match exports with
        | None -> { Visible.module_; names = own; gathers = false }
        | Some listed ->
            { Visible.module_; names = select everything (Exports.texts listed); gathers = true })
      modules
  in
  lazy (names_of (List.filter_map read (files.modules_in library)))

let primitives (scope : Scope.t) (program : Syntax.Ir.program) =
  let report name = Context.report scope.context (In_modules (Primitive_outside_library name)) in
  let primitive scheme doc (name : Syntax.Ir.name) : Ir.primitive =
    if not scope.library then report name;
    let global : Ir.Global.t = { module_ = scope.visible.module_; name = name.text } in
    { name = global; scheme; foreign = None; doc; span = name.span }
  in
  let declaration (d : Syntax.Ir.declaration) =
    match d.desc with
    | Primitive { names; ty } -> Long_list.map (primitive (Types.scheme scope ty) d.doc) names
    | Foreign (Foreign_value { kind; name; ty; symbol }) ->
        Foreign_code.check_symbol scope ~kind symbol;
        if Interface.is_operator name.text then Bindings.report_operator scope name;
        let scheme = Types.scheme scope ty in
        let global : Ir.Global.t = { module_ = scope.visible.module_; name = name.text } in
        let foreign = Some { Ir.kind; symbol = symbol.text } in
        [ { Ir.name = global; scheme; foreign; doc = d.doc; span = name.span } ]
    | Signature _ | Binding _ | Type_alias _ | Data _ | Base_unit _ | Scaled_unit _ | Class _
    | Instance _ | Parameter _ | Claim _ | Check _
    | Foreign (Foreign_type _ | Foreign_include _) ->
        []
  in
  List.concat_map declaration program.declarations

let includes (scope : Scope.t) (program : Syntax.Ir.program) =
  let declaration (d : Syntax.Ir.declaration) =
    match d.desc with
    | Foreign (Foreign_include header) ->
        Foreign_code.check_header scope header;
        Some header.text
    | _ -> None
  in
  List.filter_map declaration program.declarations

(* The imports of a test file's program, and a qualified import of the program itself, including the
   names that the program does not export. *)
let seen_in_tests (program : Scope.t) : Visible.import list =
  let visible = program.visible in
  let module_ = visible.module_ in
  let qualified : Visible.import =
    { module_; qualifiers = [ module_ ]; unqualified = false; names = visible.own }
  in
  qualified :: visible.imports

(* [exports] and [scopes] contain the modules that were resolved before this one. *)
let resolve context ~elsewhere exports scopes (m : Modules.t) =
  let program = Option.bind m.program (fun name -> String_map.find_opt name scopes) in
  let after = Option.map (fun (program : Scope.t) -> program.visible.own) program in
  let own = Declared.program context ~module_:m.name ?after m.syntax in
  let known (i : Modules.import) =
    Option.map (fun names -> (i, names)) (String_map.find_opt i.module_ exports)
  in
  let imports = List.filter_map known m.imports in
  let import ((i : Modules.import), names) =
    Exports.imported context i.declaration ~module_:i.module_ names
  in
  let scope =
    let imports = List.map import imports @ Option.fold program ~none:[] ~some:seen_in_tests in
    let complete =
      m.complete && Option.fold program ~none:true ~some:(fun (p : Scope.t) -> p.complete)
    in
    Scope.create context ~library:m.library ~complete
      (Visible.create ~text:m.text ~module_:m.name ~own ~imports ~elsewhere ~syntax:m.syntax)
  in
  let exported = Exports.of_module scope m.syntax.header in
  let units = Declarations.units scope m.syntax in
  let types = Declarations.types scope m.syntax in
  let primitives = primitives scope m.syntax in
  Foreign_code.check_includes scope m.syntax;
  if not m.library then Claims.check scope m.syntax;
  let groups =
    Bindings.top_level scope ~expr:Expressions.expr ~command:Expressions.command
      m.syntax.declarations
  in
  let env = Env.of_module scope in
  let classes = Classes.classes env ~expr:Expressions.expr ~command:Expressions.command m.syntax in
  let instances =
    Classes.instances env ~expr:Expressions.expr ~command:Expressions.command m.syntax
  in
  Context.tell context scope.visible;
  let idle ((i : Modules.import), names) =
    Exports.idle scope i.declaration ~module_:i.module_ names
  in
  let whole (i : Syntax.Ir.import) =
    if i.qualified || i.items <> None then None else Some i.module_.text
  in
  let info : Ir.module_ =
    {
      name = m.name;
      file = m.file;
      library = m.library;
      includes = includes scope m.syntax;
      idle_imports = List.concat_map idle imports;
      imported = List.filter_map whole m.syntax.imports;
      imports = List.map (fun (i : Syntax.Ir.import) -> i.module_.text) m.syntax.imports;
      import_place = Context.import_place m.syntax;
    }
  in
  (scope, exported, { info; types; units; primitives; groups; classes; instances })

let assemble ~params modules : Ir.program option =
  match List.rev modules with
  | [] -> None
  | main :: _ ->
      Some
        {
          main_module = main.info.name;
          modules = Long_list.map (fun m -> m.info) modules;
          types = List.concat_map (fun m -> m.types) modules;
          units = List.concat_map (fun m -> m.units) modules;
          primitives = List.concat_map (fun m -> m.primitives) modules;
          groups = List.concat_map (fun m -> m.groups) modules;
          classes = List.concat_map (fun m -> m.classes) modules;
          instances = List.concat_map (fun m -> m.instances) modules;
          params;
        }

let load facts ~files ~remember ~library ?also ?(given = []) ?(partial = false) main =
  let context = Context.create facts in
  let modules = Modules.load context ~files ~remember ~library ?also main in
  let modules = Parameters.give context ~remember given modules in
  let elsewhere = library_names ~files ~library in
  let add (exports, scopes, reversed) (m : Modules.t) =
    let scope, exported, resolved = resolve context ~elsewhere exports scopes m in
    ( String_map.add m.name exported exports,
      String_map.add m.name scope scopes,
      resolved :: reversed )
  in
  let _, _, reversed = List.fold_left add (String_map.empty, String_map.empty, []) modules in
  if Context.has_errors context && not partial then None
  else assemble ~params:(Parameters.of_modules modules) (List.rev reversed)
