open Basis
open Context
module Global_table = Resolve.Global_table

type declared = { scheme : Type.scheme; inner : Context.t; at : Span.t }
(* A top-level definition that has a signature. [inner]: the context in which its body is
   checked. *)

let top (b : Resolve.Ir.binding) =
  match b.name with
  | Top (name, at) -> (name, at)
  | Inner _ | Destructure _ -> Diagnostic.bug ~stage:"Typing.Infer" "a local binding at top level"

let primitive ctx (p : Resolve.Ir.primitive) =
  let scheme, _ = with_signature ctx ~name:p.name.name p.scheme in
  Global_table.replace ctx.globals p.name { scheme; kind = Primitive; at = None };
  (p.name, Final.scheme scheme)

(* The primitive for [do]: [Task a b c -> (c -> Task a b d) -> Task a b d]. *)
let sequence ctx =
  let rigid name : Type.rigid =
    { variable = { id = Type.next ctx.reader.supply; name }; kind = Of_types; depth = 1 }
  in
  let types = List.map rigid [ "a"; "b"; "c"; "d" ] in
  let body : Type.t =
    match List.map (fun r -> Type.Rigid r) types with
    | [ a; b; c; d ] ->
        let rest : Type.t = Function (c, Environment.task_of a b d) in
        Function (Environment.task_of a b c, Function (rest, Environment.task_of a b d))
    | _ -> Erroneous
  in
  let scheme : Type.scheme = { types; representations = []; units = []; context = []; body } in
  Global_table.replace ctx.globals Environment.sequence { scheme; kind = Primitive; at = None };
  (Environment.sequence, Final.scheme scheme)

(* Enters signatures first, so that a definition with a signature can be used before it is
   checked. *)
let signature ctx declared (b : Resolve.Ir.binding) =
  let name, _ = top b in
  match b.signature with
  | None -> ()
  | Some written ->
      let scheme, inner = with_signature ctx ~name:name.name written in
      Global_table.replace ctx.globals name { scheme; kind = Defined; at = Some written.span };
      Global_table.replace declared name { scheme; inner; at = written.span }

let expectation ctx declared ~recursive (b : Resolve.Ir.binding) : Context.t * Expected.t =
  let name, at = top b in
  match Global_table.find_opt declared name with
  | Some { scheme; inner; at } ->
      Classes.give ctx scheme;
      let name = Resolve.Parameters.shown name.name in
      ( { inner with group = ctx.group },
        { ty = scheme.body; because = Signature { name; at }; parts = [] } )
  | None ->
      let ty = Context.fresh ctx in
      let scheme = Type.monomorphic ty in
      Global_table.replace ctx.globals name { scheme; kind = Recursive; at = None };
      let because = if recursive then Expected.Uses { name = name.name; at } else Unknown in
      (ctx, { ty; because; parts = [] })

(* Checks the value of a `test`, to which resolution has applied the function [holding]. If the
   value is a condition, keeps the application. Otherwise drops it; the value must then be a test
   itself. *)
let test ctx ~(holding : Resolve.Ir.expr) (value : Resolve.Ir.expr) (expected : Expected.t) =
  let typed = Infer_expression.expressions.infer ctx value in
  match Type.expand typed.ty with
  | Bool ->
      let function_ = Infer_expression.expressions.infer ctx holding in
      fun () -> node value.span expected.ty (Apply (function_.build (), typed.build ()))
  | _ ->
      expect ctx ~subject:value ~at:value.span expected typed.ty;
      typed.build

let check ~name (b : Resolve.Ir.binding) (inner, expected) =
  match b.body.guards with
  | [
   {
     condition = None;
     value = { desc = Apply { head = { desc = Global g; _ } as holding; argument; _ }; _ };
   };
  ]
    when g = Resolve.Labels.holding && Resolve.Labels.kind_of_check name <> None ->
      test inner ~holding argument expected
  | _ ->
      Infer_binding.abstraction inner ~at:b.span ~name:(Some name)
        ~is_proc:(Infer_binding.is_proc b) b.parameters expected (fun expected ->
          Infer_binding.right Infer_expression.expressions inner b.body expected)

(* Generalizes the definitions that have no signature. They share their type variables, and each
   definition quantifies over all of them. *)
let generalize ctx declared bindings expectations =
  let unsigned =
    List.filter
      (fun (b, _) -> not (Global_table.mem declared (fst (top b))))
      (List.combine bindings expectations)
  in
  let types = List.map (fun (_, (_, (e : Expected.t))) -> e.ty) unsigned in
  let quantified = Generalize.types ctx.reader.supply ~depth:ctx.depth types in
  let context = Classes.solve ctx quantified in
  List.iter2
    (fun (b, _) body ->
      let scheme : Type.scheme =
        {
          types = quantified.types;
          representations = quantified.representations;
          units = quantified.units;
          context;
          body;
        }
      in
      Global_table.replace ctx.globals (fst (top b)) { scheme; kind = Defined; at = None })
    unsigned types

(* Omits a definition and reports an error if one of its types exceeds the size limit, because such
   a type would slow down later stages. *)
let definition ctx (b : Resolve.Ir.binding) scheme value : Ir.definition option =
  let name, _ = top b in
  let refuse at construct =
    tell_too_large ctx ~at construct;
    None
  in
  match
    let value = value () in
    (Final.scheme scheme, value)
  with
  | scheme, value -> Some { name; scheme; needs = []; value; doc = b.doc; span = b.span }
  | exception Too_large at -> refuse at Fact.Expression
  | exception Final.Too_large -> refuse b.span (Definition name.name)

(* Warns only if the definition has the declared type, because otherwise an error has already been
   reported. *)
let warn_of_variables_like_types ctx declared (b : Resolve.Ir.binding) =
  match Global_table.find_opt declared (fst (top b)) with
  | Some { scheme; at; _ } when errors ctx = 0 ->
      List.map (fun (r : Type.rigid) -> r.variable) scheme.types
      @ List.map (fun (r : Units.rigid) -> r.variable) scheme.representations
      |> List.iter (fun (variable : Ir.variable) ->
             Variable_name.type_meant variable.name
             |> Option.iter (fun type_ -> warn ctx (Variable_like_a_type { at; variable; type_ })))
  | Some _ | None -> ()

(* Stops checking uses against the signature at this place. *)
let distrust ctx (b : Resolve.Ir.binding) at =
  let entry = { scheme = Type.monomorphic Erroneous; kind = Defined; at = Some at } in
  Global_table.replace ctx.globals (fst (top b)) entry

(* Does the fact suggest that the signature at this place is wrong? It does if the signature
   declares a function but the definition is a signal function, or the reverse, or if the definition
   has more parameters than the signature allows. *)
let contradicts (at : Span.t) (fact : Fact.t) =
  let is_signature (expected : Expected.t) =
    match expected.because with
    | Signature s | Output (Signature s) -> Span.compare s.at at = 0
    | _ -> false
  in
  match fact with
  | Inference { fact = Too_many_parameters { expected; _ } | Lacking_types { expected; _ }; _ } ->
      is_signature expected
  | Inference { fact = Mismatch { expected; found; _ }; _ } -> (
      is_signature expected
      &&
      match (Type.expand expected.ty, Type.expand found) with
      | Function _, Signal_function _ | Signal_function _, Function _ -> true
      | _ -> false)
  | _ -> false

(* Does the definition fit this signature? Checks it without reporting anything. *)
let fits (ctx : Context.t) (b : Resolve.Ir.binding) written =
  let name, _ = top b in
  let reader = { ctx.reader with facts = Facts.ignored () } in
  let trial = in_group { ctx with reader; doubts = Hashtbl.copy ctx.doubts } in
  let declared = Global_table.create 1 and entry = Global_table.find_opt ctx.globals name in
  signature trial declared { b with signature = Some written };
  ignore (check ~name:name.name b (expectation trial declared ~recursive:false b) : _ later);
  settle trial;
  ignore (Classes.solve trial Generalize.none);
  check_sizes trial;
  Option.iter (Global_table.replace ctx.globals name) entry;
  errors trial = 0

(* If the definition would fit its signature with two types exchanged, reports that instead of the
   facts about the definition. Returns the facts that are still to be reported. *)
let exchanged_signature (ctx : Context.t) held (b : Resolve.Ir.binding) =
  let explained (written : Resolve.Ir.scheme) mistake =
    let name, _ = top b in
    Exchanged_signature.candidates written
    |> List.find_opt (fun e -> fits ctx b (Exchanged_signature.scheme e))
    |> Fun.flip Option.bind (fun exchanged ->
           let mistake = Facts.fact mistake in
           Exchanged_signature.fact ctx.sources ~name:name.name b ~written exchanged ~mistake)
  in
  match b.signature with
  | None -> held
  | Some written -> (
      match List.partition (Facts.is_within [ b.span; written.span ]) held with
      | [], _ -> held
      | (first :: _ as mistakes), others -> (
          match explained written first with
          | None -> held
          | Some fact ->
              replace ctx (Exchanged_signature { around = surroundings ctx; fact; mistakes });
              distrust ctx b written.span;
              others))

(* {1 Limits} *)

(* Even the types of a few lines may need more memory than is available, and inference may visit
   parts of a very long definition many times. *)
let most_steps_of_one = 5_000_000
let most_steps = 20_000_000

(* Runs the check of one definition with a limited number of steps. Returns [otherwise] if the types
   are too large. Once the steps allowed for the whole program are used up, skips the remaining
   checks, because an error has already been reported. *)
let limited ctx left ~at construct ~otherwise check =
  let before = Work.left () in
  let checked =
    if !left <= 0 then Some otherwise
    else
      match Work.within (Int.min most_steps_of_one !left) check with
      | checked -> checked
      | exception Final.Too_large -> None
      | exception Rational.Out_of_range ->
          tell_exponent ctx ~at;
          Some otherwise
  in
  left := !left - (before - Work.left ());
  match checked with
  | Some checked -> checked
  | None ->
      tell_too_large ctx ~at construct;
      otherwise

let of_binding ctx left (b : Resolve.Ir.binding) ~otherwise check =
  let { Ir.Global.name; _ } = fst (top b) in
  limited ctx left ~at:b.span (Definition name) ~otherwise check

let group ctx declared (g : Resolve.Ir.binding_group) =
  let ctx = in_group ctx in
  let check (b : Resolve.Ir.binding) expectation =
    let value, held = hold ctx (fun () -> check ~name:(fst (top b)).name b expectation) in
    pass_on ctx held;
    (match (Global_table.find_opt declared (fst (top b)), List.rev held) with
    | Some { at; _ }, last :: _ when contradicts at (Facts.fact last) -> distrust ctx b at
    | _ -> ());
    value
  in
  let values, held =
    hold ctx (fun () ->
        let expectations = List.map (expectation ctx declared ~recursive:g.recursive) g.bindings in
        let values = List.map2 check g.bindings expectations in
        settle ctx;
        generalize ctx declared g.bindings expectations;
        check_sizes ctx;
        values)
  in
  let held =
    if errors ctx > 0 then List.fold_left (exchanged_signature ctx) held g.bindings else held
  in
  pass_on ctx held;
  List.iter (warn_of_variables_like_types ctx declared) g.bindings;
  let definition (b : Resolve.Ir.binding) value =
    let { Context.scheme; _ } = Global_table.find ctx.globals (fst (top b)) in
    definition ctx b scheme value
  in
  List.filter_map Fun.id (List.map2 definition g.bindings values)

(* {1 Classes} *)

(* Checks a method's definition against this type. *)
let method_definition ctx (inner : Context.t) (m : Declared_class.method_) (scheme : Type.scheme)
    (b : Resolve.Ir.binding) =
  let ctx = in_group ctx in
  Classes.give ctx scheme;
  let expected : Expected.t =
    { ty = scheme.body; because = Signature { name = m.name.name; at = m.signature }; parts = [] }
  in
  let value = check ~name:m.name.name b ({ inner with group = ctx.group }, expected) in
  settle ctx;
  ignore (Classes.solve ctx Generalize.none);
  check_sizes ctx;
  definition ctx b scheme value

let defaults ctx (c : Declared_class.class_) =
  List.filter_map
    (fun (m : Declared_class.method_) ->
      Option.bind m.default (method_definition ctx m.inner m m.scheme))
    c.methods

let definitions_of_instance ctx (i : Declared_class.instance) =
  let definition (m : Declared_class.method_) =
    Option.bind
      (List.assoc_opt m.name i.definitions)
      (method_definition ctx i.inner m (Class_declarations.method_of i m))
  in
  List.filter_map definition i.of_class.methods

let check_superclasses ctx (i : Declared_class.instance) =
  let ctx = in_group ctx in
  Classes.give ctx i.scheme;
  let by = Instance_fact.Instance (Declared i.of_class.class_, i.head) in
  let require_superclass (class_, span) =
    let because = Some (span, Instance_fact.Superclass { class_; of_ = i.of_class.class_ }) in
    require ctx { class_; argument = i.head; at = i.place; by; because; from = None }
  in
  List.iter require_superclass i.of_class.superclasses;
  ignore (Classes.solve ctx Generalize.none)

let class_declaration (c : Declared_class.class_) : Ir.class_declaration =
  let method_ (m : Declared_class.method_) = (m.name, Final.scheme m.scheme) in
  { class_ = c.class_; methods = List.map method_ c.methods }

let instance (i : Declared_class.instance) : Ir.instance =
  let implementation (m : Declared_class.method_) : (Ir.Global.t * Ir.implementation) option =
    match (List.assoc_opt m.name i.definitions, m.default) with
    | Some b, _ -> Some (m.name, Given (fst (top b)))
    | None, Some b -> Some (m.name, Default (fst (top b)))
    | None, None -> None
  in
  {
    class_ = i.of_class.class_;
    parameters = List.map (fun (r : Type.rigid) -> r.variable) i.scheme.types;
    head = Final.ty i.head;
    methods = List.filter_map implementation i.of_class.methods;
    span = i.place;
  }

let in_backticks : Instance_fact.user -> string = function
  | Name name -> Printf.sprintf "`%s`" name
  | Instance (class_, head) -> Printf.sprintf "`%s`" (Show.final_constraint class_ (Final.ty head))

(* Follows a requirement from a use to the definition that is used, as long as both are outside the
   library. *)
let need ctx ~is_library ~(otherwise : Ir.need) constraint_ : Ir.need =
  let rec follow seen otherwise constraint_ : Ir.need =
    match Hashtbl.find_opt ctx.needs constraint_ with
    | Some (required : required)
      when (not (List.mem constraint_ seen)) && not (is_library required.at.file) -> (
        let found : Ir.need = { place = required.at; by = in_backticks required.by } in
        match required.from with
        | Some inner -> follow (constraint_ :: seen) found inner
        | None -> found)
    | Some _ | None -> otherwise
  in
  follow [] otherwise constraint_

(* Adds to a definition the code that first requires each constraint in its context. Called when all
   definitions are known. *)
let with_needs ctx (program : Resolve.Ir.program) (d : Ir.definition) : Ir.definition =
  let is_library file =
    List.exists
      (fun (m : Resolve.Ir.module_) -> m.library && String.equal m.file file)
      program.modules
  in
  let otherwise : Ir.need = { place = d.span; by = Printf.sprintf "`%s`" d.name.name } in
  let of_constraint (class_, (t : Ir.ty)) =
    match t with Variable v -> need ctx ~is_library ~otherwise (v.id, class_) | _ -> otherwise
  in
  match d.scheme.context with
  | [] -> d
  | context -> { d with needs = List.map of_constraint context }

let program ?(sources = Source.create ()) facts ~real (program : Resolve.Ir.program) : Ir.program =
  let reader : Annotation.t =
    { environment = Environment.create (); supply = Type.supply (); facts }
  in
  let data = Declarations.program reader program in
  let ctx = Context.start reader ~sources ~real in
  let primitives = Long_list.map (primitive ctx) program.primitives @ [ sequence ctx ] in
  let classes = Class_declarations.classes ctx program in
  let instances = Class_declarations.instances ctx classes program in
  let declared = Global_table.create 1024 in
  List.iter
    (fun (g : Resolve.Ir.binding_group) ->
      List.iter (fun b -> Global_table.replace ctx.bindings (fst (top b)) b) g.bindings)
    program.groups;
  let left = ref most_steps in
  List.iter
    (fun (g : Resolve.Ir.binding_group) ->
      List.iter
        (fun b -> of_binding ctx left b ~otherwise:() (fun () -> signature ctx declared b))
        g.bindings)
    program.groups;
  let add reversed (g : Resolve.Ir.binding_group) =
    let check () = group ctx declared g in
    List.rev_append (of_binding ctx left (List.hd g.bindings) ~otherwise:[] check) reversed
  in
  let definitions = List.fold_left add [] program.groups in
  let definitions =
    List.fold_left (fun reversed c -> List.rev_append (defaults ctx c) reversed) definitions classes
  in
  let add_instance reversed (i : Declared_class.instance) =
    let check () = definitions_of_instance ctx i in
    List.rev_append (limited ctx left ~at:i.place ~otherwise:[] Instance check) reversed
  in
  let definitions = List.rev (List.fold_left add_instance definitions instances) in
  List.iter
    (fun (i : Declared_class.instance) ->
      limited ctx left ~at:i.place ~otherwise:() Instance (fun () -> check_superclasses ctx i))
    instances;
  let report = Annotation.report_declaration reader in
  {
    main_module = program.main_module;
    real;
    data;
    primitives;
    foreign = Foreign_import.program ~report program ~environment:reader.environment ~primitives;
    classes = List.map class_declaration classes;
    instances = List.map instance instances;
    definitions = Long_list.map (with_needs ctx program) definitions;
    params = Params.program ~report program definitions;
  }
