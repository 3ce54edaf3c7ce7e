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

let rec without_first n = function
  | _ :: rest when n > 0 -> without_first (n - 1) rest
  | list -> list

(* The types of the arguments after this one. *)
let later given argument = without_first argument.position given

(* The reason why the argument must have the parameter's type. *)
let reason ctx ~(head : Resolve.Ir.expr) ~takes ~arguments ~decided_by ~later ~before ~previous
    argument : Expected.reason =
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
          later;
          before;
          of_local = (match head.desc with Local x -> first_use ctx x ~at:head.span | _ -> None);
        }

type decision = Applies | Runs

(* The type of the result is already part of the function's type. *)
let apply decision span ty (function_ : Ir.expr) argument : Ir.expr =
  match (decision, function_.ty) with
  | Applies, Function (_, ty) ->
      let together = Side_by_side.of_application function_ argument in
      { desc = Option.value together ~default:(Ir.Apply (function_, argument)); ty; span }
  | Runs, Signal_function (_, ty) -> { desc = Run (function_, argument); ty; span }
  (* only after an error *)
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
        report ctx (fun words ->
            Head_mistake.not_a_function words ~head ~position:argument.position
              ~argument:argument.value left);
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
  (* Checks one argument. Returns the result of the application and the argument's type. *)
  let known decision parameter output =
    let before = errors ctx in
    let expected = Expected.make because parameter in
    let value =
      match argument.style with
      | Operator _ ->
          (* a mismatch with the other operand has a separate message *)
          let left_operand =
            match (argument.style, previous) with
            | Operator operator, None -> Some (argument.value, operator)
            | _ -> None
          in
          let value = expressions.infer { ctx with left_operand } argument.value in
          if negative && Option.is_none previous && is_function value.ty then
            report ctx (fun words ->
                Head_mistake.negative_argument words ~minus:head.span argument.value value.ty
                  ~operand)
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
      report ctx (fun words ->
          Head_mistake.not_a_function words ~head ~position:argument.position
            ~argument:argument.value left);
      erroneous ()
  | ( Command,
      ((Rigid _ | Number _ | Bool | String | Tuple _ | Data _ | Size _ | Alias _ | Function _) as
       found) ) ->
      report ctx (fun words -> Head_mistake.not_a_signal_function words ~head found);
      erroneous ()

(* `setVelTR 40[rpm] 0`: a rotation of the wheels as the speed. *)
let wheel_speed words ~name (arguments : Resolve.Ir.expr list) =
  match (name, arguments) with
  | ( "setVelTR",
      {
        desc = Number { unit_ = Some { factors = [ (Declared { name = "rpm"; _ }, _) ]; _ }; _ };
        span;
      }
      :: _ :: _ ) ->
      Option.map
        (fun text d ->
          let cure = Printf.sprintf "(%s * 0.05[m])" text in
          Diagnostic.hint
            (Printf.sprintf
               "for the speed of a wheel, multiply by its radius, as in `%s`; if it is the turn \
                rate, it is the second argument"
               cure)
            { d with Diagnostic.hints = []; fixes = [] })
        (Show.quote words span)
  | _ -> None

(* If one argument has the wrong type, perhaps two of them are swapped. [failed]: the position of
   that argument. [given]: the types of all arguments. *)
let tell_order expressions ctx (e : Resolve.Ir.expr) ~(head : Resolve.Ir.expr) arguments ~given
    ~failed =
  let sink = ctx.reader.Annotation.sink in
  let argument = List.nth arguments (failed - 1) in
  match (head.desc, Diagnostic.last sink) with
  | Global name, Some d
    when Span.compare d.at argument.value.span = 0
         && List.for_all (fun a -> a.style = Juxtaposed) arguments -> (
      match Resolve.Global_table.find_opt ctx.globals name with
      | None -> ()
      | Some { scheme; _ } ->
          let instance = Type.instantiate ctx.reader.supply ~depth:ctx.depth scheme in
          let found = (expressions.infer ctx argument.value).ty in
          (* an input never has type `String`: if one does, this application has just inferred it *)
          let is_input (e : Resolve.Ir.expr) =
            match e.desc with Local x -> List.mem_assoc x.name ctx.inputs | _ -> false
          in
          let given =
            List.mapi
              (fun i ty ->
                if i + 1 = failed then found
                else if Type.expand ty = String && is_input (List.nth arguments i).value then
                  Type.Erroneous
                else ty)
              given
          in
          let parameters = parameters instance.ty in
          let unfit ~wanted given =
            let lacks (class_, argument) =
              Type.expand argument == Type.expand wanted && has_no_instance ctx class_ given
            in
            List.exists lacks instance.required
          in
          let order =
            match
              if Bare_number.is_per_millisecond (words ctx) argument.value then None
              else Argument_order.exchanged ~unfit ~parameters ~given ~position:failed
            with
            | Some other -> Some (Argument_order.exchange failed other ~of_:(List.length arguments))
            | None -> Argument_order.rotated ~unfit ~parameters ~given
          in
          let cure order =
            let arguments = List.map (fun a -> a.value) arguments in
            match wheel_speed (words ctx) ~name:name.name arguments with
            | Some complete -> Diagnostic.revise_last sink complete
            | None ->
                Argument_order.cure (words ctx) ~name:name.name ~at:e.span ~arguments order
                |> Diagnostic.revise_last sink
          in
          Option.iter cure order)
  | _ -> ()

(* Explains calls that use the order or number of arguments of another language, as in `switch mode
   event next`. *)
let tell_habit expressions ctx (e : Resolve.Ir.expr) ~(head : Resolve.Ir.expr) arguments =
  let sink = ctx.reader.Annotation.sink in
  let before = errors ctx in
  let tell mistake =
    match Diagnostic.last sink with
    | Some d when List.for_all (fun a -> a.style = Juxtaposed) arguments ->
        let typed a = (a.value, (expressions.infer ctx a.value).ty) in
        let told = mistake (words ctx) ~at:e.span (List.map typed arguments) d in
        let is_told = errors ctx = before && told != d in
        if is_told then Diagnostic.revise_last sink (fun _ -> told);
        is_told
    | Some _ | None -> false
  in
  match (head.desc, arguments) with
  | Global { name = ("switch" | "dSwitch") as name; _ }, _ :: _ :: _ :: _ ->
      tell (Switch_mistake.three_arguments ~name)
  | Global { name = ("accum" | "accumHold" | "dAccumHold") as name; _ }, [ _; _; _ ] ->
      tell (Event_mistake.accumulated ~name)
  | _ -> false

(* Explains `xs.map f`, an array function that is called like a method. *)
let tell_method ctx (e : Resolve.Ir.expr) ~(head : Resolve.Ir.expr) arguments =
  let sink = ctx.reader.Annotation.sink in
  match (head.desc, Diagnostic.last sink) with
  | Field { record; field; _ }, Some d
    when Span.compare d.at field.span = 0 && Missing_field.is_of_arrays ctx field ->
      let words = words ctx in
      let quote (e : Resolve.Ir.expr) = Option.map Source.grouped (Show.quote words e.span) in
      let texts = List.map quote (List.map (fun a -> a.value) arguments @ [ record ]) in
      if not (List.mem None texts) then
        let text = String.concat " " (field.text :: List.map Option.get texts) in
        Diagnostic.revise_last sink (fun d ->
            Diagnostic.hint
              (Printf.sprintf "`%s` is a function: write `%s`" field.text text)
              { d with hints = []; fixes = [] }
            |> Diagnostic.fix (Printf.sprintf "write `%s`" text) [ (e.span, "(" ^ text ^ ")") ])
  | _ -> ()

(* Explains `robotPose i.x`, where the field belongs to the result of the function or to a part of
   that result. *)
let tell_tighter_field ctx ~(head : Resolve.Ir.expr) arguments ~failed result =
  let sink = ctx.reader.Annotation.sink in
  match ((List.nth arguments (failed - 1)).value.desc, Diagnostic.last sink) with
  | Field { record; field; _ }, Some d
    when String.equal d.code "E0310" && Span.compare d.at field.span = 0 && failed = 1 -> (
      let words = words ctx in
      match
        ( Missing_field.path ctx result field.text,
          Show.quote words head.span,
          Show.quote words record.span )
      with
      | Some path, Some f, Some x ->
          let text = Printf.sprintf "(%s %s).%s" f x path in
          Diagnostic.revise_last sink (fun d ->
              Diagnostic.hint
                (Printf.sprintf "a field binds tighter than application: write `%s`" text)
                { d with hints = []; notes = []; fixes = [] });
          true
      | _ -> false)
  | _ -> false

(* The number of arguments that a function of this type takes. *)
let rec arity t = match Type.expand t with Type.Function (_, result) -> 1 + arity result | _ -> 0

(* Explains missing parentheses, as in `forever forward 1[m]`: a function among the arguments was
   meant to be applied to the arguments after it. *)
let tell_parentheses expressions ctx ~(head : Resolve.Ir.expr) arguments ~given ~parameters ~failed
    =
  let sink = ctx.reader.Annotation.sink in
  let failing = List.nth arguments (failed - 1) in
  let all = List.length arguments in
  let type_at i =
    if i = failed then (expressions.infer ctx (List.nth arguments (i - 1)).value).ty
    else List.nth given (i - 1)
  in
  let is_reported (d : Diagnostic.t) = Span.compare d.at failing.value.span = 0 in
  (* arguments on separate lines are more likely statements that lack a `do` *)
  let in_one_line =
    let ends = (List.nth arguments (all - 1)).value.span.stop in
    Span.line head.span.start = Span.line ends
  in
  (* `setVelTR speed d 0`, where the next argument fits the function *)
  let takes_the_next =
    match (failing.value.desc, Type.expand (type_at failed)) with
    | (Global _ | Local _), Function (parameter, _) when failed < all ->
        let is_defined_as_a_function =
          match failing.value.desc with
          | Local x -> Option.is_none (Show.definition (words ctx) x)
          | _ -> true
        in
        is_defined_as_a_function && Argument_order.may_be ~wanted:parameter (type_at (failed + 1))
    | _ -> false
  in
  let rec applied i =
    if i = 0 then None
    else
      let n = arity (type_at i) in
      if n > 0 && i < all then Some (i, min n (all - i)) else applied (i - 1)
  in
  match Diagnostic.last sink with
  | Some d
    when (all > List.length parameters || takes_the_next)
         && in_one_line && is_reported d
         && List.for_all (fun a -> a.style = Juxtaposed) arguments -> (
      let words = words ctx in
      let quote (e : Resolve.Ir.expr) = Option.map Source.grouped (Show.quote words e.span) in
      let texts = List.map (fun a -> quote a.value) arguments in
      match (applied failed, quote head) with
      | Some (i, n), Some name when not (List.mem None texts) ->
          let texts = List.map Option.get texts in
          let within = List.filteri (fun j _ -> j + 1 >= i && j + 1 <= i + n) texts in
          let inner = String.concat " " within in
          let before = List.filteri (fun j _ -> j + 1 < i) texts in
          let after = List.filteri (fun j _ -> j + 1 > i + n) texts in
          let whole = String.concat " " ((name :: before) @ (("(" ^ inner ^ ")") :: after)) in
          Diagnostic.revise_last sink (Head_mistake.applied_without_parentheses ~name ~inner ~whole);
          true
      | _ -> false)
  | _ -> false

(* Explains `foldl (\x n -> n + x) 0 xs`, whose function has its parameters in the order of another
   language: tries whether the other order is right. *)
let tell_fold expressions ctx ~(head : Resolve.Ir.expr) arguments =
  match (head.desc, arguments) with
  | ( Global { name = ("foldl" | "scanl") as name; module_ = "Prelude" },
      ({ value = { desc = Lambda { parameters = [ a; b ]; body }; _ } as lambda; _ } as first)
      :: (_ :: _ as others) )
    when Span.compare a.span b.span < 0 ->
      let sink = ctx.reader.Annotation.sink in
      let value = { lambda with desc = Resolve.Ir.Lambda { parameters = [ b; a ]; body } } in
      let apply head { value; style; span; _ } : Resolve.Ir.expr =
        { desc = Apply { head; argument = value; style }; span }
      in
      let other = List.fold_left apply head ({ first with value } :: others) in
      let _, emitted = Diagnostic.trying sink (fun () -> expressions.infer ctx other) in
      let quote = Show.quote (words ctx) in
      let is_told =
        List.for_all (fun (d : Diagnostic.t) -> d.severity = Diagnostic.Warning) emitted
      in
      (if is_told then
         let at = Span.merge a.span b.span in
         Diagnostic.error ~code:"E0301" ~at "the parameters of this function are in the wrong order"
         |> Diagnostic.label ~at:head.span
              (Printf.sprintf "`%s` passes the result so far, and then an element" name)
         |> (match (quote a.span, quote b.span) with
            | Some a, Some b ->
                let text = Printf.sprintf "%s %s" b a in
                fun d ->
                  Diagnostic.hint (Printf.sprintf "write `\\%s -> …`" text) d
                  |> Diagnostic.fix (Printf.sprintf "write `\\%s`" text) [ (at, text) ]
            | _ -> Diagnostic.hint "swap the parameters")
         |> Diagnostic.replace_from sink lambda.span);
      is_told
  | _ -> false

(* `map x 0 1023 0 255` of Arduino *)
let tell_mapped ctx (e : Resolve.Ir.expr) ~(head : Resolve.Ir.expr) arguments =
  match (head.desc, arguments) with
  | Global { name = "map"; module_ = "Prelude" }, [ _; _; _; _; _ ] -> (
      let quote a = Show.quote (words ctx) a.value.span in
      let texts = List.filter_map quote arguments in
      match Syntax.Other_notation.expression ("map(" ^ String.concat ", " texts ^ ")") with
      | Some text when List.compare_lengths texts arguments = 0 ->
          Diagnostic.error ~code:"E0301" ~at:head.span
            "`map` applies a function to each element of an array"
          |> Diagnostic.hint
               (Printf.sprintf "to convert a number from one range to another, write `%s`" text)
          |> Diagnostic.write e.span (Source.grouped text)
          |> Diagnostic.replace_from ctx.reader.Annotation.sink e.span;
          true
      | Some _ | None -> false)
  | _ -> false

(* Improves the message about the argument that failed. *)
let tell expressions ctx e ~head arguments ~given ~parameters ~failed ty =
  let output =
    match Type.expand ty with
    | Function (_, output) | Signal_function (_, output) -> output
    | _ -> Type.Erroneous
  in
  let is_told =
    tell_tighter_field ctx ~head arguments ~failed output
    || tell_habit expressions ctx e ~head arguments
    || tell_parentheses expressions ctx ~head arguments ~given ~parameters ~failed
  in
  if not is_told then tell_order expressions ctx e ~head arguments ~given ~failed

let infer expressions ctx e =
  let head, arguments = spine e in
  let negative = looks_negative head arguments in
  let operand = match arguments with [ _; right ] -> Some right.value | _ -> None in
  let before argument =
    match ctx.left_operand with
    | Some (operand, operator) when operand == e && argument.span = e.span -> Some operator
    | Some _ | None -> None
  in
  let apply ~takes given (function_, previous) argument decided_by =
    match previous with
    | Some (_, left) when negative && is_function left ->
        (* `f -1`: the right operand was meant as an argument *)
        (function_, previous)
    | _ ->
        let later = later given argument in
        let because =
          reason ctx ~head ~takes ~arguments ~decided_by ~later ~before:(before argument) ~previous
            argument
        in
        let next, ty =
          step expressions ctx ~operand ~head ~negative ~because ~previous function_ argument
        in
        let next =
          if Degrees.keeps head then { next with ty = Degrees.kept next.ty ~operand:ty } else next
        in
        let next =
          match (argument.style, previous) with
          | Operator operator, Some left when In_degrees.meets operator ->
              let right = (argument.value, ty) in
              let build () =
                if Degrees.compares operator then Degrees.warn_of_operands ctx left right;
                In_degrees.warn_of_operands ctx left right;
                next.build ()
              in
              { next with build }
          | _ -> next
        in
        (next, Some (argument.value, ty))
  in
  forgetting_what_errors_need ctx (fun () ->
      let before = errors ctx in
      let start = expressions.infer ctx head in
      if errors ctx = before + 1 then tell_method ctx e ~head arguments;
      let parameters = parameters start.ty in
      let given =
        if List.compare_lengths parameters arguments <= 0 then parameters
        else List.filteri (fun i _ -> i < List.length arguments) parameters
      in
      let before = errors ctx in
      let apply (state, types, failed) argument decided_by =
        let next, previous =
          apply ~takes:(List.length parameters) given state argument decided_by
        in
        let ty = Option.fold previous ~none:Type.Erroneous ~some:snd in
        let failed =
          match failed with
          | None when errors ctx > before -> Some argument.position
          | failed -> failed
        in
        ((next, previous), ty :: types, failed)
      in
      let (result, _), types, failed =
        List.fold_left2 apply ((start, None), [], None) arguments (deciding parameters arguments)
      in
      (match failed with
      | Some _ when tell_mapped ctx e ~head arguments -> ()
      | Some _ when tell_fold expressions ctx ~head arguments -> ()
      | Some failed when errors ctx = before + 1 ->
          let given = List.rev types in
          tell expressions ctx e ~head arguments ~given ~parameters ~failed start.ty
      | _ -> ());
      result)
