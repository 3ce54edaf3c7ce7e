open Basis
open Context

(* [e ^ k] raises the unit to the same power. *)
let power ctx (e : Resolve.Ir.expr) (base : typed) exponent =
  let supply = ctx.reader.supply and depth = ctx.depth in
  let unit_ = Type.fresh_unit supply ~depth in
  let representation =
    if exponent < 0 then Type.Float else Type.fresh_representation supply ~depth
  in
  expect ctx ~at:e.span
    { ty = Number (representation, unit_); because = Unknown; parts = [] }
    base.ty;
  match Units.power (Units.resolve unit_) (Rational.of_int exponent) with
  | raised -> Type.Number (representation, raised)
  | exception Rational.Out_of_range ->
      if not (Units.equal unit_ Units.one) then tell_exponent ctx ~at:e.span;
      Type.Number (representation, Units.one)

(* Longer array literals slow down every stage and the editor. *)
let most_written = 100_000

(* A reference to a variable, with a new instance of its scheme. *)
let reference ctx ~at ~name ?said scheme desc =
  let ty, instantiation = use ctx ~at ~name ?said scheme in
  { ty; build = (fun () -> node at ty (desc (instantiation ()))) }

(* Within its own group, a definition is instantiated with its own type variables. *)
let own_instantiation ctx name : Ir.instantiation =
  let { scheme; _ } = Resolve.Global_table.find ctx.globals name in
  let scheme = Final.scheme scheme in
  {
    types = List.map (fun v -> Ir.Variable v) scheme.types;
    representations = List.map (fun v -> Ir.Representation_variable v) scheme.representations;
  }

let global ctx (e : Resolve.Ir.expr) (name : Ir.Global.t) =
  match Resolve.Global_table.find_opt ctx.globals name with
  | Some { scheme; kind; at } ->
      reference ctx ~at:e.span ~name:name.name ?said:at scheme (fun instantiation ->
          match kind with
          | Primitive -> Primitive (name, instantiation)
          | Recursive -> Global (name, own_instantiation ctx name)
          | Defined -> Global (name, instantiation)
          | Method class_ -> Method { class_; method_ = name; instantiation })
  | None ->
      Diagnostic.bug ~stage:"Typing.Infer" "%s.%s is used before it is typed" name.module_ name.name

let local ctx (e : Resolve.Ir.expr) (local : Ir.Local.t) =
  match find_local ctx local with
  | Some scheme ->
      reference ctx ~at:e.span ~name:local.name scheme (fun instantiation ->
          Local (local, instantiation))
  | None ->
      Diagnostic.bug ~stage:"Typing.Infer" "the local %s is used before it is typed" local.name

(* Was this branch as a whole just reported as having the wrong type? If so, nothing is reported
   about the other branch. *)
let is_told_of (e : Resolve.Ir.expr) held =
  match List.rev_map Facts.fact held with
  | Fact.Inference { fact = Mismatch { at; clash = Different _; _ } | Exchanged_pair { at; _ }; _ }
    :: _ ->
      Span.compare at e.span = 0
  | _ -> false

let anything (expected : Expected.t) : Expected.t = { expected with ty = Erroneous }

let rec infer ctx (e : Resolve.Ir.expr) : typed =
  match e.desc with
  | Local name -> local ctx e name
  | Global name -> global ctx e name
  | Constructor name ->
      let constructor = Environment.constructor ctx.reader.environment name in
      reference ctx ~at:e.span ~name:name.name constructor.scheme (fun _ ->
          Constructor (constructor.ir, constructor.tycon))
  | Number n ->
      let ty, value = Literal.number ctx ~negative:false ~at:e.span n in
      { ty; build = (fun () -> node e.span ty (Number value)) }
  | String text -> { ty = String; build = (fun () -> node e.span String (String text)) }
  | Tuple elements ->
      let elements = Long_list.map (infer ctx) elements in
      let ty = Type.shared (Tuple (List.map (fun (t : typed) -> t.ty) elements)) in
      let build () = node e.span ty (Tuple (List.map (fun (t : typed) -> t.build ()) elements)) in
      { ty; build }
  | Array elements -> array ctx e elements
  | Apply _ -> Infer_application.infer expressions (within ctx e) e
  | Negate { desc = Number n; _ } when Literal.is_only_negative n ->
      let ty, value = Literal.number ctx ~negative:true ~at:e.span n in
      { ty; build = (fun () -> node e.span ty (Number value)) }
  | Negate operand ->
      let ty = Context.fresh_number ctx in
      let because : Expected.reason =
        Parameter
          {
            callee = Some "-";
            head = None;
            at = e.span;
            position = 1;
            decided_by = [];
            takes = 1;
            given = [ operand ];
            before = None;
            of_local = None;
          }
      in
      let operand = check ctx operand { Expected.ty; because; parts = [] } in
      { ty; build = (fun () -> node e.span ty (Negate (operand ()))) }
  | Power { base; exponent } ->
      let typed = infer ctx base in
      let ty = power ctx base typed exponent in
      { ty; build = (fun () -> node e.span ty (Power (typed.build (), exponent))) }
  | Record { constructor; fields } ->
      Infer_record.construct expressions (within ctx e) e constructor fields
  | Field { record; field; candidates } ->
      Infer_record.field expressions ctx e ~record field ~candidates
  | Update { record; fields; candidates } ->
      Infer_record.update expressions ctx e ~record fields ~candidates
  | Annotated { expr; scheme } -> Infer_binding.annotated expressions ctx e expr scheme
  | If _ | Case _ | Let _ | Lambda _ | Proc _ | Sequence _ ->
      let ty = Context.fresh ctx in
      let build = check ctx e { Expected.ty; because = Unknown; parts = [] } in
      { ty; build }

and check ctx (e : Resolve.Ir.expr) (expected : Expected.t) : Ir.expr later =
  Degrees.warn ctx e expected;
  In_degrees.warn ctx e expected;
  match (e.desc, Type.expand expected.ty) with
  | If { condition; then_; else_ }, _ ->
      let condition = check ctx condition { Expected.ty = Bool; because = Condition; parts = [] } in
      let undecided = Infer_binding.undecided expected in
      let yes, held = hold ctx (fun () -> check ctx then_ expected) in
      pass_on ctx held;
      let expected = if is_told_of then_ held then anything expected else expected in
      let no = check ctx else_ (Infer_binding.beside ~undecided expected then_.span) in
      fun () ->
        let condition = condition () in
        let yes = yes () in
        node e.span expected.ty (If (condition, yes, no ()))
  | Case { scrutinee; branches }, _ -> case ctx e scrutinee branches expected
  | Let { declarations; body }, _ ->
      let bindings = Infer_binding.declarations expressions ctx declarations in
      let body = check ctx body expected in
      fun () ->
        let bindings = bindings () in
        node e.span expected.ty (Let (bindings, body ()))
  | Lambda { parameters; body }, _ ->
      Infer_binding.abstraction ctx ~at:e.span ~name:None ~is_proc:false parameters expected
        (fun expected -> check ctx body expected)
  | Proc { input; body }, _ -> proc ctx e input body expected
  | Sequence { statements; result }, _ ->
      Infer_sequence.check expressions ctx e statements result expected
  | Tuple [ a; b ], Tuple [ wanted_a; wanted_b ] -> pair ctx e (a, wanted_a) (b, wanted_b) expected
  | Tuple elements, Tuple types when List.compare_lengths elements types = 0 ->
      let elements =
        List.rev (List.rev_map2 (check ctx) elements (Reason.components expected types))
      in
      fun () -> node e.span expected.ty (Tuple (Long_list.map (fun build -> build ()) elements))
  | Array (_ :: _ as elements), Data { tycon; arguments = [ _; element ]; _ }
    when tycon = Environment.array ->
      let written = Type.Size (List.length elements) in
      if not (List.exists lacks_a_comma elements) then
        expect ctx ~subject:e ~at:e.span expected (Environment.array_of written element);
      let elements = array_elements ctx (Reason.part Of_array expected element) elements in
      fun () -> node e.span expected.ty (Array (Long_list.map (fun build -> build ()) elements))
  | Record { constructor; fields }, (Data { tycon; _ } as wanted)
    when tycon = (Environment.constructor ctx.reader.environment constructor).tycon ->
      (* report a mismatch at the field that causes it *)
      let ctx' = within ctx ~wanted e in
      let typed = Infer_record.construct expressions ctx' ~wanted e constructor fields in
      expect ctx ~subject:e ~at:e.span expected typed.ty;
      typed.build
  | Apply _, wanted ->
      let typed = Infer_application.infer expressions (within ctx ~wanted e) e in
      expect ctx ~subject:e ~at:e.span expected typed.ty;
      typed.build
  | _ ->
      let typed = infer ctx e in
      expect ctx ~subject:e ~at:e.span expected typed.ty;
      typed.build

(* Infers both components before checking them, because they may be swapped, for example an output
   and its event. Separate messages about the components would be confusing. *)
and pair ctx (e : Resolve.Ir.expr) (a, wanted_a) (b, wanted_b) (expected : Expected.t) =
  let inferred x = if is_inferred x then Some (infer ctx x) else None in
  let first = inferred a in
  let second = inferred b in
  let unfit ~wanted given = lacks_class ctx ~wanted given in
  let are_exchanged first second =
    Argument_order.pair_exchanged ~unfit ~wanted:(wanted_a, wanted_b) (first, second)
  in
  (* placeholder for the type of a component that is not known yet *)
  let anything = Type.Erroneous in
  let exchanged =
    match (first, second) with
    | None, None -> None
    | Some x, Some y -> if are_exchanged x.ty y.ty then Some (x, y) else None
    | Some x, None ->
        if not (are_exchanged x.ty anything) then None
        else
          let y = infer ctx b in
          if are_exchanged x.ty y.ty then Some (x, y) else None
    | None, Some y ->
        if not (are_exchanged anything y.ty) then None
        else
          let x = infer ctx a in
          if are_exchanged x.ty y.ty then Some (x, y) else None
  in
  match exchanged with
  | Some (x, y) ->
      tell ctx (Exchanged_pair { at = e.span; expected; first = (a, x.ty); second = (b, y.ty) });
      (* unify with the swapped types, to avoid further messages *)
      List.iter
        (fun (wanted, given) -> ignore (Unify.types wanted given))
        [ (wanted_a, y.ty); (wanted_b, x.ty) ];
      fun () -> node e.span expected.ty (Tuple [ x.build (); y.build () ])
  | None ->
      let fit x typed (expected : Expected.t) =
        match typed with
        | Some (typed : typed) ->
            Degrees.warn ctx x { expected with because = Unknown };
            In_degrees.warn ctx x { expected with because = Unknown };
            expect ctx ~subject:x ~at:x.span expected typed.ty;
            typed.build
        | None -> check ctx x expected
      in
      let first = fit a first (Reason.part (Of_tuple 1) expected wanted_a) in
      let second = fit b second (Reason.part (Of_tuple 2) expected wanted_b) in
      fun () ->
        let first = first () in
        node e.span expected.ty (Tuple [ first; second () ])

(* Is this an expression whose type is inferred before it is checked? *)
and is_inferred (e : Resolve.Ir.expr) =
  match e.desc with
  | If _ | Case _ | Let _ | Lambda _ | Proc _ | Sequence _ | Tuple _ | Array _ | Record _ -> false
  | _ -> true

(* Is this element like the one in `[1 2]`, where a comma is missing? If so, the mistake is reported
   at the number instead. *)
and lacks_a_comma (e : Resolve.Ir.expr) =
  match e.desc with
  | Apply { head = { desc = Number _; _ }; style = Juxtaposed; _ } -> true
  | Apply { head; style = Juxtaposed; _ } -> lacks_a_comma head
  | _ -> false

(* All elements must have the same type as the first one. *)
and array_elements ctx (expected : Expected.t) elements =
  let elements, besides = Long_list.split_at most_written elements in
  (match besides with
  | [] -> ()
  | first :: _ ->
      let length = most_written + List.length besides in
      tell ctx (Long_array { at = first.span; length; longest = most_written }));
  let check (done_, (expected : Expected.t)) (element : Resolve.Ir.expr) =
    let because : Expected.reason =
      match expected.because with Element _ as first -> first | _ -> Element element.span
    in
    let before = errors ctx in
    let element = check ctx element expected in
    let next = if errors ctx > before then expected else { expected with because; parts = [] } in
    (element :: done_, next)
  in
  List.rev (fst (List.fold_left check ([], expected) elements))

and array ctx (e : Resolve.Ir.expr) elements =
  if elements = [] then tell ctx (Empty_array e.span);
  let element = Context.fresh ctx in
  let ty = Environment.array_of (Size (max 1 (List.length elements))) element in
  let elements =
    array_elements ctx { Expected.ty = element; because = Unknown; parts = [] } elements
  in
  let build () = node e.span ty (Array (Long_list.map (fun build -> build ()) elements)) in
  { ty; build }

and case ctx e scrutinee branches expected =
  let value = infer ctx scrutinee in
  (* report a scrutinee of the wrong type once, not in every branch *)
  let matched = ref value.ty in
  let taken = ref [] in
  let branch (done_, expected) (b : Resolve.Ir.branch) =
    let before = errors ctx in
    let pattern =
      Infer_pattern.check ctx b.pattern
        { ty = !matched; because = Value scrutinee.span; parts = [] }
    in
    if errors ctx > before then matched := Type.Erroneous;
    let undecided = Infer_binding.undecided expected in
    let sound = errors ctx = before in
    let right, held = hold ctx (fun () -> Infer_binding.right expressions ctx b.right expected) in
    if sound then Taken_twice.tell ctx ~before ~held ~taken b value.ty branches
    else pass_on ctx held;
    let build () : Ir.branch =
      let pattern = pattern () in
      { pattern; value = right () }
    in
    (build :: done_, Infer_binding.beside ~undecided expected b.span)
  in
  let branches, _ = List.fold_left branch ([], expected) branches in
  fun () ->
    let value = value.build () in
    node e.span expected.ty (Case (value, List.rev_map (fun build -> build ()) branches))

and signals ctx (p : Resolve.Ir.pattern) =
  let found x =
    Option.map (fun (s : Type.scheme) -> (x.Ir.Local.name, s.body)) (find_local ctx x)
  in
  match p.desc with
  | Bound x -> Option.to_list (found x)
  | As (x, inner) -> Option.to_list (found x) @ signals ctx inner
  | Tuple_of ps | Array_of ps -> List.concat_map (signals ctx) ps
  | Any | Constructed _ | Literal _ -> []

and proc ctx e input body expected =
  let from, into =
    match Type.expand expected.ty with
    | Signal_function (a, b) -> (a, b)
    | _ ->
        let a = Context.fresh ctx and b = Context.fresh ctx in
        expect ctx ~subject:e ~at:e.span expected (Signal_function (a, b));
        (a, b)
  in
  let pattern = input in
  let input = Infer_pattern.check ctx input (Reason.part Of_input expected from) in
  let unnamed_input = match pattern.desc with Any -> Some pattern.span | _ -> None in
  let ctx = { ctx with inputs = signals ctx pattern; unnamed_input } in
  let equations = Infer_binding.declarations expressions ctx body.equations in
  let output =
    let expected = Reason.part Of_output expected into in
    check ctx body.output { expected with because = Output expected.because }
  in
  fun () ->
    let input = input () in
    let equations = equations () in
    node e.span expected.ty (Proc { input; equations; output = output () })

and expressions = { infer; check }
