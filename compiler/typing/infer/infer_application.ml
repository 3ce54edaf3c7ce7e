open Basis
open Context

type argument = {
  value : Resolve.Ir.expr;
  style : Resolve.Ir.apply_style;
  span : Span.t;  (** span of the whole application *)
  position : int;  (** counted from 1 *)
}

(* Splits nested applications into the head and its arguments, first to last. *)
let spine (e : Resolve.Ir.expr) =
  let rec go (e : Resolve.Ir.expr) arguments =
    match e.desc with
    | Apply { head; argument; style } -> go head ((argument, style, e.span) :: arguments)
    | _ -> (e, arguments)
  in
  let head, arguments = go e [] in
  ( head,
    List.mapi (fun i (value, style, span) -> { value; style; span; position = i + 1 }) arguments )

let rec parameters (t : Type.t) =
  match Type.expand t with
  | Function (parameter, result) -> parameter :: parameters result
  | Signal_function (input, _) -> [ input ]
  | Flexible _ | Rigid _ | Number _ | Bool | String | Tuple _ | Data _ | Alias _ | Size _
  | Erroneous ->
      []

(* The unsolved type variables and unit variables of a type. *)
let rec flexible (t : Type.t) =
  match Type.expand t with
  | Flexible v -> ([ v ], [])
  | Number (_, u) -> ([], List.map fst (Units.flexible_powers (Units.resolve u)))
  | Tuple ts -> all_flexible ts
  | Function (a, b) | Signal_function (a, b) -> all_flexible [ a; b ]
  | Data { arguments; units; _ } ->
      let types, of_arguments = all_flexible arguments in
      let powers u = List.map fst (Units.flexible_powers (Units.resolve u)) in
      (types, of_arguments @ List.concat_map powers units)
  | Rigid _ | Bool | String | Size _ | Alias _ | Erroneous -> ([], [])

and all_flexible ts =
  let types, units = List.split (List.map flexible ts) in
  (List.concat types, List.concat units)

(* Maps each parameter to the earlier parameters that share a variable with it; parameters that
   consist of the variable alone come first. Call this while the function's type is still fully
   general. *)
let deciding parameters arguments =
  let rec of_parameters earlier parameters arguments =
    match (parameters, arguments) with
    | [], _ -> List.map (fun _ -> []) arguments
    | _, [] -> []
    | parameter :: parameters, argument :: arguments ->
        let types, units = flexible parameter in
        let decides ((types', units'), place, decides) : Expected.decider list =
          let shared = List.filter (fun v -> List.memq v types) types' in
          let is_size (v : Type.flexible) = v.kind = Of_sizes in
          let sizes, others = List.partition is_size shared in
          let decider a_size : Expected.decider = { place; decides; a_size } in
          (if sizes = [] then [] else [ decider true ])
          @
          if others <> [] || List.exists (fun u -> List.mem u units) units' then [ decider false ]
          else []
        in
        let decided_by = List.concat_map decides earlier in
        let this = ((types, units), argument.value.span, parameter) in
        let earlier =
          match Type.expand parameter with Flexible _ -> this :: earlier | _ -> earlier @ [ this ]
        in
        decided_by :: of_parameters earlier parameters arguments
  in
  of_parameters [] parameters arguments

(* The reason why the argument must have the type of the parameter. *)
let reason ctx ~(head : Resolve.Ir.expr) ~takes ~arguments ~decided_by ~before ~previous argument :
    Expected.reason =
  match (argument.style, previous) with
  | Operator operator, Some ((other : Resolve.Ir.expr), other_type) ->
      Operand { operator; other; other_type }
  | (Operator _ | Juxtaposed | Command), _ ->
      Parameter
        {
          callee = Plain_name.of_expr head;
          head = Some head;
          at = head.span;
          position = argument.position;
          decided_by;
          takes;
          given = List.map (fun a -> a.value) arguments;
          before;
          of_local = (match head.desc with Local x -> first_use ctx x ~at:head.span | _ -> None);
        }

type decision = Applies | Runs

(* The final type of the result is already part of the function's type. *)
let apply decision span ty (function_ : Ir.expr) argument : Ir.expr =
  match (decision, function_.ty) with
  | Applies, Function (_, ty) ->
      let together = Side_by_side.of_application function_ argument in
      { desc = Option.value together ~default:(Ir.Apply (function_, argument)); ty; span }
  | Runs, Signal_function (_, ty) -> { desc = Run (function_, argument); ty; span }
  (* this happens only after an error *)
  | Applies, _ -> node span ty (Apply (function_, argument))
  | Runs, _ -> node span ty (Run (function_, argument))

(* Postpones the decision between application and run, because the head's type is not known yet. *)
let put_off expressions ctx ~head ~because argument (function_ : typed) =
  let value = expressions.infer ctx argument.value in
  let result = Context.fresh ctx in
  let decision = ref Applies in
  let fits parameter output =
    expect ctx ~subject:argument.value ~at:argument.value.span { ty = parameter; because } value.ty;
    expect ctx ~at:argument.span { ty = result; because = Unknown } output
  in
  let attempt () =
    match Type.expand function_.ty with
    | Flexible _ -> false
    | Function (parameter, output) ->
        fits parameter output;
        true
    | Signal_function (input, output) ->
        decision := Runs;
        fits input output;
        true
    | Erroneous ->
        fits Erroneous Erroneous;
        true
    | (Rigid _ | Number _ | Bool | String | Tuple _ | Data _ | Size _ | Alias _) as left ->
        tell ctx
          (Not_a_function
             { head; position = argument.position; argument = argument.value; ty = left });
        fits Erroneous Erroneous;
        true
  in
  let guess () =
    let applied = Type.Function (value.ty, result) in
    expect ctx ~subject:head ~at:head.span { ty = applied; because = Unknown } function_.ty;
    true
  in
  ask ctx { attempt; guess; give_up = ignore };
  let build () = apply !decision argument.span result (function_.build ()) (value.build ()) in
  ({ ty = result; build }, value.ty)

(* Is this `f -1`, with a minus that touches only its right operand? *)
let looks_negative (head : Resolve.Ir.expr) arguments =
  match arguments with
  | [ ({ style = Operator "-"; _ } as left); right ] ->
      let right_start = right.value.span.start and left_stop = left.value.span.stop in
      head.span.stop = right_start
      && Span.line left_stop = Span.line head.span.start
      && Span.column left_stop < Span.column head.span.start
  | _ -> false

let is_function t = match Type.expand t with Type.Function _ -> true | _ -> false

let step expressions ctx ~operand ~(head : Resolve.Ir.expr) ~negative ~because ~previous
    (function_ : typed) argument =
  (* Checks one argument. Returns the result of the application, and the type of the argument. *)
  let known decision parameter output =
    let before = errors ctx in
    let expected : Expected.t = { ty = parameter; because } in
    let value =
      match argument.style with
      | Operator _ ->
          (* a mismatch between the two operands has a message of its own *)
          let left_operand =
            match (argument.style, previous) with
            | Operator operator, None -> Some (argument.value, operator)
            | _ -> None
          in
          let value = expressions.infer { ctx with left_operand } argument.value in
          if negative && Option.is_none previous && is_function value.ty then
            tell ctx
              (Negative_argument
                 { minus = head.span; operand; function_ = argument.value; ty = value.ty })
          else expect ctx ~subject:argument.value ~at:argument.value.span expected value.ty;
          value
      | Juxtaposed when Degrees.keeps head ->
          let value = expressions.infer ctx argument.value in
          expect ctx ~subject:argument.value ~at:argument.value.span expected value.ty;
          value
      | Juxtaposed | Command ->
          { ty = parameter; build = expressions.check ctx argument.value expected }
    in
    let ty = if errors ctx > before then Type.Erroneous else output in
    let build () = apply decision argument.span ty (function_.build ()) (value.build ()) in
    ({ ty; build }, value.ty)
  in
  let erroneous () =
    let value = expressions.infer ctx argument.value in
    ({ ty = Type.Erroneous; build = value.build }, value.ty)
  in
  match (argument.style, Type.expand function_.ty) with
  | (Juxtaposed | Operator _), Function (parameter, output) -> known Applies parameter output
  | (Juxtaposed | Operator _ | Command), Signal_function (input, output) -> known Runs input output
  | (Juxtaposed | Operator _), Flexible _ ->
      put_off expressions ctx ~head ~because argument function_
  | Command, Flexible _ ->
      let input = Context.fresh ctx and output = Context.fresh ctx in
      expect ctx ~at:head.span
        { ty = Signal_function (input, output); because = Unknown }
        function_.ty;
      known Runs input output
  | _, Erroneous -> erroneous ()
  | ( (Juxtaposed | Operator _),
      ((Rigid _ | Number _ | Bool | String | Tuple _ | Data _ | Size _ | Alias _) as left) ) ->
      tell ctx
        (Not_a_function { head; position = argument.position; argument = argument.value; ty = left });
      erroneous ()
  | ( Command,
      ((Rigid _ | Number _ | Bool | String | Tuple _ | Data _ | Size _ | Alias _ | Function _) as
       found) ) ->
      tell ctx (Not_a_signal_function { head; ty = found });
      erroneous ()

(* {1 Explaining a mistake in terms of the whole application} *)

(* Does the fact concern the whole argument at this place, not only a part of it? *)
let is_at (span : Span.t) (fact : Fact.t) =
  match fact with
  | Inference { fact = Mismatch { at; _ } | Exchanged_pair { at; _ }; _ } ->
      Span.compare at span = 0
  | Inference { fact = Not_a_function { argument; _ }; _ } -> Span.compare argument.span span = 0
  | _ -> false

(* The argument orders in which the types fit, and the number of missing arguments, for
   {!Application_fact.call}. *)
let orders ctx ~(head : Resolve.Ir.expr) arguments ~types ~failed =
  let entry =
    match head.desc with Global name -> Resolve.Global_table.find_opt ctx.globals name | _ -> None
  in
  match entry with
  | None -> (None, None, None)
  | Some { scheme; _ } ->
      let instance = Type.instantiate ctx.reader.supply ~depth:ctx.depth scheme in
      (* an input cannot be a `String`, so a type `String` was inferred only from this application
         *)
      let is_input (e : Resolve.Ir.expr) =
        match e.desc with Local x -> List.mem_assoc x.name ctx.inputs | _ -> false
      in
      let is_other a = a.position <> failed in
      let given =
        List.map2
          (fun a ty ->
            if is_other a && Type.expand ty = String && is_input a.value then Type.Erroneous else ty)
          arguments types
      in
      let parameters = parameters instance.ty in
      let unfit ~wanted given =
        let lacks (class_, argument) =
          Type.expand argument == Type.expand wanted && has_no_instance ctx class_ given
        in
        List.exists lacks instance.required
      in
      (* an input of the proc is probably meant as the input of the signal function *)
      let runs_on_an_input =
        let rec is_run (t : Type.t) =
          match Type.expand t with
          | Function (_, t) -> is_run t
          | Signal_function _ -> true
          | _ -> false
        in
        is_run instance.ty && is_input (List.nth arguments (failed - 1)).value
      in
      let is_constrained ty =
        runs_on_an_input
        || List.exists
             (fun (_, argument) -> Type.expand argument == Type.expand ty)
             instance.required
      in
      ( Argument_order.exchanged ~unfit ~parameters ~given ~position:failed,
        Argument_order.rotated ~unfit ~parameters ~given,
        Argument_order.shifted ~unfit ~is_constrained ~parameters ~given ~position:failed )

(* The application, if it may explain the mistake better than the failing argument does. *)
let call expressions ctx (e : Resolve.Ir.expr) ~head arguments ~types ~takes ~failed result mistake
    : Application_fact.call option =
  let failing = (List.nth arguments (failed - 1)).value in
  let juxtaposed = List.for_all (fun a -> a.style = Juxtaposed) arguments in
  let is_whole = is_at failing.span mistake in
  let is_field =
    match mistake with
    | Inference { fact = Missing_field _ | Unknown_field _; _ } -> true
    | _ -> false
  in
  if not (juxtaposed && (is_whole || is_field || List.length arguments >= 3)) then None
  else
    let own, is_right_alone = trial ctx (fun () -> (expressions.infer ctx failing).ty) in
    let types = List.mapi (fun i ty -> if i + 1 = failed then own else ty) types in
    let exchanged, rotated, lacking =
      if is_whole then orders ctx ~head arguments ~types ~failed else (None, None, None)
    in
    Some
      {
        at = e.span;
        head;
        arguments = List.map2 (fun a ty -> (a.value, ty)) arguments types;
        failed;
        is_right_alone;
        takes;
        result;
        exchanged;
        rotated;
        lacking;
      }

(* Explains the only error among the arguments. *)
let tell expressions ctx e ~head arguments ~types ~takes ~failed ty held =
  match List.rev held with
  | [] -> ()
  | last :: others -> (
      let result =
        match Type.expand ty with
        | Function (_, output) | Signal_function (_, output) -> output
        | _ -> Type.Erroneous
      in
      match
        call expressions ctx e ~head arguments ~types ~takes ~failed result (Facts.fact last)
      with
      | Some call ->
          pass_on ctx (List.rev others);
          replace ctx (Misapplied { around = surroundings ctx; call; mistake = last })
      | None -> pass_on ctx held)

(* Explains `xs.map f`, where an array function is called like a method. *)
let tell_method ctx (e : Resolve.Ir.expr) ~(head : Resolve.Ir.expr) arguments held =
  match (head.desc, List.rev held) with
  | Field { record; field; _ }, last :: others -> (
      match Facts.fact last with
      | Fact.Inference
          { fact = Missing_field { field = missing; _ } | Unknown_field { field = missing; _ }; _ }
        when missing == field ->
          pass_on ctx (List.rev others);
          let arguments = List.map (fun a -> a.value) arguments in
          let call : Application_fact.method_call = { at = e.span; record; field; arguments } in
          replace ctx (Called_as_method { around = surroundings ctx; call; mistake = last })
      | _ -> pass_on ctx held)
  | _ -> pass_on ctx held

(* Recognizes `foldl (\x n -> n + x) 0 xs`, where the function takes its parameters in the order
   that some other languages use. Checks whether swapping them would fix the mistake. *)
let other_fold expressions ctx ~(head : Resolve.Ir.expr) arguments : Inference_fact.t option =
  match (head.desc, arguments) with
  | ( Global { name = ("foldl" | "scanl") as name; module_ = "Prelude" },
      ({ value = { desc = Lambda { parameters = [ a; b ]; body }; _ } as lambda; _ } as first)
      :: (_ :: _ as others) )
    when Span.compare a.span b.span < 0 ->
      let value = { lambda with desc = Resolve.Ir.Lambda { parameters = [ b; a ]; body } } in
      let apply head { value; style; span; _ } : Resolve.Ir.expr =
        { desc = Apply { head; argument = value; style }; span }
      in
      let other = List.fold_left apply head ({ first with value } :: others) in
      let _, is_right = trial ctx (fun () -> expressions.infer ctx other) in
      if is_right then Some (Parameters_in_other_order { head; name; first = a; second = b })
      else None
  | _ -> None

let is_mapped_range ~(head : Resolve.Ir.expr) arguments =
  match (head.desc, arguments) with
  | Global { name = "map"; module_ = "Prelude" }, [ _; _; _; _; _ ] -> true
  | _ -> false

(* {1 Applying to one argument at a time} *)

(* The operator that follows the application to this argument. *)
let operator_after ctx (e : Resolve.Ir.expr) argument =
  match ctx.left_operand with
  | Some (operand, operator) when operand == e && argument.span = e.span -> Some operator
  | Some _ | None -> None

(* Adds a warning about operands in degrees, which is issued when the application is built. *)
let warning_of_degrees ctx argument ty ~previous (applied : typed) =
  match (argument.style, previous) with
  | Operator operator, Some left when In_degrees.meets operator ->
      let right = (argument.value, ty) in
      let build () =
        if Degrees.compares operator then Degrees.warn_of_operands ctx left right;
        In_degrees.warn_of_operands ctx left right;
        applied.build ()
      in
      { applied with build }
  | _ -> applied

(* Applies to the next argument. [previous]: the argument before it, with its type. *)
let apply_to_next expressions ctx e ~head arguments ~takes (function_, previous) argument decided_by
    =
  let negative = looks_negative head arguments in
  match previous with
  | Some (_, left) when negative && is_function left ->
      (* `f -1`: the right operand was meant as an argument *)
      (function_, previous)
  | _ ->
      let before = operator_after ctx e argument in
      let because = reason ctx ~head ~takes ~arguments ~decided_by ~before ~previous argument in
      let operand = match arguments with [ _; right ] -> Some right.value | _ -> None in
      let applied, ty =
        step expressions ctx ~operand ~head ~negative ~because ~previous function_ argument
      in
      let applied =
        if Degrees.keeps head then { applied with ty = Degrees.kept applied.ty ~operand:ty }
        else applied
      in
      (warning_of_degrees ctx argument ty ~previous applied, Some (argument.value, ty))

let infer_head expressions ctx e ~head arguments =
  let before = errors ctx in
  let inferred, held = hold ctx (fun () -> expressions.infer ctx head) in
  if errors ctx = before + 1 then tell_method ctx e ~head arguments held else pass_on ctx held;
  inferred

type progress = {
  applied : typed;  (** the application to the arguments so far *)
  previous : (Resolve.Ir.expr * Type.t) option;  (** the last of these arguments, with its type *)
  types : Type.t list;  (** the types of the arguments, in reverse order *)
  failed : int option;  (** the position of the first argument with an error *)
  of_first : Fact.t Facts.held list;  (** the facts about the first argument *)
}

(* Replaces the facts about the arguments by one about the whole application, if that explains the
   mistake better. [is_only]: whether there is exactly one error. *)
let explain expressions ctx (e : Resolve.Ir.expr) ~(head : Resolve.Ir.expr) arguments ~function_
    ~takes ~is_only progress held =
  let replace_by fact ~kept =
    pass_on ctx kept;
    replace ctx (Inference { around = surroundings ctx; fact })
  in
  match progress.failed with
  | None -> pass_on ctx held
  | Some _ when is_mapped_range ~head arguments ->
      let arguments = List.map (fun a -> a.value) arguments in
      replace_by (Mapped_range { at = e.span; head = head.span; arguments }) ~kept:[]
  | Some failed -> (
      match other_fold expressions ctx ~head arguments with
      | Some fact ->
          let is_kept h = not (List.memq h progress.of_first) in
          replace_by fact ~kept:(List.filter is_kept held)
      | None when is_only ->
          let types = List.rev progress.types in
          tell expressions ctx e ~head arguments ~types ~takes ~failed function_ held
      | None -> pass_on ctx held)

let infer expressions ctx e =
  let head, arguments = spine e in
  forgetting_what_errors_need ctx (fun () ->
      let function_ = infer_head expressions ctx e ~head arguments in
      let parameters = parameters function_.ty in
      let takes = List.length parameters in
      let before = errors ctx in
      let next { applied; previous; types; failed; of_first } argument decided_by =
        let (applied, previous), held =
          hold ctx (fun () ->
              apply_to_next expressions ctx e ~head arguments ~takes (applied, previous) argument
                decided_by)
        in
        pass_on ctx held;
        let ty = Option.fold previous ~none:Type.Erroneous ~some:snd in
        let failed =
          if Option.is_none failed && errors ctx > before then Some argument.position else failed
        in
        let of_first = if argument.position = 1 then held else of_first in
        { applied; previous; types = ty :: types; failed; of_first }
      in
      let start =
        { applied = function_; previous = None; types = []; failed = None; of_first = [] }
      in
      let progress, held =
        hold ctx (fun () -> List.fold_left2 next start arguments (deciding parameters arguments))
      in
      let is_only = errors ctx = before + 1 in
      explain expressions ctx e ~head arguments ~function_:function_.ty ~takes ~is_only progress
        held;
      progress.applied)
