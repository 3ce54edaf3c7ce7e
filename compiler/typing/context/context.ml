open Basis

type 'a later = unit -> 'a

type entry = { scheme : Type.scheme; kind : kind; at : Span.t option }
and kind = Defined | Recursive | Primitive | Method of Ir.Global.t

type required = Instance_fact.required = {
  class_ : Ir.class_;
  argument : Type.t;
  at : Span.t;
  by : Instance_fact.user;
  because : (Span.t * Instance_fact.cause) option;
  from : Instance_fact.constraint_ option;
}

type question = { attempt : unit -> bool; guess : unit -> bool; give_up : unit -> unit }

type size = {
  size : Type.t;
  used : Span.t;
  of_ : string;  (** name of the definition that was used, for the message *)
  written : string option;
      (** the size variable in the definition's signature, if the signature is in the same file *)
}

type group = {
  locals : Type.scheme Int_table.t;
  definitions : Resolve.Ir.expr Int_table.t;
      (** values of the local variables that have no parameters *)
  functions : Resolve.Ir.binding Int_table.t;  (** the local variables that have parameters *)
  first_uses : Span.t option Int_table.t;
      (** for each local function without a signature, the place of its first application *)
  mutable errors : int;
  mutable waiting : question list;  (** newest first *)
  mutable required : required list;  (** newest first *)
  mutable sizes : size list;  (** newest first *)
  mutable told : told list;  (** mismatches already reported *)
}

and told = { line : int; text : string; operator : string option; wanted : Type.t; given : Type.t }

type t = {
  reader : Annotation.t;
  real : Real.t;
  globals : entry Resolve.Global_table.t;
  bindings : Resolve.Ir.binding Resolve.Global_table.t;
  owners : (int, Surroundings.owned) Hashtbl.t;
  given : (int, Ir.class_ list) Hashtbl.t;
  needs : (Instance_fact.constraint_, required) Hashtbl.t;
  scope : Annotation.scope;
  depth : int;
  left_operand : (Resolve.Ir.expr * string) option;
  around : Surroundings.enclosing list;
  inputs : (string * Type.t) list;
  unnamed_input : Span.t option;
  sources : Source.t;
  doubts : (Span.t, Units.t * Units.t) Hashtbl.t;
  group : group;
}

let new_group () =
  {
    locals = Int_table.create 16;
    definitions = Int_table.create 8;
    functions = Int_table.create 8;
    first_uses = Int_table.create 8;
    errors = 0;
    waiting = [];
    required = [];
    sizes = [];
    told = [];
  }

let start reader ~sources ~real =
  {
    reader;
    real;
    globals = Resolve.Global_table.create 1024;
    bindings = Resolve.Global_table.create 1024;
    owners = Hashtbl.create 64;
    given = Hashtbl.create 64;
    needs = Hashtbl.create 64;
    scope = Annotation.empty;
    depth = 1;
    left_operand = None;
    around = [];
    inputs = [];
    unnamed_input = None;
    sources;
    doubts = Hashtbl.create 8;
    group = new_group ();
  }

let within t ?wanted expr = { t with around = { Surroundings.expr; wanted } :: t.around }
let in_group t = { t with group = new_group () }
let bind_local t (x : Ir.Local.t) scheme = Int_table.replace t.group.locals x.id scheme
let find_local t (x : Ir.Local.t) = Int_table.find_opt t.group.locals x.id

let defined_locally t (x : Ir.Local.t) (b : Resolve.Ir.binding) =
  match (b.parameters, b.body) with
  | [], { guards = [ { condition = None; value } ]; _ } ->
      Int_table.replace t.group.definitions x.id value
  | [], _ -> ()
  | _ :: _, _ ->
      Int_table.replace t.group.functions x.id b;
      Int_table.replace t.group.first_uses x.id None

let first_use t (x : Ir.Local.t) ~at =
  match Int_table.find_opt t.group.first_uses x.id with
  | Some None ->
      Int_table.replace t.group.first_uses x.id (Some at);
      None
  | Some (Some earlier) when Span.compare earlier at <> 0 -> Some earlier
  | Some _ | None -> None

let fresh ?kind t = Type.fresh t.reader.supply ?kind ~depth:t.depth ()
let fresh_number t = Type.fresh_number t.reader.supply ~depth:t.depth

(* The unit in base units. [None] if it contains variables. *)
let written_unit t (u : Resolve.Ir.unit_) =
  let factor product ((f : Resolve.Ir.unit_factor), (power : Syntax.Ir.rational)) =
    match (product, f) with
    | Some product, Declared g -> (
        let { Environment.measure; _ } = Environment.unit_ t.reader.environment g in
        match
          Units.power measure (Rational.make power.numerator power.denominator)
          |> Units.multiply product
        with
        | product -> Some product
        | exception Rational.Out_of_range -> None)
    | _, Unit_variable _ | None, _ -> None
  in
  List.fold_left factor (Some Units.one) u.factors

let type_of_local t x = Option.map (fun (s : Type.scheme) -> s.body) (find_local t x)

(* The top-level definition that has this parameter, and the index of the parameter. *)
let parameter t (x : Ir.Local.t) =
  let is_it (p : Resolve.Ir.pattern) = match p.desc with Bound y -> y.id = x.id | _ -> false in
  let index (b : Resolve.Ir.binding) =
    let indexed = List.mapi (fun i p -> (i, p)) b.parameters in
    Option.map fst (List.find_opt (fun (_, p) -> is_it p) indexed)
  in
  let add _ b found = if found = None then Option.map (fun i -> (b, i)) (index b) else found in
  Resolve.Global_table.fold add t.bindings None

(* The constructors of an enumeration with few cases. *)
let choices t ty =
  match Type.expand ty with
  | Data { tycon; _ } -> (
      match (Environment.type_ t.reader.environment tycon).definition with
      | Data { constructors = _ :: _ :: _ as all; _ }
        when List.compare_length_with all 4 <= 0
             && List.for_all (fun (c : Ir.constructor) -> c.fields = []) all ->
          List.map (fun (c : Ir.constructor) -> c.constructor.name) all
      | Data _ | Alias _ | Builtin | Foreign -> [])
  | _ -> []

(* The constructors of the first type that have a field of the second type, printed with their
   fields for a message. *)
let makers t ty ~of_ =
  match (Type.expand ty, Type.expand of_) with
  | Data { tycon; _ }, Data { tycon = part; units; _ } -> (
      let same u unit_ = Units.is_open u || Units.to_ir u = unit_ in
      let is_part (_, (field : Ir.ty)) =
        match field with
        | Data { tycon = t; units = declared; _ } -> t = part && List.for_all2 same units declared
        | _ -> false
      in
      match (Environment.type_ t.reader.environment tycon).definition with
      | Data { constructors; _ } ->
          List.filter (fun (c : Ir.constructor) -> List.exists is_part c.fields) constructors
          |> List.map (fun (c : Ir.constructor) ->
                 let shown (name, field) =
                   if is_part (name, field) then "…" else String.uncapitalize_ascii (Show.ty field)
                 in
                 String.concat " " (c.constructor.name :: List.map shown c.fields))
      | Alias _ | Builtin | Foreign -> [])
  | _ -> []

let named t name =
  let add (g : Ir.Global.t) (entry : entry) found =
    if String.equal g.name name then (g, entry.scheme.body) :: found else found
  in
  List.rev (Resolve.Global_table.fold add t.globals [])

(* Do these types look the same in a message? *)
let rec alike a b =
  let all = List.equal alike in
  let units = List.equal (fun u v -> (Units.is_open u && Units.is_open v) || Units.equal u v) in
  match (Type.expand a, Type.expand b) with
  | Flexible _, Flexible _ | Bool, Bool | String, String | Erroneous, Erroneous -> true
  | Rigid a, Rigid b -> a.variable.id = b.variable.id
  | Size n, Size m -> n = m
  | Number (r, u), Number (s, v) -> (
      units [ u ] [ v ]
      &&
      match (Type.representation r, Type.representation s) with
      | Int, Int | Float, Float | Flexible_representation _, Flexible_representation _ -> true
      | Rigid_representation r, Rigid_representation s -> r.variable.id = s.variable.id
      | (Int | Float | Flexible_representation _ | Rigid_representation _), _ -> false)
  | Tuple a, Tuple b -> all a b
  | Function (a, b), Function (c, d) | Signal_function (a, b), Signal_function (c, d) ->
      all [ a; b ] [ c; d ]
  | Data a, Data b -> a.tycon = b.tycon && units a.units b.units && all a.arguments b.arguments
  | ( ( Flexible _ | Bool | String | Erroneous | Rigid _ | Size _ | Number _ | Tuple _ | Function _
      | Signal_function _ | Data _ | Alias _ ),
      _ ) ->
      false

(* The definitions in this file that have this type and no parameters. *)
let values t ty ~file =
  let add (g : Ir.Global.t) (b : Resolve.Ir.binding) found =
    let is_name = match g.name.[0] with 'a' .. 'z' -> true | _ -> false in
    match (b.parameters, Resolve.Global_table.find_opt t.globals g) with
    | [], Some { scheme; _ } when is_name && String.equal b.span.file file && alike scheme.body ty
      ->
        (b.span, g.name) :: found
    | _ -> found
  in
  Resolve.Global_table.fold add t.bindings []
  |> List.sort (fun (a, _) (b, _) -> Span.compare a b)
  |> List.map snd

let surroundings t : Surroundings.t =
  let asks input (r : required) = Type.expand r.argument == Type.expand input in
  let needs_class input = List.exists (asks input) t.group.required in
  let definition (x : Ir.Local.t) = Int_table.find_opt t.group.definitions x.id in
  let fields ty =
    match Type.expand ty with
    | Data { tycon; _ } ->
        Option.map
          (fun (c : Environment.constructor) -> (c.ir.constructor.name, List.map fst c.ir.fields))
          (Environment.record_of t.reader.environment tycon)
    | _ -> None
  in
  let field_of ty ~of_ =
    match (Type.expand ty, Type.expand of_) with
    | Data { tycon; _ }, Data { tycon = part; _ } ->
        let is_part (_, (field : Ir.ty)) =
          match field with Data { tycon; _ } -> tycon = part | _ -> false
        in
        Option.bind (Environment.record_of t.reader.environment tycon) (fun constructor ->
            match List.filter is_part constructor.ir.fields with
            | [ (name, _) ] -> Some name
            | _ -> None)
    | _ -> None
  in
  let field_type ty name =
    match Type.expand ty with
    | Data { tycon; _ } as ty ->
        Option.bind (Environment.record_of t.reader.environment tycon) (fun constructor ->
            let instance = Type.instantiate t.reader.supply ~depth:t.depth constructor.scheme in
            let types, result = Environment.fields constructor instance.ty in
            match (Environment.position constructor name, Unify.types ty result) with
            | Some index, Ok () -> Some (List.nth types index)
            | _ -> None)
    | _ -> None
  in
  let declared g =
    Option.map
      (fun (entry : entry) -> entry.scheme.body)
      (Resolve.Global_table.find_opt t.globals g)
  in
  let binding g = Resolve.Global_table.find_opt t.bindings g in
  let local_function (x : Ir.Local.t) = Int_table.find_opt t.group.functions x.id in
  {
    sources = t.sources;
    environment = t.reader.environment;
    inputs = t.inputs;
    enclosing = t.around;
    unnamed_input = t.unnamed_input;
    parameter = parameter t;
    needs_class;
    definition;
    local = type_of_local t;
    unit_ = written_unit t;
    fields;
    field_of;
    field_type;
    choices = choices t;
    declared;
    named = named t;
    values = values t;
    binding;
    local_function;
    makers = makers t;
    owner = (fun (v : Ir.variable) -> Hashtbl.find_opt t.owners v.id);
  }

let warn t fact = Facts.report_warning t.reader.facts (Inference { around = surroundings t; fact })

let tell t fact =
  t.group.errors <- t.group.errors + 1;
  Facts.report t.reader.facts (Inference { around = surroundings t; fact })

let tell_of_instance t fact =
  t.group.errors <- t.group.errors + 1;
  Facts.report t.reader.facts (Instance { around = surroundings t; fact })

let tell_of_declaration t fact =
  t.group.errors <- t.group.errors + 1;
  Facts.report t.reader.facts (Declaration { around = surroundings t; fact })

let hold t f = Facts.hold t.reader.facts f
let pass_on t held = List.iter (Facts.pass_on t.reader.facts) held
let replace t fact = Facts.report t.reader.facts fact

let trial t f =
  let before = t.group.errors and told = t.group.told in
  let result, _ = hold t f in
  t.group.told <- told;
  (result, t.group.errors = before)

let tell_too_large t ~at construct =
  t.group.errors <- t.group.errors + 1;
  Facts.report t.reader.facts (Too_large { at; construct })

let tell_exponent t ~at =
  t.group.errors <- t.group.errors + 1;
  Facts.report t.reader.facts (Exponent_too_large at)

let errors t = t.group.errors

(* Has the same mismatch already been reported for the same source text on this line? Always false
   for numbers, because each literal must be corrected separately. *)
let is_told t (subject : Resolve.Ir.expr option) (expected : Expected.t) found =
  match subject with
  | None | Some { desc = Number _ | Negate _; _ } -> false
  | Some { span; _ } -> (
      match Source.quote t.sources span with
      | None -> false
      | Some text ->
          let line = Span.line span.start and wanted = expected.ty in
          let operator =
            match expected.because with Operand { operator; _ } -> Some operator | _ -> None
          in
          let is_it told =
            told.line = line && String.equal told.text text && told.operator = operator
            && alike told.wanted wanted && alike told.given found
          in
          List.exists is_it t.group.told
          ||
          (t.group.told <- { line; text; operator; wanted; given = found } :: t.group.told;
           false))

(* Records a signature that its definition contradicts, with the declared and the actual unit. *)
let doubt t (expected : Expected.t) (clash : Unify.clash) =
  match (expected.because, clash) with
  | (Signature { at; _ } | Output (Signature { at; _ })), Different_units (wanted, given) ->
      Hashtbl.replace t.doubts at (wanted, given)
  | _ -> ()

(* Would the mismatch disappear if a signature already recorded as doubtful declared the actual
   unit? *)
let is_doubted t ~subject (expected : Expected.t) (clash : Unify.clash) =
  let rec signature (e : Resolve.Ir.expr) =
    match e.desc with
    | Apply { head; style = Juxtaposed; _ } -> signature head
    | Global g ->
        Option.bind (Resolve.Global_table.find_opt t.bindings g) (fun (b : Resolve.Ir.binding) ->
            Option.map (fun (s : Resolve.Ir.scheme) -> s.span) b.signature)
    | _ -> None
  in
  let explains e (wanted, given) =
    match Option.bind (signature e) (Hashtbl.find_opt t.doubts) with
    | Some (promised, actual) -> Units.equal promised given && Units.equal actual wanted
    | None -> false
  in
  match (clash, expected.because) with
  | Different_units (wanted, given), Operand { other; _ } ->
      Option.fold subject ~none:false ~some:(fun e -> explains e (wanted, given))
      || explains other (given, wanted)
  | Different_units (wanted, given), _ ->
      Option.fold subject ~none:false ~some:(fun e -> explains e (wanted, given))
  | _ -> false

let expect t ?subject ~at (expected : Expected.t) found =
  match Unify.types expected.ty found with
  | Ok () -> ()
  | Error clash when is_doubted t ~subject expected clash -> t.group.errors <- t.group.errors + 1
  | Error clash ->
      doubt t expected clash;
      if is_told t subject expected found then t.group.errors <- t.group.errors + 1
      else tell t (Mismatch { subject; at; expected; found; clash })

let require t required = t.group.required <- required :: t.group.required

let has_no_instance t (class_ : Ir.class_) ty =
  match (class_, Head.of_type ty) with
  | Declared class_, Some (head, _) ->
      Option.is_none (Environment.instance t.reader.environment class_ head)
  | _ -> false

let asked_in_vain t ~wanted given =
  let lacks (r : required) =
    Type.expand r.argument == Type.expand given && has_no_instance t r.class_ wanted
  in
  match Type.expand given with
  | Flexible _ ->
      Option.bind (List.find_opt lacks t.group.required) (fun (r : required) ->
          match r.by with Name name -> Some name | Instance _ -> None)
  | _ -> None

let lacks_class t ~wanted given = Option.is_some (asked_in_vain t ~wanted given)

(* Records the constraints that the scheme's context imposes on the types of this instance. *)
let require_context t ~at ~name ~said (scheme : Type.scheme) (instance : Type.instance) =
  let demand (class_, argument) (_, parameter) =
    let because =
      Option.map (fun place -> (place, Instance_fact.Signature { name; class_; parameter })) said
    in
    let from =
      match Type.expand parameter with Rigid r -> Some (r.variable.id, class_) | _ -> None
    in
    require t { class_; argument; at; by = Name name; because; from }
  in
  List.iter2 demand instance.required scheme.context

let note_sizes t ~at ~name ~said (scheme : Type.scheme) (instance : Type.instance) =
  let note (r : Type.rigid) argument =
    if r.kind = Of_sizes then
      let written =
        match said with
        | Some (place : Span.t) when String.equal place.file at.Span.file -> Some r.variable.name
        | Some _ | None -> None
      in
      t.group.sizes <- { size = argument; used = at; of_ = name; written } :: t.group.sizes
  in
  List.iter2 note scheme.types instance.type_arguments

let nothing : Ir.instantiation = { types = []; representations = [] }

let use t ~at ~name ?said (scheme : Type.scheme) =
  let instance = Type.instantiate t.reader.supply ~depth:t.depth scheme in
  if scheme.context <> [] then require_context t ~at ~name ~said scheme instance;
  if scheme.types <> [] then note_sizes t ~at ~name ~said scheme instance;
  let final =
    match (instance.type_arguments, instance.representation_arguments) with
    | [], [] -> fun () -> nothing
    | types, representations -> (
        fun () : Ir.instantiation ->
          {
            types = List.map Final.ty types;
            representations = List.map Final.representation representations;
          })
  in
  (instance.ty, final)

let is_variable r =
  match Type.representation r with
  | Rigid_representation _ -> true
  | Int | Float | Flexible_representation _ -> false

let check_context t (written : Resolve.Ir.scheme) (scheme : Type.scheme) =
  let mentioned (v : Ir.variable) = Type.mentions v scheme.body in
  let check (c : Resolve.Ir.constraint_) (_, argument) =
    match Type.expand argument with
    | Rigid r ->
        let own =
          List.exists (fun (o : Type.rigid) -> o.variable.id = r.variable.id) scheme.types
        in
        if own && not (mentioned r.variable) then
          tell t (Idle_constraint { at = c.span; variable = r.variable; ty = written.ty.span })
    | Number (r, _) when is_variable r -> ()
    | Erroneous -> ()
    | _ -> tell t (Constraint_on_type { at = c.span; ty = argument })
  in
  List.iter2 check written.context scheme.context

let with_variables t ~by (written : Resolve.Ir.scheme) =
  let depth = t.depth + 1 in
  let scheme, scope = Annotation.signature t.reader t.scope ~depth written in
  let owned : Surroundings.owned = { by; place = written.span } in
  let own (v : Ir.variable) = Hashtbl.replace t.owners v.id owned in
  List.iter (fun (r : Type.rigid) -> own r.variable) scheme.types;
  List.iter (fun (r : Units.rigid) -> own r.variable) (scheme.representations @ scheme.units);
  check_context t written scheme;
  (scheme, { t with scope; depth })

let with_signature t ~name = with_variables t ~by:(Signature name)

let ask t question =
  if not (question.attempt ()) then t.group.waiting <- question :: t.group.waiting

let rec settle t =
  match List.rev t.group.waiting with
  | [] -> ()
  | waiting ->
      t.group.waiting <- [];
      let answered before after = List.compare_lengths after before < 0 in
      let after_attempts = List.filter (fun q -> not (q.attempt ())) waiting in
      let still =
        if answered waiting after_attempts then after_attempts
        else List.filter (fun q -> not (q.attempt () || q.guess ())) waiting
      in
      if answered waiting still then (
        t.group.waiting <- List.rev_append still t.group.waiting;
        settle t)
      else List.iter (fun q -> q.give_up ()) still

let forgetting_what_errors_need t f =
  let before = t.group.errors and required = t.group.required in
  let result = f () in
  if t.group.errors > before then t.group.required <- required;
  result

let check_sizes t =
  let check { size; used; of_; written } =
    match Type.expand size with
    | Flexible variable when t.group.errors = 0 ->
        variable.found <- Some Type.Erroneous;
        tell t (Unknown_size { at = used; of_; variable = written })
    | _ -> ()
  in
  (* Starts with the latest use, because it is usually the closest to the place where the array is
     built. *)
  List.iter check t.group.sizes

let requirements t = List.rev t.group.required

type typed = { ty : Type.t; build : Ir.expr later }

type expressions = {
  infer : t -> Resolve.Ir.expr -> typed;
  check : t -> Resolve.Ir.expr -> Expected.t -> Ir.expr later;
}

exception Too_large of Span.t

let node span ty desc : Ir.expr =
  match Final.ty ty with
  | ty -> { desc; ty; span }
  | exception Final.Too_large -> raise (Too_large span)
