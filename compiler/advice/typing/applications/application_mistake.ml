open Basis
open Typing

type fact = {
  words : Wording.t;
  call : Application_fact.call;
  mistake : Diagnostic.t;  (** the message about the failing argument *)
  expects_number : bool;  (** whether the argument may be an [Int] or a [Float] *)
}

let failing { call; _ } = List.nth call.arguments (call.failed - 1)

(* Is the whole argument wrong, rather than a part of it? *)
let is_about_the_argument fact = Span.compare fact.mistake.at (fst (failing fact)).span = 0

(* {1 The order of the arguments} *)

(* The rotational speed of the wheels in place of the robot's speed, as in `setVelTR 40[rpm] 0`. *)
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
          let fixed = Printf.sprintf "(%s * 0.05[m])" text in
          Diagnostic.hint
            "if this is the speed of a wheel, multiply it by the radius of the wheel, as in `%s`; \
             if it is the turn rate, pass it as the second argument"
            fixed
            { d with Diagnostic.hints = []; fixes = [] })
        (Wording.quote words span)
  | _ -> None

(* Reports that the arguments are in the wrong order. [order] lists their positions, from 1, in the
   correct order. *)
let in_order words ~name ~at ~(arguments : Resolve.Ir.expr list) order (d : Diagnostic.t) =
  let text i =
    let (e : Resolve.Ir.expr) = List.nth arguments (i - 1) in
    Wording.argument words e
  in
  let texts = List.map text order in
  let d =
    Diagnostic.message "the arguments of `%s` are in the wrong order" name
      { d with at; here = None; labels = []; hints = []; fixes = [] }
  in
  let shown = List.map (Option.value ~default:"(…)") texts in
  let fixed = String.concat " " (name :: shown) in
  Diagnostic.hint "write `%s`" fixed d
  |> if List.mem None texts then Fun.id else Diagnostic.write at fixed

let exchange a b ~of_:n =
  List.init n (fun i ->
      let i = i + 1 in
      if i = a then b else if i = b then a else i)

(* Two arguments are swapped, the first argument comes last, or the last argument comes first. *)
let order ({ words; call; mistake; _ } as fact) =
  let arguments = List.map fst call.arguments in
  let exchanged =
    if Bare_number.is_per_millisecond words (fst (failing fact)) then None else call.exchanged
  in
  let order =
    match exchanged with
    | Some other -> Some (exchange call.failed other ~of_:(List.length arguments))
    | None -> call.rotated
  in
  match (call.head.desc, order) with
  | Global name, Some order when is_about_the_argument fact -> (
      match wheel_speed words ~name:name.name arguments with
      | Some complete -> Some (complete mistake)
      | None -> Some (in_order words ~name:name.name ~at:call.at ~arguments order mistake))
  | _ -> None

(* {1 A missing argument} *)

(* Does the value change from instant to instant, like a signal of the enclosing proc? *)
let rec is_signal words (e : Resolve.Ir.expr) =
  match e.desc with
  | Local x ->
      Wording.is_input words x.name
      || Option.fold (Wording.definition words x) ~none:false ~some:(is_signal words)
  | Field { record; _ } -> is_signal words record
  | Apply { head; argument; _ } -> is_signal words argument || is_signal words head
  | Negate e -> is_signal words e
  | _ -> false

(* An example value of this type. *)
let example words t =
  match Type.expand t with
  | Type.Number (_, u) when Units.is_open u || Units.rigid_powers u <> [] || Units.equal u Units.one
    ->
      Some "0"
  | Number (_, u) -> Some (Printf.sprintf "1[%s]" (Wording.measure words u))
  | Bool -> Some "False"
  | String -> Some "\"name\""
  | _ -> None

(* A call with too few arguments, such as `knob "speed" 0 1[m/s] i`, which lacks the initial
   value. *)
let lacking ({ words; call; mistake; _ } as fact) =
  let argument = fst (failing fact) in
  (* if a constant has the wrong unit, a missing argument is unlikely *)
  let is_likely = (not (String.equal mistake.code "E0320")) || is_signal words argument in
  match (call.head.desc, call.lacking) with
  | Global g, Some missing
    when is_likely && is_about_the_argument fact
         && not (List.mem (Shape_fact.Call g.name) (Diagnostic.topics mistake)) ->
      let arguments = List.map fst call.arguments in
      let quote (e : Resolve.Ir.expr) = Option.map Source.grouped (Wording.quote words e.span) in
      let before, after =
        ( List.filteri (fun i _ -> i < call.failed - 1) arguments,
          List.filteri (fun i _ -> i >= call.failed - 1) arguments )
      in
      let types = Option.fold (Wording.declared_type words g) ~none:[] ~some:Wording.parameters in
      let of_the_missing i _ = i >= call.failed - 1 && i < call.failed - 1 + missing in
      let example t =
        match (example words t, Type.expand t) with
        | None, (Rigid _ | Flexible _) when fact.expects_number && missing = 1 -> Some "0"
        | text, _ -> text
      in
      let examples = List.map example (List.filteri of_the_missing types) in
      let shown = Option.value (quote argument) ~default:"this argument" in
      let texts = List.map quote before @ examples @ List.map quote after in
      let written =
        if List.mem None texts || List.length types <> List.length texts then None
        else Some (String.concat " " (g.name :: List.filter_map Fun.id texts))
      in
      let d =
        Diagnostic.error ~code:"E0301" ~at:mistake.at "`%s` lacks %s before `%s`" g.name
          (if missing = 1 then "an argument" else Printf.sprintf "%d arguments" missing)
          shown
        |> Option.fold (Wording.declared words g) ~none:Fun.id ~some:(fun ty ->
               Diagnostic.label ~at:call.head.span "`%s :: %s`" g.name ty)
      in
      Some
        (match (written, examples) with
        | Some text, [ Some one ] ->
            Diagnostic.hint "write `%s`, with the value that you want in place of `%s`" text one d
            |> Diagnostic.write call.at text
        | Some text, _ -> Diagnostic.hint "write all arguments, as in `%s`" text d
        | None, _ -> d)
  | _ -> None

(* {1 Other rules} *)

(* `robotPose i.x`, where the field belongs to the result of the function or to a part of that
   result. *)
let field_of_the_result { words; call; mistake; _ } =
  match call.arguments with
  | ({ desc = Field { record; field; _ }; _ }, _) :: _
    when call.failed = 1 && String.equal mistake.code "E0310"
         && Span.compare mistake.at field.span = 0 -> (
      match
        ( Missing_field_mistake.path words call.result field.text,
          Wording.quote words call.head.span,
          Wording.quote words record.span )
      with
      | Some path, Some f, Some x ->
          let text = Printf.sprintf "(%s %s).%s" f x path in
          Some
            (Diagnostic.hint "field access binds tighter than function application: write `%s`" text
               { mistake with hints = []; notes = []; fixes = [] })
      | _ -> None)
  | _ -> None

(* Calls with the order or number of arguments that is usual in another language, such as `switch
   mode event next`. *)
let habit { words; call = { at; head; arguments; is_right_alone; _ }; _ } =
  match (head.desc, arguments) with
  | _ when not is_right_alone -> None
  | Global { name = ("switch" | "dSwitch") as name; _ }, _ :: _ :: _ :: _ ->
      Switch_mistake.three_arguments words ~name ~at arguments
  | Global { name = ("accum" | "accumHold" | "dAccumHold") as name; _ }, [ _; _; _ ] ->
      Event_mistake.accumulated words ~name ~at arguments
  | _ -> None

(* The number of arguments that a function of this type takes. *)
let rec arity t = match Type.expand t with Type.Function (_, result) -> 1 + arity result | _ -> 0
let rec final t = match Type.expand t with Type.Function (_, result) -> final result | _ -> t

(* Missing parentheses, as in `forever forward 1[m]`: a function among the arguments was meant to be
   applied to the arguments after it. *)
let parentheses ({ words; call; mistake; _ } as fact) =
  let { Application_fact.head; arguments; failed; _ } = call in
  let all = List.length arguments in
  let type_at i = snd (List.nth arguments (i - 1)) in
  (* Is this argument a tuple with one component for each parameter of the preceding function? *)
  let separates_arguments i =
    match (fst (List.nth arguments (i - 1))).desc with
    | Tuple (_ :: _ as parts) -> List.compare_length_with parts (arity (type_at (i - 1))) = 0
    | _ -> false
  in
  (* arguments on separate lines are more likely statements that lack a `do` *)
  let in_one_line =
    let (last : Resolve.Ir.expr), _ = List.nth arguments (all - 1) in
    Span.line head.span.start = Span.line last.span.stop
  in
  (* whether the next argument fits this function, as `d` fits `speed` in `setVelTR speed d 0` *)
  let takes_the_next =
    match ((fst (failing fact)).desc, Type.expand (type_at failed)) with
    | (Global _ | Local _), Function (parameter, _) when failed < all ->
        let is_defined_as_a_function =
          match (fst (failing fact)).desc with
          | Local x -> Option.is_none (Wording.definition words x)
          | _ -> true
        in
        is_defined_as_a_function
        && (Argument_order.may_be ~wanted:parameter (type_at (failed + 1))
           || separates_arguments (failed + 1))
    | _ -> false
  in
  let rec applied i =
    if i = 0 then None
    else
      let n = arity (type_at i) in
      if n > 0 && i < all then Some (i, if separates_arguments (i + 1) then 1 else min n (all - i))
      else applied (i - 1)
  in
  let quote = Wording.argument words in
  let texts = List.map (fun (e, _) -> quote e) arguments in
  (* rewrites `setVelTR(v, omega)` as `setVelTR v omega`, if the function does not take a tuple *)
  let without_commas i text =
    match (Type.expand (type_at i), fst (List.nth arguments i)) with
    | Function (parameter, _), { desc = Tuple (_ :: _ as parts); _ }
      when (match Type.expand parameter with Tuple _ -> false | _ -> true)
           && List.compare_length_with parts (arity (type_at i)) <= 0 -> (
        let of_part (e : Resolve.Ir.expr) =
          Option.bind (Wording.quote words e.span) Other_notation.expression
        in
        match List.map of_part parts with
        | parts when List.mem None parts -> text
        | parts -> String.concat " " (List.map (fun p -> Source.grouped (Option.get p)) parts))
    | _ -> text
  in
  match (applied failed, quote head) with
  | Some (i, n), Some name
    when (all > call.takes || takes_the_next)
         && in_one_line && is_about_the_argument fact
         && not (List.mem None texts) ->
      let texts = List.map Option.get texts in
      let texts = List.mapi (fun j text -> if j = i then without_commas i text else text) texts in
      let within = List.filteri (fun j _ -> j + 1 >= i && j + 1 <= i + n) texts in
      let inner = String.concat " " within in
      let before = List.filteri (fun j _ -> j + 1 < i) texts in
      let after = List.filteri (fun j _ -> j + 1 > i + n) texts in
      let value =
        if String.equal name "return" then Returned_value.diagnostic words ~at:head.span else None
      in
      if value <> None then value
      else
        let whole = String.concat " " ((name :: before) @ (("(" ^ inner ^ ")") :: after)) in
        let runs_a_task = Environment.is_task (final (type_at i)) in
        Some (Head_mistake.applied_without_parentheses ~name ~runs_a_task ~inner ~whole mistake)
  | _ -> None

(* The first rule that applies is used. [order] and [lacking] come last, because they only compare
   types. *)
let rules = [ field_of_the_result; habit; parentheses; order; lacking ]

let explain words call held =
  let mistake = Facts.diagnostic held in
  let expects_number =
    match Facts.fact held with
    | Fact.Inference { fact = Mismatch { expected; _ }; _ } ->
        String.equal mistake.code "E0301" && Wording.has_any_representation expected.ty
    | _ -> false
  in
  let fact = { words; call; mistake; expects_number } in
  Option.value (List.find_map (fun rule -> rule fact) rules) ~default:mistake

(* {1 Functions on arrays} *)

let parameters_in_other_order words ~(head : Resolve.Ir.expr) ~name (a : Resolve.Ir.pattern)
    (b : Resolve.Ir.pattern) =
  let at = Span.merge a.span b.span in
  Diagnostic.error ~code:"E0301" ~at "the parameters of this function are in the wrong order"
  |> Diagnostic.label ~at:head.span "%s" (Exchanged_parameters.order name)
  |>
  match (Wording.quote words a.span, Wording.quote words b.span) with
  | Some a, Some b ->
      let text = Printf.sprintf "%s %s" b a in
      fun d ->
        Diagnostic.hint "write `\\%s -> …`" text d
        |> Diagnostic.fix (Printf.sprintf "write `\\%s`" text) [ (at, text) ]
  | _ -> Diagnostic.hint "swap the parameters"

let mapped_range words ~at ~head (arguments : Resolve.Ir.expr list) =
  let texts = List.filter_map (fun (e : Resolve.Ir.expr) -> Wording.quote words e.span) arguments in
  let d =
    Diagnostic.error ~code:"E0301" ~at:head "`map` applies a function to each element of an array"
  in
  match Other_notation.expression ("map(" ^ String.concat ", " texts ^ ")") with
  | Some text when List.compare_lengths texts arguments = 0 ->
      Diagnostic.hint "to convert a number from one range to another, write `%s`" text d
      |> Diagnostic.write at (Source.grouped text)
  | Some _ | None ->
      Diagnostic.hint
        "to convert `x` from the range `a`–`b` to the range `c`–`d`, write `c + (x - a) * (d - c) \
         / (b - a)`"
        d
