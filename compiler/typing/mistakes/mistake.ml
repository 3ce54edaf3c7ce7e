open Basis
open Diagnostic

let of_two_modules words diagnostic =
  match Show.namesakes words with
  | [] -> diagnostic
  | name :: _ ->
      hint
        (Printf.sprintf
           "two types are called `%s`: use one in both places, or make a value of one from the \
            other's"
           name)
        diagnostic

(* A local function without a signature does for one type only. *)
let of_one_type words (expected : Expected.t) found diagnostic =
  let shown t = Show.described words t in
  let quantity t = match Type.expand t with Type.Number _ -> true | _ -> false in
  match expected.because with
  | Parameter { callee = Some name; of_local = Some first; _ }
    when not (String.equal (shown expected.ty) (shown found)) ->
      let variable = if quantity expected.ty && quantity found then "Float[u]" else "a" in
      label ~at:first
        (Printf.sprintf "because of this use of `%s`" name)
        { diagnostic with hints = []; fixes = [] }
      |> hint
           (Printf.sprintf
              "a local function without a signature has one type: give `%s` a signature with a \
               variable, of the form `%s :: %s -> …`"
              name name variable)
  | _ -> diagnostic

(* Where nothing better is known: which argument it is, and of what. *)
let by_signature words (expected : Expected.t) (d : Diagnostic.t) =
  match expected.because with
  | Parameter { head = Some { span; _ }; given; takes; _ }
    when List.length given > takes
         && Environment.is_task expected.ty
         && Span.line (List.nth given takes).span.start > Span.line span.stop ->
      hint "several tasks, one below the other, stand in a `do`, which opens their block"
        { d with hints = []; fixes = [] }
  | Parameter { head = Some { desc = Global g; _ }; given; takes; position; _ }
    when (d.hints = [] || (List.length given > takes && String.equal d.code "E0320"))
         && (takes > 1 || List.length given > takes)
         && (String.equal d.code "E0301"
            || List.length given > takes
            || (List.length given = 1 && takes = 2))
         && match g.name.[0] with 'a' .. 'z' -> true | _ -> false -> (
      match Show.declared words g with
      | Some ty ->
          hint
            (if List.length given > takes || (List.length given = 1 && takes = 2) then
               Printf.sprintf "`%s` takes %s, and is given %d: `%s :: %s`" g.name
                 (Unrun_mistake.count takes) (List.length given) g.name ty
             else
               Printf.sprintf "it stands in the place of argument %d: `%s :: %s`" position g.name ty)
            (if List.length given > takes then { d with hints = []; fixes = [] } else d)
      | None -> d)
  | _ -> d

(* Types with the same constructor outside: what is in them does not fit. *)
let alike a b =
  match (Type.expand a, Type.expand b) with
  | Data { tycon; _ }, Data { tycon = other; _ } -> tycon = other
  | Tuple ts, Tuple us -> List.compare_lengths ts us = 0
  | Number _, Number _ | Function _, Function _ | Signal_function _, Signal_function _ -> true
  | _ -> false

(* Which argument decided a variable matters where the variable does not fit. *)
let without_idle_deciders (expected : Expected.t) found (clash : Unify.clash) : Expected.t =
  let is_variable (t : Type.t) = match t with Flexible _ -> true | _ -> false in
  let of_sizes = match clash with Different (Size _, Size _) -> true | _ -> false in
  let matters ({ decides; a_size; _ } : Expected.decider) =
    a_size = of_sizes && (is_variable expected.ty || is_variable decides || alike expected.ty found)
  in
  match expected.because with
  | Parameter p ->
      { expected with because = Parameter { p with decided_by = List.filter matters p.decided_by } }
  | _ -> expected

let mismatch words owner ~subject ~at ~(expected : Expected.t) ~found (clash : Unify.clash) =
  let expected = without_idle_deciders expected found clash in
  (* names of signatures first, so that no invented name repeats one *)
  (match Show.described words expected.ty with
  | "a number" -> ()
  | _ -> ignore (Show.type_ words expected.ty));
  Show.tell_apart words [ expected.ty; found ];
  let finish diagnostic =
    Expected.explain_all words ~subject expected diagnostic
    |> of_one_type words expected found |> by_signature words expected |> of_two_modules words
  in
  match clash with
  | Different_units (wanted, given) -> (
      match Signature_mistake.promised_unit (wanted, given) with
      | Some (r, unit_) ->
          Signature_mistake.general_unit words owner ~at r unit_
          |> here (Printf.sprintf "this is %s" (Show.described words found))
      | None -> finish (Number_mistake.units words ~subject ~at ~expected ~found (wanted, given)))
  | Different_representations (Rigid_representation r, other)
  | Different_representations (other, Rigid_representation r) ->
      Signature_mistake.general_representation words owner ~at r other
  | Different_representations (wanted, given) ->
      let expected = Number_mistake.without_open_units expected in
      Number_mistake.representations words ~subject ~at ~expected ~found (wanted, given)
      |> Expected.explain_all words ~subject expected
  | Different (Rigid r, other) | Different (other, Rigid r) -> (
      match (Type.expand expected.ty, Type.expand found) with
      | (_, Signal_function _ | _, Function _) when Type.expand found == other ->
          finish (Shape_mistake.shapes words ~subject ~at ~expected ~found)
      | _ -> Signature_mistake.general_type words owner ~at r other)
  | Different _ -> finish (Shape_mistake.shapes words ~subject ~at ~expected ~found)
  | Infinite _ ->
      finish
        (error ~code:"E0305" ~at "this would need an infinite type: expected %s, found %s"
           (Show.described words expected.ty)
           (Show.described words found))
  | Escaping ->
      finish
        (error ~code:"E0306" ~at
           "a signature's variable cannot depend on what is outside: expected %s, found %s"
           (Show.described words expected.ty)
           (Show.described words found))
  | Out_of_range -> error ~code:"E0323" ~at "the exponent of a unit is too large"

let exchanged_pair words ~at (expected : Expected.t) ((a : Resolve.Ir.expr), first)
    ((b : Resolve.Ir.expr), second) =
  (* names of signatures first *)
  ignore (Show.type_ words expected.ty);
  let found = Type.Tuple [ first; second ] in
  let without_decider : Expected.reason -> Expected.reason = function
    | Parameter p -> Parameter { p with decided_by = [] }
    | because -> because
  in
  let expected = { expected with because = without_decider expected.because } in
  let d =
    error ~code:"E0301" ~at "the two of this pair stand in the other order"
    |> Expected.explain words expected
  in
  let of_signature =
    match expected.because with
    | Signature _ | Output (Signature _) -> ", or the signature has their types in the other order"
    | _ -> ""
  in
  match (Show.quote words a.span, Show.quote words b.span) with
  | Some a, Some b ->
      let text = Printf.sprintf "(%s, %s)" b a in
      hint (Printf.sprintf "write `%s`%s" text of_signature) d |> write at text
  | _ ->
      hint
        (Printf.sprintf "expected %s, found %s"
           (Show.described words expected.ty)
           (Show.described words found))
        d

(* {1 Heads} *)

let negative_argument words ~(minus : Span.t) ~operand (function_ : Resolve.Ir.expr) ty =
  (* of [1 x] in [f -1 x] *)
  let rec first (e : Resolve.Ir.expr) =
    match e.desc with Apply { head; style = Juxtaposed; _ } -> first head | _ -> e
  in
  let operand = Option.map first operand in
  let place = Option.map (fun (e : Resolve.Ir.expr) -> e.span) operand in
  let name = Option.value (Show.quote words function_.span) ~default:"f" in
  let operand = Option.value (Option.bind place (Show.quote words)) ~default:"1" in
  error ~code:"E0301" ~at:minus "this `-` subtracts from a function"
  |> label ~at:function_.span (Printf.sprintf "this is %s" (Show.described words ty))
  |> hint (Printf.sprintf "a negative argument needs parentheses: `%s (-%s)`" name operand)
  |> Option.fold place ~none:Fun.id ~some:(fun (at : Span.t) ->
         let place at = Span.make ~file:minus.file ~start:at ~stop:at in
         fix "put parentheses around it" [ (place minus.start, "("); (place at.stop, ")") ])

let is_digit c = c >= '0' && c <= '9'

let not_a_function words ~(head : Resolve.Ir.expr) ~position ~at left =
  let callee =
    match Plain_name.of_expr head with Some name -> "`" ^ name ^ "`" | None -> "this"
  in
  let diagnostic =
    if position = 1 then
      error ~code:"E0302" ~at:head.span "%s is %s, not a function" callee
        (Show.described words left)
      |> label ~at "it is given an argument here"
    else
      error ~code:"E0302" ~at "%s takes %d argument%s, but is given more" callee (position - 1)
        (if position = 2 then "" else "s")
      |> here "one too many"
      |> label ~at:head.span
           (Printf.sprintf "with %s the result is %s"
              (if position = 2 then "one argument" else Printf.sprintf "%d arguments" (position - 1))
              (Show.described words left))
  in
  match (Type.expand left, head.desc) with
  | _, Number { digits; _ } when position = 1 ->
      hint
        (Printf.sprintf
           "the elements of an array are separated by commas, factors by `*`: `[%s, …]`" digits)
        diagnostic
  | _, Field { record; field; _ } when position = 1 -> (
      let quote span = Show.quote words span in
      match (quote record.span, quote at) with
      | Some record, Some value ->
          hint
            (Printf.sprintf "nothing is set: a record with another `%s` is `%s { %s = %s }`"
               field.text (Source.grouped record) field.text value)
            diagnostic
      | _ -> diagnostic)
  | _, Global { name = ("mergeE" | "mergeR" | "min" | "max") as name; _ } when position = 3 ->
      hint (Printf.sprintf "of three it is `%s a (%s b c)`" name name) diagnostic
  | Data _, Global { name = "when" | "edge"; _ } when Environment.is_event left ->
      hint
        "it makes an event of a truth; a choice between two values is `if c then a else b`, and a \
         task that is done on a condition is `whenT c t`"
        diagnostic
  | Data { tycon; _ }, _ when tycon = Environment.array -> (
      (* all that is applied before it, and the index, perhaps in brackets of its own *)
      let applied = { head.span with stop = at.start } in
      let without_paren text =
        let n = String.length text in
        if n > 1 && text.[n - 1] = '(' then String.trim (String.sub text 0 (n - 1)) else text
      in
      let array = Option.map without_paren (Option.map String.trim (Show.quote words applied)) in
      let without_brackets text =
        let n = String.length text in
        if n > 2 && text.[0] = '[' && text.[n - 1] = ']' then String.sub text 1 (n - 2) else text
      in
      let index = Option.map without_brackets (Show.quote words at) in
      let written array index = Printf.sprintf "%s ! %s" array index in
      hint
        (Printf.sprintf "an element is `%s`, counted from 0"
           (written (Option.value array ~default:"xs") (Option.value index ~default:"0")))
        diagnostic
      |>
      match (array, index) with
      | Some array, Some index ->
          let text = written array index in
          fix (Printf.sprintf "write `%s`" text) [ (Span.merge head.span at, "(" ^ text ^ ")") ]
      | _ -> Fun.id)
  | _, Global { name = "integral"; _ } when position = 2 ->
      hint
        "it begins at 0: with another beginning it is `x0 + integral v`; to start it afresh at \
         each occurrence of an event, `resetOn integral (v, e)`"
        diagnostic
  | _, Global { name = ("integral" | "derivative" | "delay" | "time") as name; _ } when position > 1
    ->
      hint
        (Printf.sprintf "to start it afresh at each occurrence of an event: `resetOn %s (x, e)`"
           (if name = "delay" then "(delay x0)" else name))
        diagnostic
  | _ when Environment.is_task left && Span.line at.start > Span.line head.span.stop ->
      hint "several tasks, one below the other, stand in a `do`, which opens their block" diagnostic
  | _, Global g when Environment.is_task left && position > 1 && Show.declared words g <> None ->
      hint (Printf.sprintf "`%s :: %s`" g.name (Option.get (Show.declared words g))) diagnostic
  | _ when Environment.is_task left ->
      hint "a task is run by `runTask`: `runTask t` is a signal function" diagnostic
  | _, Local x when position = 1 -> (
      let d = label ~at:x.span (Printf.sprintf "this local `%s` is meant here" x.name) diagnostic in
      match (Type.expand left, Show.quote words at) with
      | (Number _ | Bool), Some text when d.hints = [] && not (is_digit text.[0]) ->
          hint
            (Printf.sprintf
               "two values stand in a tuple, `(%s, %s)`, or have an operator between them" x.name
               text)
            d
      | _ -> d)
  | _, Global g when position > 1 && diagnostic.hints = [] && Show.declared words g <> None ->
      hint (Printf.sprintf "`%s :: %s`" g.name (Option.get (Show.declared words g))) diagnostic
  | _ -> diagnostic

let applied_without_parentheses ~name ~inner ~whole (d : Diagnostic.t) =
  hint
    (if String.equal name "return" then
       Printf.sprintf
         "`return x` does nothing and ends with `x`: a task that is to be done stands there \
          without it, `%s`"
         inner
     else Printf.sprintf "what is applied stands in parentheses as an argument: `%s`" whole)
    { d with hints = []; fixes = [] }

let not_a_signal_function words ~(head : Resolve.Ir.expr) found =
  let diagnostic =
    error ~code:"E0304" ~at:head.span "`-<` needs a signal function, but this is %s"
      (Show.described words found)
  in
  match Type.expand found with
  | Function _ -> hint "`arr` makes a signal function of a function" diagnostic
  | _ -> diagnostic

let too_large ~at what =
  Diagnostic.error ~code:"E0316" ~at "the type of %s is too large" what
  |> Diagnostic.note
       (Printf.sprintf "a type has up to %d parts, nested up to %d deep" Final.most_parts
          Final.deepest)
