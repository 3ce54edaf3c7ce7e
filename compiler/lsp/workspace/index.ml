open Basis
module Global = Resolve.Ir.Global

type what =
  | Local
  | Value of Global.t
  | Constructor of Global.t
  | Type of Global.t
  | Class of Global.t
  | Unit of Global.t
  | Field of { record : string }
  | Module

type symbol = { name : string; what : what; at : Span.t }
type occurrence = { place : Span.t; symbol : symbol; declares : bool }
type t = occurrence array

let same a b = Span.compare a.at b.at = 0 && String.equal a.name b.name

(* {1 Declarations of modules} *)

let declared_in cache sources file : Mentions.declared =
  match Source.text sources file with
  | None -> Hashtbl.create 1
  | Some text ->
      Text_cache.find cache ~path:file text (fun _ ->
          let tree =
            match Prepared.Library.tree ~file text with
            | Some tree -> Some tree
            | None -> Syntax.Parse.program (Facts.ignored ()) ~file text
          in
          Option.fold tree ~none:(Hashtbl.create 1) ~some:(fun tree ->
              Mentions.declared (Mentions.of_program tree)))

(* {1 Results of name resolution} *)

type meant = {
  values : [ `Local of Resolve.Ir.Local.t | `Global of Global.t ] Place_table.t;
  constructors : Global.t Place_table.t;
  types : Global.t Place_table.t;
  classes : Global.t Place_table.t;
  candidates : Global.t list Place_table.t;  (** the types that may have this field *)
}

let place = Place_table.place

let rec ty meant (t : Resolve.Ir.ty) =
  match t.desc with
  | Type_variable _ | Representation _ | Size _ -> ()
  | Named { tycon; arguments; _ } ->
      Place_table.replace meant.types (place t.span) tycon;
      List.iter (ty meant) arguments
  | Function (a, b) ->
      ty meant a;
      ty meant b
  | Tuple_type ts -> List.iter (ty meant) ts

let scheme meant (s : Resolve.Ir.scheme) =
  List.iter
    (fun (c : Resolve.Ir.constraint_) ->
      Place_table.replace meant.classes (c.span.start, c.span.start) c.class_;
      ty meant c.argument)
    s.context;
  ty meant s.ty

let declarations meant (ds : Resolve.Ir.declarations) =
  List.iter (fun (_, s) -> scheme meant s) ds.signatures

let rec pattern meant (p : Resolve.Ir.pattern) =
  match p.desc with
  | Any | Bound _ | Literal _ -> ()
  | As (_, p) -> pattern meant p
  | Tuple_of ps | Array_of ps -> List.iter (pattern meant) ps
  | Constructed (c, ps) ->
      Place_table.replace meant.constructors (place p.span) c;
      List.iter (pattern meant) ps

let rec expr meant (e : Resolve.Ir.expr) =
  (match e.desc with
  | Local l -> Place_table.replace meant.values (place e.span) (`Local l)
  | Global g -> Place_table.replace meant.values (place e.span) (`Global g)
  | Constructor c | Record { constructor = c; _ } ->
      Place_table.replace meant.constructors (place e.span) c
  | Field { candidates; _ } | Update { candidates; _ } ->
      Place_table.replace meant.candidates (place e.span) candidates
  | Annotated { scheme = s; _ } -> scheme meant s
  | Case { branches; _ } ->
      List.iter (fun (b : Resolve.Ir.branch) -> declarations meant b.right.where) branches
  | Let { declarations = ds; _ } | Proc { body = { equations = ds; _ }; _ } -> declarations meant ds
  | Sequence { statements; _ } ->
      List.iter (function Resolve.Ir.Values ds -> declarations meant ds | Task _ -> ()) statements
  | _ -> ());
  Resolve.Walk.expr (visitor meant) e

and binding meant (b : Resolve.Ir.binding) =
  Option.iter (scheme meant) b.signature;
  (match b.name with Destructure p -> pattern meant p | Top _ | Inner _ -> ());
  declarations meant b.body.where;
  Resolve.Walk.binding (visitor meant) b

and visitor meant : Resolve.Walk.visitor =
  { expr = expr meant; pattern = pattern meant; binding = binding meant }

let meant_by (program : Resolve.Ir.program) ~main =
  let meant =
    {
      values = Place_table.create 1024;
      constructors = Place_table.create 256;
      types = Place_table.create 256;
      classes = Place_table.create 64;
      candidates = Place_table.create 64;
    }
  in
  let is_here (g : Global.t) = String.equal g.module_ main in
  List.iter (binding meant)
    (List.filter
       (fun (b : Resolve.Ir.binding) -> match b.name with Top (g, _) -> is_here g | _ -> true)
       (Resolve.Walk.own program));
  List.iter
    (fun (t : Resolve.Ir.type_declaration) ->
      if is_here t.tycon then
        match t.definition with
        | Alias t -> ty meant t
        | Data constructors ->
            List.iter
              (fun (c : Resolve.Ir.constructor) ->
                List.iter (fun (f : Resolve.Ir.field) -> ty meant f.ty) c.fields)
              constructors
        | Builtin | Foreign _ -> ())
    program.types;
  List.iter
    (fun (p : Resolve.Ir.primitive) -> if is_here p.name then scheme meant p.scheme)
    program.primitives;
  List.iter
    (fun (c : Resolve.Ir.class_) ->
      if is_here c.class_ then (
        List.iter (fun (m : Resolve.Ir.method_) -> scheme meant m.scheme) c.methods;
        List.iter
          (fun (class_, (at : Span.t)) ->
            Place_table.replace meant.classes (at.start, at.start) class_)
          c.superclasses))
    program.classes;
  List.iter
    (fun (i : Resolve.Ir.instance) ->
      Place_table.replace meant.classes (i.span.start, i.span.start) i.class_;
      List.iter
        (fun (c : Resolve.Ir.constraint_) ->
          Place_table.replace meant.classes (c.span.start, c.span.start) c.class_;
          ty meant c.argument)
        i.context;
      ty meant i.head)
    program.instances;
  meant

(* For each record whose fields are accessed or updated, its constructor, which type checking
   determines. *)
let records (typed : Typing.Ir.program) ~main =
  let table = Place_table.create 64 in
  let rec visit (e : Typing.Ir.expr) =
    (match e.desc with
    | Field (_, c, _) | Update (_, c, _) ->
        Place_table.replace table (place e.span) c.constructor.name
    | _ -> ());
    Typing.Walk.parts visit e
  in
  List.iter
    (fun (d : Typing.Ir.definition) -> if String.equal d.name.module_ main then visit d.value)
    typed.definitions;
  table

(* {1 The index} *)

(* The tables in which the declarations and uses of names are looked up. *)
type lookup = {
  program : Resolve.Ir.program;
  main : string;
  sources : Source.t;
  meant : meant;
  records : string Place_table.t;
  own : Mentions.declared;  (** the declarations of the text itself *)
  tables : (string, Mentions.declared) Hashtbl.t;
      (** the declarations of other modules, read when first needed *)
  cache : Mentions.declared Text_cache.t;
}

let module_named lookup name =
  List.find_opt (fun (m : Resolve.Ir.module_) -> String.equal m.name name) lookup.program.modules

(* The declarations of a module. *)
let declared lookup module_ =
  if String.equal module_ lookup.main then lookup.own
  else
    match Hashtbl.find_opt lookup.tables module_ with
    | Some table -> table
    | None ->
        let table =
          Option.fold (module_named lookup module_) ~none:(Hashtbl.create 1)
            ~some:(fun (m : Resolve.Ir.module_) -> declared_in lookup.cache lookup.sources m.file)
        in
        Hashtbl.replace lookup.tables module_ table;
        table

let nowhere = Span.start_of_file ""
let global lookup name : Global.t = { module_ = lookup.main; name }

(* {2 Symbols} *)

let symbol lookup space what (g : Global.t) =
  let at = Hashtbl.find_opt (declared lookup g.module_) (space, g.name, None) in
  { name = g.name; what; at = Option.value at ~default:nowhere }

let field lookup record name =
  let with_field (m : Resolve.Ir.module_) =
    Hashtbl.find_opt (declared lookup m.name) (Mentions.Field, name, Some record)
  in
  Option.map
    (fun at -> { name; what = Field { record }; at })
    (List.find_map with_field (List.rev lookup.program.modules))

let unit_ lookup name =
  let named (u : Resolve.Ir.unit_declaration) = String.equal u.unit_name.name name in
  let all = List.filter named lookup.program.units in
  let here (u : Resolve.Ir.unit_declaration) = String.equal u.unit_name.module_ lookup.main in
  match (List.find_opt here all, all) with
  | Some u, _ | None, u :: _ -> Some (symbol lookup Unit (Unit u.unit_name) u.unit_name)
  | None, [] -> None

let in_space (space : Mentions.space) (g : Global.t) =
  match space with
  | Value -> Value g
  | Type -> Type g
  | Class -> Class g
  | Unit -> Unit g
  | Constructor | Field -> Constructor g

(* Tries all namespaces, because the name in an import or export list can be in any of them. *)
let exported lookup module_ name =
  let spaces : Mentions.space list = [ Value; Type; Class; Unit; Constructor ] in
  let of_module module_ =
    List.find_map
      (fun space ->
        Option.map
          (fun at -> { name; what = in_space space { module_; name }; at })
          (Hashtbl.find_opt (declared lookup module_) (space, name, None)))
      spaces
  in
  match of_module module_ with
  | Some symbol -> Some symbol
  | None -> List.find_map (fun (m : Resolve.Ir.module_) -> of_module m.name) lookup.program.modules

let value lookup name within =
  match Place_table.find_opt lookup.meant.values (place within) with
  | Some (`Local (l : Resolve.Ir.Local.t)) -> Some { name = l.name; what = Local; at = l.span }
  | Some (`Global g) -> Some (symbol lookup Value (Value g) g)
  | None when Hashtbl.mem lookup.own (Value, name, None) ->
      let g = global lookup name in
      Some (symbol lookup Value (Value g) g)
  | None -> None

let constructor lookup within = Place_table.find_opt lookup.meant.constructors (place within)

let used lookup space (name : Syntax.Ir.qualified) (within : Span.t) =
  let symbol_of space global =
    Option.map (fun g -> symbol lookup space (in_space space g) g) global
  in
  match (space : Mentions.space) with
  | Value -> value lookup name.name.text within
  | Constructor -> symbol_of Constructor (constructor lookup within)
  | Type -> symbol_of Type (Place_table.find_opt lookup.meant.types (place within))
  | Class ->
      symbol_of Class (Place_table.find_opt lookup.meant.classes (within.start, within.start))
  | Unit -> unit_ lookup name.name.text
  | Field -> None

(* The constructor of this type that has this field. *)
let constructor_with lookup (name : Syntax.Ir.name) tycon =
  let is_it (t : Resolve.Ir.type_declaration) = t.tycon = tycon in
  let has (c : Resolve.Ir.constructor) =
    List.exists (fun (f : Resolve.Ir.field) -> f.field_name = name.text) c.fields
  in
  match List.find_opt is_it lookup.program.types with
  | Some { definition = Data cs; _ } ->
      Option.map (fun (c : Resolve.Ir.constructor) -> c.constructor.name) (List.find_opt has cs)
  | Some { definition = Alias _ | Builtin | Foreign _; _ } | None -> None

(* The constructor of the record whose field is accessed. *)
let record_of lookup name within =
  match (constructor lookup within, Place_table.find_opt lookup.records (place within)) with
  | Some g, _ -> Some g.name
  | None, Some record -> Some record
  | None, None -> (
      match Place_table.find_opt lookup.meant.candidates (place within) with
      | Some [ only ] -> constructor_with lookup name only
      | Some _ | None -> None)

(* {2 Occurrences} *)

let here ?(declares = false) (name : Syntax.Ir.name) symbol =
  Option.to_list (Option.map (fun symbol -> { place = name.span; symbol; declares }) symbol)

let declaration lookup space (name : Syntax.Ir.name) record =
  let what =
    match (space : Mentions.space) with
    | Field -> Field { record = Option.value record ~default:"" }
    | Value | Constructor | Type | Class | Unit -> in_space space (global lookup name.text)
  in
  here ~declares:true name (Some { name = name.text; what; at = name.span })

let import lookup (module_ : Syntax.Ir.name) items =
  let target (m : Resolve.Ir.module_) =
    { name = m.name; what = Module; at = Span.start_of_file m.file }
  in
  here module_ (Option.map target (module_named lookup module_.text))
  @ List.concat_map
      (fun (item : Syntax.Ir.name) -> here item (exported lookup module_.text item.text))
      items

let occurrences lookup : Mentions.mention -> occurrence list = function
  | Declares (space, name, record) -> declaration lookup space name record
  | Binds name -> here ~declares:true name (Some { name = name.text; what = Local; at = name.span })
  | Signs { name; binder = Some b } ->
      let is_own = Hashtbl.find_opt lookup.own (Value, b.text, None) = Some b.span in
      let what = if is_own then Value (global lookup b.text) else Local in
      here name (Some { name = name.text; what; at = b.span })
  | Signs { binder = None; _ } -> []
  | Uses { space; name; within } -> here name.name (used lookup space name within)
  | Selects { field = name; within } ->
      let record = record_of lookup name within in
      here name (Option.bind record (fun record -> field lookup record name.text))
  | Imports { module_; items } -> import lookup module_ items
  | Exports name -> here name (exported lookup lookup.main name.text)
  | Local _ -> []

let of_analysis cache (a : Analysis.t) ~typed (tree : Syntax.Ir.program) : t =
  match a.resolved with
  | None -> [||]
  | Some program ->
      let main = program.main_module in
      let mentions = Mentions.of_program tree in
      let lookup =
        {
          program;
          main;
          sources = a.sources;
          meant = meant_by program ~main;
          records = Option.fold typed ~none:(Place_table.create 1) ~some:(records ~main);
          own = Mentions.declared mentions;
          tables = Hashtbl.create 16;
          cache;
        }
      in
      let all = Array.of_list (List.concat_map (occurrences lookup) mentions) in
      (* All occurrences are in one file, and names do not overlap. *)
      let by_place a b = Int.compare (a.place.start :> int) (b.place.start :> int) in
      Array.stable_sort by_place all;
      all

let all = Array.to_list

let at (t : t) (p : Span.position) =
  (* The first occurrence that ends at or after this position. *)
  let rec search low high =
    if low >= high then low
    else
      let middle = (low + high) / 2 in
      if t.(middle).place.stop < p then search (middle + 1) high else search low middle
  in
  let n = Array.length t in
  let first = search 0 n in
  let is_at i = i < n && t.(i).place.start <= p && p <= t.(i).place.stop in
  (* If the position is between two adjacent names, the second one counts. *)
  let rec last i = if is_at (i + 1) && t.(i).place.stop <= p then last (i + 1) else i in
  if is_at first then Some t.(last first) else None
