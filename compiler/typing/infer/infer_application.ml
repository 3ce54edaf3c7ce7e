open Basis
open Argument
open Context

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

(* The number of arguments of the application. *)
let given : Expected.reason -> int = function Parameter { given; _ } -> List.length given | _ -> 2

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
    expect ctx ~subject:argument.value ~at:argument.value.span
      { ty = parameter; because; parts = [] }
      value.ty;
    expect ctx ~at:argument.span { ty = result; because = Unknown; parts = [] } output
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
             {
               head;
               position = argument.position;
               given = given because;
               argument = argument.value;
               ty = left;
             });
        fits Erroneous Erroneous;
        true
  in
  let guess () =
    let applied = Type.Function (value.ty, result) in
    expect ctx ~subject:head ~at:head.span
      { ty = applied; because = Unknown; parts = [] }
      function_.ty;
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
    let expected : Expected.t = { ty = parameter; because; parts = [] } in
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
        { ty = Signal_function (input, output); because = Unknown; parts = [] }
        function_.ty;
      known Runs input output
  | _, Erroneous -> erroneous ()
  | ( (Juxtaposed | Operator _),
      ((Rigid _ | Number _ | Bool | String | Tuple _ | Data _ | Size _ | Alias _) as left) ) ->
      tell ctx
        (Not_a_function
           {
             head;
             position = argument.position;
             given = given because;
             argument = argument.value;
             ty = left;
           });
      erroneous ()
  | ( Command,
      ((Rigid _ | Number _ | Bool | String | Tuple _ | Data _ | Size _ | Alias _ | Function _) as
       found) ) ->
      tell ctx (Not_a_signal_function { head; ty = found });
      erroneous ()

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
  if errors ctx = before + 1 then Misapplication.tell_method ctx e ~head arguments held
  else pass_on ctx held;
  inferred

type progress = {
  applied : typed;  (** the application to the arguments so far *)
  previous : (Resolve.Ir.expr * Type.t) option;  (** the last of these arguments, with its type *)
  types : Type.t list;  (** the types of the arguments, in reverse order *)
  failed : int option;  (** the position of the first argument with an error *)
  of_first : Fact.t Facts.held list;  (** the facts about the first argument *)
}

let infer expressions ctx e =
  let head, arguments = spine e in
  forgetting_what_errors_need ctx (fun () ->
      let function_ = infer_head expressions ctx e ~head arguments in
      let parameters = Argument_order.parameters function_.ty in
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
      (match progress.failed with
      | None -> pass_on ctx held
      | Some failed ->
          let { types; of_first; _ } = progress and is_only = errors ctx = before + 1 in
          Misapplication.tell expressions ctx e ~head arguments ~function_:function_.ty ~takes
            { failed; types = List.rev types; of_first; is_only }
            held);
      progress.applied)
