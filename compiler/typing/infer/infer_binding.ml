open Basis
open Context

let undecided (expected : Expected.t) =
  match (Type.expand expected.ty, Environment.as_task expected.ty) with
  | Flexible _, _ -> true
  | _, Some (_, _, result) -> ( match Type.expand result with Flexible _ -> true | _ -> false)
  | _ -> false

let beside ~undecided (expected : Expected.t) at : Expected.t =
  match expected.because with
  | Unknown -> { expected with because = Branch at; parts = [] }
  | _ when undecided -> { expected with because = Branch at; parts = [] }
  | _ -> expected

(* {1 Functions} *)

(* The number of parameters that a function of this type can have; [None] if it is not known yet. *)
let rec parameters_allowed t =
  match Type.expand t with
  | Function (_, result) -> Option.map succ (parameters_allowed result)
  | Flexible _ | Erroneous -> None
  | _ -> Some 0

(* Recognizes `f (x, y) = …` with a signature for separate parameters. *)
let as_several parameters allowed (expected : Expected.t) =
  match ((parameters : Resolve.Ir.pattern list), Type.expand expected.ty) with
  | [ { desc = Tuple_of (_ :: _ :: _ as parts); span } ], Function (first, _)
    when allowed = Some (List.length parts) -> (
      match Type.expand first with
      | Tuple _ | Flexible _ | Erroneous -> None
      | _ -> Some (span, parts))
  | _ -> None

let is_proc (b : Resolve.Ir.binding) =
  match b.body.guards with
  | [ { condition = None; value = { desc = Proc _; _ } } ] -> true
  | _ -> false

let abstraction ctx ~at ~name ~is_proc parameters (expected : Expected.t) body =
  let allowed = parameters_allowed expected.ty in
  let is_refused =
    match allowed with
    | Some n -> List.compare_length_with parameters n > 0 && (name <> None || n > 0)
    | None -> false
  in
  let names =
    List.filter_map
      (fun (p : Resolve.Ir.pattern) -> match p.desc with Bound x -> Some x.name | _ -> None)
      parameters
  in
  let rec result k t =
    match Type.expand t with Function (_, t) when k > 0 -> result (k - 1) t | _ -> t
  in
  let rec extended k types t =
    match Type.expand t with
    | Function (a, t) when k > 0 -> Type.Function (a, extended (k - 1) types t)
    | _ -> List.fold_right (fun a t -> Type.Function (a, t)) types t
  in
  (* the types that are missing from the signature, with the names of their parameters *)
  let lacking =
    match (allowed, expected.because) with
    | Some n, Signature _ when is_refused && is_proc && List.compare_lengths names parameters = 0
      -> (
        match Type.expand (result n expected.ty) with
        | Signal_function _ ->
            List.filteri (fun i _ -> i >= n) names |> List.map (fun x -> (x, Context.fresh ctx))
        | _ -> [])
    | _ -> []
  in
  (* the type to check against; after an error, a type that prevents further messages about the
     parameters *)
  let kept =
    match (name, as_several parameters allowed expected) with
    | Some name, Some (at, parts) ->
        tell ctx (Parameters_in_a_tuple { name; at; parts; expected });
        Type.Erroneous
    | _ when not is_refused -> expected.ty
    | _ when lacking <> [] -> extended (Option.get allowed) (List.map snd lacking) expected.ty
    | _ ->
        let n = Option.get allowed in
        let at = (List.nth parameters n : Resolve.Ir.pattern).span in
        let result = result n expected.ty in
        tell ctx (Too_many_parameters { name; at; parameters; expected; result; allowed = n });
        Type.Erroneous
  in
  let parameter (patterns, rest) (p : Resolve.Ir.pattern) =
    let from, into =
      match Type.expand rest with
      | Function (a, b) -> (a, b)
      | Erroneous -> (Type.Erroneous, Type.Erroneous)
      | other -> (
          let a = Context.fresh ctx and b = Context.fresh ctx in
          expect ctx ~at { expected with ty = rest } (Function (a, b));
          match other with Flexible _ -> (a, b) | _ -> (Type.Erroneous, Type.Erroneous))
    in
    let pattern = Infer_pattern.check ctx p (Reason.part Of_parameter expected from) in
    (pattern :: patterns, into)
  in
  let patterns, rest = List.fold_left parameter ([], kept) parameters in
  let body =
    body
      (if parameters = [] then { expected with ty = rest } else Reason.part Of_result expected rest)
  in
  (match (lacking, name) with
  | _ :: _, Some name ->
      let first = List.nth parameters (Option.get allowed) in
      tell ctx (Lacking_types { name; at = first.span; expected; lacking })
  | _ -> ());
  match patterns with
  | [] -> body
  | _ ->
      fun () ->
        let patterns = List.rev_map (fun build -> build ()) patterns in
        node at expected.ty (Lambda (patterns, body ()))

(* {1 Right-hand sides} *)

let is_otherwise (e : Resolve.Ir.expr) =
  match e.desc with
  | Global name -> name = Environment.built_in "otherwise"
  | Constructor name -> name = Environment.built_in "True"
  | _ -> false

let span_of_guards guards (last : Resolve.Ir.expr) =
  match (guards : Resolve.Ir.guarded list) with
  | { condition = Some first; _ } :: _ -> Span.merge first.span last.span
  | _ -> last.span

let guards expressions ctx (guards : Resolve.Ir.guarded list) (expected : Expected.t) =
  let rec go conditional expected : Resolve.Ir.guarded list -> _ = function
    | [] -> (conditional, None)
    | [ { condition = None; value } ] -> (conditional, Some (expressions.check ctx value expected))
    | [ { condition = Some condition; value } ] when is_otherwise condition ->
        (conditional, Some (expressions.check ctx value expected))
    | { condition; value } :: rest ->
        let test =
          match condition with
          | Some condition ->
              expressions.check ctx condition { ty = Bool; because = Condition; parts = [] }
          | None ->
              Diagnostic.bug ~stage:"Typing.Infer"
                "a guard without a condition must be the last one"
        in
        let result = expressions.check ctx value expected in
        go ((test, result) :: conditional) (beside ~undecided:false expected value.span) rest
  in
  let conditional, last = go [] expected guards in
  match (conditional, last, List.rev guards) with
  | [], Some value, _ -> value
  | _, _, { value; _ } :: _ ->
      fun () ->
        let conditional =
          List.rev_map
            (fun (test, result) ->
              let test = test () in
              (test, result ()))
            conditional
        in
        let last = Option.map (fun build -> build ()) last in
        node (span_of_guards guards value) expected.ty (Guards (conditional, last))
  | _, _, [] -> Diagnostic.bug ~stage:"Typing.Infer" "a right-hand side without a value"

(* {1 Local declarations} *)

let polymorphic (s : Type.scheme) = s.types <> [] || s.representations <> [] || s.units <> []

(* Checks that a local binding may have this scheme. *)
let local_scheme ctx ~name ~at (written : Resolve.Ir.scheme) (scheme : Type.scheme) =
  match Type.expand scheme.body with
  | Function _ -> scheme
  | _ when not (polymorphic scheme) -> scheme
  | _ ->
      tell ctx (Polymorphic_value { name; at; signature = written.span; ty = scheme.body });
      Type.monomorphic Erroneous

type declared = { scheme : Type.scheme; inner : t; at : Span.t }
(* A local definition with a signature. [inner]: the context in which its body is checked. *)

let declare ctx (local : Ir.Local.t) (written : Resolve.Ir.scheme) =
  let scheme, inner = with_signature ctx ~name:local.name written in
  let scheme = local_scheme ctx ~name:(Some local.name) ~at:local.span written scheme in
  bind_local ctx local scheme;
  { scheme; inner; at = written.span }

let rec right expressions ctx (r : Resolve.Ir.right) expected =
  match r.where with
  | { groups = []; signatures = [] } -> guards expressions ctx r.guards expected
  | where ->
      let bindings = declarations expressions ctx where in
      let body = guards expressions ctx r.guards expected in
      fun () ->
        let bindings = bindings () in
        let body = body () in
        ({ desc = Let (bindings, body); ty = body.ty; span = body.span } : Ir.expr)

and declarations expressions ctx (d : Resolve.Ir.declarations) =
  List.iter (fun (local, written) -> ignore (declare ctx local written)) d.signatures;
  let signed = Hashtbl.create 8 in
  let declare_binding (b : Resolve.Ir.binding) =
    match (b.name, b.signature) with
    | Inner local, Some written -> Hashtbl.replace signed local.id (declare ctx local written)
    | (Inner _ | Top _ | Destructure _), _ -> ()
  in
  List.iter (fun (g : Resolve.Ir.binding_group) -> List.iter declare_binding g.bindings) d.groups;
  let groups = List.rev_map (group expressions ctx signed) d.groups in
  fun () -> List.concat_map (List.map (fun build -> build ())) (List.rev groups)

and group expressions ctx signed (g : Resolve.Ir.binding_group) =
  (* All names are bound first, because the order within a group is irrelevant. *)
  let prepared = List.map (prepare ctx signed) g.bindings in
  let recursive = g.recursive in
  List.map2 (binding expressions ctx ~recursive) g.bindings prepared

and prepare ctx signed (b : Resolve.Ir.binding) =
  match b.name with
  | Inner local -> (
      match Hashtbl.find_opt signed local.id with
      | Some declared -> `Signed (local, declared)
      | None ->
          let ty = Context.fresh ctx in
          bind_local ctx local (Type.monomorphic ty);
          defined_locally ctx local b;
          `Plain (local, ty))
  | Destructure pattern ->
      let ty = Context.fresh ctx in
      `Pattern (pattern, ty, Infer_pattern.check ctx pattern { ty; because = Unknown; parts = [] })
  | Top (name, _) -> Diagnostic.bug ~stage:"Typing.Infer" "%s is not local" name.name

and binding expressions ctx ~recursive (b : Resolve.Ir.binding) prepared : Ir.binding later =
  let value ctx ~name expected =
    abstraction ctx ~at:b.span ~name ~is_proc:(is_proc b) b.parameters expected (fun expected ->
        right expressions ctx b.body expected)
  in
  let finish pattern (scheme : Type.scheme) value () : Ir.binding =
    let pattern : Ir.pattern = pattern () in
    let scheme = Final.scheme scheme in
    { pattern; scheme; value = value (); recursive; level = Constant; span = b.span }
  in
  let bound (local : Ir.Local.t) ty () : Ir.pattern =
    { desc = Bound local; ty = Final.ty ty; span = local.span }
  in
  match prepared with
  | `Signed ((local : Ir.Local.t), { scheme; inner; at }) ->
      Classes.give ctx scheme;
      let expected : Expected.t =
        { ty = scheme.body; because = Signature { name = local.name; at }; parts = [] }
      in
      let value = value inner ~name:(Some local.name) expected in
      finish (bound local scheme.body) scheme value
  | `Plain ((local : Ir.Local.t), ty) ->
      let because =
        if recursive then Expected.Uses { name = local.name; at = local.span } else Unknown
      in
      let value = value ctx ~name:(Some local.name) { ty; because; parts = [] } in
      finish (bound local ty) (Type.monomorphic ty) value
  | `Pattern ((pattern : Resolve.Ir.pattern), ty, build) ->
      let value = value ctx ~name:None { ty; because = Pattern pattern.span; parts = [] } in
      finish build (Type.monomorphic ty) value

(* {1 Annotations} *)

let annotated expressions ctx (e : Resolve.Ir.expr) inner_expr written =
  let scheme, inner = with_signature ctx ~name:"this" written in
  let scheme = local_scheme ctx ~name:None ~at:e.span written scheme in
  Classes.give ctx scheme;
  let value =
    expressions.check inner inner_expr
      { ty = scheme.body; because = Annotation written.span; parts = [] }
  in
  if not (polymorphic scheme) then { ty = scheme.body; build = value }
  else
    (* resolution numbers local variables from 0 upwards, so negative ids are unique *)
    let local : Ir.Local.t =
      { id = -Type.next ctx.reader.supply; name = "annotated"; span = e.span }
    in
    let ty, instantiation = use ctx ~at:e.span ~name:"this" scheme in
    let build () =
      let binding : Ir.binding =
        {
          pattern = { desc = Bound local; ty = Final.ty scheme.body; span = e.span };
          scheme = Final.scheme scheme;
          value = value ();
          recursive = false;
          level = Constant;
          span = e.span;
        }
      in
      let body : Ir.expr =
        { desc = Local (local, instantiation ()); ty = Final.ty ty; span = e.span }
      in
      node e.span ty (Let ([ binding ], body))
    in
    { ty; build }
