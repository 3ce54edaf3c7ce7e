open Basis
open Typing
open Diagnostic

let negative_argument words ~(minus : Span.t) ~operand (function_ : Resolve.Ir.expr) ty =
  (* the operand [1] in [f -1 x] *)
  let rec first (e : Resolve.Ir.expr) =
    match e.desc with Apply { head; style = Juxtaposed; _ } -> first head | _ -> e
  in
  let operand = Option.map first operand in
  let place = Option.map (fun (e : Resolve.Ir.expr) -> e.span) operand in
  let name = Option.value (Wording.quote words function_.span) ~default:"f" in
  let operand = Option.value (Option.bind place (Wording.quote words)) ~default:"1" in
  error ~code:"E0301" ~at:minus "this `-` subtracts from a function"
  |> label ~at:function_.span "this is %s" (Wording.described words ty)
  |> hint "put the negative argument in parentheses: `%s (-%s)`" name operand
  |> Option.fold place ~none:Fun.id ~some:(fun (at : Span.t) ->
         let place at = Span.make ~file:minus.file ~start:at ~stop:at in
         fix "put parentheses around it" [ (place minus.start, "("); (place at.stop, ")") ])

(* {1 Not a function} *)

(* The head cannot take the argument at this position. *)
type fact = {
  words : Wording.t;
  head : Resolve.Ir.expr;
  position : int;  (** position of the argument, counted from 1 *)
  argument : Resolve.Ir.expr;
  at : Span.t;  (** the argument *)
  left : Type.t;  (** the type of the head applied to the preceding arguments *)
}

let not_taken fact =
  let callee =
    match Plain_name.of_expr fact.head with Some name -> "`" ^ name ^ "`" | None -> "this"
  in
  let left = Wording.described fact.words fact.left in
  match fact.position with
  | 1 ->
      error ~code:"E0302" ~at:fact.head.span "%s is %s, not a function" callee left
      |> label ~at:fact.at "it is applied to an argument here"
  | position ->
      error ~code:"E0302" ~at:fact.at "%s takes %d argument%s, but is applied to more" callee
        (position - 1)
        (if position = 2 then "" else "s")
      |> here "one too many"
      |> label ~at:fact.head.span "with %s, its result is %s"
           (if position = 2 then "one argument" else Printf.sprintf "%d arguments" (position - 1))
           left

(* {2 Rules}

   Each rule that applies returns a function that completes the message. *)

(* `[1, 2, 3]` for `[1 2 3]`, if the number is the first element of an array on one line, and the
   other elements are numbers or names. *)
let elements_without_commas fact =
  let sources = Wording.sources fact.words and at = fact.head.span in
  Option.bind (Source.text sources at.file) (fun text ->
      let first = Source.offset sources at.file at.start in
      match (Text_place.char_at text (first - 1), String.index_from_opt text first ']') with
      | '[', Some last ->
          (* a bracket that follows a digit belongs to a unit *)
          let rec closing last =
            match String.index_from_opt text (last + 1) ']' with
            | Some next when String.contains (String.sub text last (next - last)) '[' ->
                closing next
            | _ -> last
          in
          let last =
            if String.contains (String.sub text first (last - first)) '[' then
              Option.value (String.index_from_opt text (closing last + 1) ']') ~default:last
            else last
          in
          let inside = String.sub text first (last - first) in
          let is_plain c = Character.is_name c || String.contains ".[]/^ " c in
          if String.for_all is_plain inside && last <= Text_place.end_of_line text first then
            let all = List.filter (( <> ) "") (String.split_on_char ' ' inside) in
            let stop = Span.forward (last - first) at.start in
            Some ({ at with stop }, String.concat ", " all)
          else None
      | _ -> None)

(* `[1 2]`. *)
let after_a_number fact =
  match fact.head.desc with
  | Number _ when fact.position = 1 && elements_without_commas fact <> None ->
      Option.map
        (fun (place, elements) d ->
          hint "put commas between the elements: `[%s]`" elements d |> write place elements)
        (elements_without_commas fact)
  | Number { digits; unit_; _ } when fact.position = 1 ->
      let factor = if unit_ = None then Wording.quote fact.words fact.at else None in
      Some
        (hint "%s"
           (match factor with
           | Some text ->
               Printf.sprintf
                 "for a product, write `%s * %s`; for an array, put commas between the elements, \
                  as in `[%s, %s]`"
                 digits (Source.grouped text) digits text
           | None ->
               Printf.sprintf
                 "for an array, put commas between the elements, as in `[%s, …]`; for a product, \
                  put `*` between the factors"
                 digits))
  | _ -> None

(* `r.speed 1`, meant to set the field. *)
let after_a_field fact =
  match fact.head.desc with
  | Field { record; field; _ } when fact.position = 1 ->
      Some
        (match (Wording.quote fact.words record.span, Wording.quote fact.words fact.at) with
        | Some record, Some value ->
            hint "for a copy of the record with a different `%s`, write `%s { %s = %s }`" field.text
              (Source.grouped record) field.text value
        | _ -> Fun.id)
  | _ -> None

(* `limit` with two limits, as in `limit low high x`. *)
let of_two_limits fact =
  match fact.head.desc with
  | Global { name = "limit"; module_ = "Control"; _ } when fact.position = 3 ->
      let arguments = { fact.at with start = fact.head.span.stop } in
      Option.map
        (fun arguments ->
          (* the span of an argument excludes its parentheses *)
          let count c = List.length (String.split_on_char c arguments) in
          let text =
            "clamp " ^ String.trim arguments ^ String.make (max 0 (count '(' - count ')')) ')'
          in
          fun d ->
            hint "`limit` takes one limit for both directions; for two limits, write `%s`" text d
            |> write fact.head.span "clamp")
        (match Source.quote (Wording.sources fact.words) arguments with
        | Some text when String.length text < 90 -> Some text
        | Some _ | None -> None)
  | _ -> None

(* `when c a`, meant as a choice. *)
let event_as_choice fact =
  match (Type.expand fact.left, fact.head.desc) with
  | Data _, Global { name = "when" | "edge"; _ } when Environment.is_event fact.left ->
      Some
        (hint
           "for a choice between two values, write `if c then a else b`; for a task that runs only \
            if a condition holds, write `whenT c t`")
  | _ -> None

let without_paren text =
  let n = String.length text in
  if n > 1 && text.[n - 1] = '(' then String.trim (String.sub text 0 (n - 1)) else text

let without_brackets text =
  let n = String.length text in
  if n > 2 && text.[0] = '[' && text.[n - 1] = ']' then String.sub text 1 (n - 2) else text

(* The text without an unmatched closing parenthesis at its end, as in `sonars i)`. *)
let without_closing text =
  let count c = String.fold_left (fun n c' -> if c = c' then n + 1 else n) 0 text in
  let n = String.length text in
  if count ')' > count '(' && text.[n - 1] = ')' then String.trim (String.sub text 0 (n - 1))
  else text

(* An array applied to an index, as in `xs 0`, `xs(0)`, `xs [0]` or `(f x)[0]`. *)
let element fact =
  match Type.expand fact.left with
  | Data { tycon; _ } when tycon = Environment.array ->
      (* the array with any arguments before this one, and the index, which may be in brackets *)
      let applied = { fact.head.span with stop = fact.at.start } in
      let array =
        Wording.quote fact.words applied |> Option.map String.trim |> Option.map without_paren
      in
      let index = Option.map without_brackets (Wording.quote fact.words fact.at) in
      let index = Option.map Source.grouped index in
      let written array index = Printf.sprintf "%s ! %s" (without_closing array) index in
      let text = written (Option.value array ~default:"xs") (Option.value index ~default:"0") in
      let rewrite =
        match (array, index) with
        | Some array, Some index ->
            let edit =
              if String.equal array (without_closing array) then
                (Span.merge fact.head.span fact.at, "(" ^ text ^ ")")
              else (fact.at, " ! " ^ index)
            in
            fix (Printf.sprintf "write `%s`" text) [ edit ]
        | _ -> Fun.id
      in
      Some
        (fun d -> hint "write `%s` for that element; the first element is `! 0`" text d |> rewrite)
  | _ -> None

(* The text between the head and this argument. *)
let text_before fact =
  let between = { fact.at with start = fact.head.span.stop; stop = fact.at.start } in
  Option.map (fun text -> without_paren (String.trim text)) (Wording.quote fact.words between)

let is_zero text =
  let digits = List.hd (String.split_on_char '[' text) in
  float_of_string_opt digits = Some 0.

let is_a_time fact =
  match Bare_number.literal fact.words fact.argument with
  | Some { unit_ = Some { factors = [ (Declared { name = "s" | "ms"; _ }, _) ]; _ }; _ } -> true
  | _ -> false

(* `integral 0 v`, with an initial value as in other languages. *)
let initial_value fact =
  let argument = Option.map Source.grouped (Wording.quote fact.words fact.at) in
  match (fact.head.desc, text_before fact, argument) with
  | Global { name = ("integral" | "derivative") as name; _ }, Some before, Some argument
    when fact.position = 2 && (is_zero before || is_zero argument) ->
      let zero, signal = if is_zero before then (before, argument) else (argument, before) in
      let text = Printf.sprintf "%s %s" name signal in
      Some
        (fun d ->
          hint "remove the `%s`, because `%s` starts at 0 anyway: write `%s`" zero name text d
          |> write (Span.merge fact.head.span fact.at) text)
  | Global { name = "integral"; _ }, Some before, Some argument
    when fact.position = 2 && Character.is_digit before.[0] ->
      Some
        (hint
           "`integral` starts at 0: for another initial value, write `%s + integral %s`; to \
            restart it when an event occurs, write `resetOn integral (%s, e)`"
           before argument
           (Option.value (Wording.quote fact.words fact.at) ~default:"v"))
  | Global { name = "integral"; _ }, _, _ when fact.position = 2 && not (is_a_time fact) ->
      Some
        (hint
           "`integral` starts at 0: for another initial value, write `x0 + integral v`; to restart \
            it when an event occurs, write `resetOn integral (v, e)`")
  | _ -> None

(* Splits the text of two arguments at its only space outside brackets. *)
let two_arguments text =
  let rec spaces i depth found =
    if i >= String.length text then found
    else
      match text.[i] with
      | '(' | '[' -> spaces (i + 1) (depth + 1) found
      | ')' | ']' -> spaces (i + 1) (depth - 1) found
      | ' ' when depth = 0 -> spaces (i + 1) depth (i :: found)
      | _ -> spaces (i + 1) depth found
  in
  match spaces 0 0 [] with
  | [ i ] -> Some (String.sub text 0 i, String.sub text (i + 1) (String.length text - i - 1))
  | _ -> None

(* A function of two values applied to three, as in `min a b c`. *)
let of_three fact =
  match fact.head.desc with
  | Global { name = ("mergeE" | "mergeR" | "min" | "max") as name; _ } when fact.position = 3 ->
      let written =
        match (Option.bind (text_before fact) two_arguments, Wording.quote fact.words fact.at) with
        | Some (a, b), Some c -> Printf.sprintf "%s %s (%s %s %s)" name a name b (Source.grouped c)
        | _ -> Printf.sprintf "%s a (%s b c)" name name
      in
      Some (hint "for three values, write `%s`" written)
  | _ -> None

(* An extra argument to a prelude signal function: a time step, or an event that should restart
   it. *)
let started_afresh fact =
  match fact.head.desc with
  | Global { name = ("integral" | "derivative") as name; _ }
    when fact.position = 2 && is_a_time fact ->
      Some
        (fun d ->
          match Wording.quote fact.words fact.at with
          | Some text ->
              hint "remove `%s`: `%s` already uses the time between two instants" text name d
          | None -> d)
  | Global { name = ("integral" | "derivative" | "delay" | "time") as name; _ }
    when fact.position > 1 ->
      Some
        (hint "to restart it when an event occurs, write `resetOn %s (x, e)`"
           (if name = "delay" then "(delay x0)" else name))
  | _ -> None

(* Two tasks on separate lines, either without a `do`, or with the second task indented further. *)
let without_do fact =
  let column (span : Span.t) = Span.column span.start in
  if Environment.is_task fact.left && Span.line fact.at.start > Span.line fact.head.span.stop then
    Some
      (hint "%s"
         (match (Wording.quote fact.words fact.head.span, Wording.quote fact.words fact.at) with
         | Some head, Some next when column fact.at > column fact.head.span ->
             Printf.sprintf
               "this line is indented further than the line above, so it continues that line: \
                start `%s` at column %d, below `%s`; a sequence of tasks also needs a `do`"
               next (column fact.head.span) head
         | _ -> "put `do` before a sequence of tasks"))
  else None

(* `(x + 1)(x - 1)`, a product without its operator. *)
let after_a_formula fact =
  match (fact.head.desc, Type.expand fact.left) with
  | Global { name = "+" | "-" | "*" | "/"; _ }, Number _ when fact.position = 3 ->
      Option.map
        (fun text ->
          hint "a formula in parentheses is not a function: for a product, write `* %s` after it"
            (Source.grouped text))
        (Wording.quote fact.words fact.at)
  | _ -> None

(* Shows the signature of a definition that is applied to too many arguments. *)
let signature fact =
  match fact.head.desc with
  | Global g when fact.position > 1 ->
      Option.map (fun ty -> hint "`%s :: %s`" g.name ty) (Wording.declared fact.words g)
  | _ -> None

(* `driveTo goal i`, a task that is applied to the input like a signal function. *)
let task_of_the_input fact =
  let is_input (e : Resolve.Ir.expr) =
    match e.desc with Local x -> Wording.is_input fact.words x.name | _ -> false
  in
  if Environment.is_task fact.left && is_input fact.argument then
    let quote = Wording.quote fact.words in
    let task =
      match (quote fact.head.span, text_before fact) with
      | Some head, Some before -> Some (String.trim (head ^ " " ^ before))
      | Some head, None when fact.position = 1 -> Some head
      | _ -> None
    in
    Some (hint "%s" (Within_proc.no_tasks task))
  else None

let signature_of_task fact = if Environment.is_task fact.left then signature fact else None

(* A task applied to an input. *)
let task fact =
  if Environment.is_task fact.left then
    Some (hint "use `runTask t` to turn a task into a signal function")
  else None

(* `near implies (v == 0)`, a function between its arguments, without the backticks *)
let infix fact =
  let takes_two g =
    match Option.map Type.expand (Wording.declared_type fact.words g) with
    | Some (Function (_, result)) -> (
        match Type.expand result with Function _ -> true | _ -> false)
    | _ -> false
  in
  match (fact.head.desc, fact.argument.desc, Wording.quote fact.words fact.head.span) with
  | (Local _ | Number _), Global g, Some left when fact.position = 1 && takes_two g ->
      let fixed = Printf.sprintf "`%s`" g.name in
      Some
        (fun d ->
          hint "to write a function between its arguments, put it in backticks: ``%s %s …``" left
            fixed d
          |> write fact.argument.span fixed)
  | _ -> None

(* A local name, which may hide the function that was meant. *)
let local fact =
  match fact.head.desc with
  | Local x when fact.position = 1 ->
      let pair =
        match (Type.expand fact.left, Wording.quote fact.words fact.at) with
        | ((Number _ | Bool) as left), Some text when not (String.contains text '[') ->
            let operator = if left = Bool then "&&" else "*" in
            let text = Source.grouped text in
            hint
              "write an operator between the two values, as in `%s %s %s`; for a tuple, `(%s, %s)`"
              x.name operator text x.name text
        | _ -> Fun.id
      in
      Some (fun d -> label ~at:x.span "the name refers to this local `%s`" x.name d |> pair)
  | _ -> None

(* An event with a condition, as in `Event x when c`. *)
let event_when fact =
  match fact.head.desc with
  | Constructor { name = "Event"; module_ = "Prelude" }
    when List.mem (Wording.quote fact.words fact.at) [ Some "when"; Some "edge" ] ->
      Some
        (hint
           "for an event that has the value `x` and occurs whenever a condition is True, write \
            `tag (when condition) x`")
  | _ -> None

(* The first rule that applies is used. The rules for particular kinds of heads come first, then
   those for functions of the prelude, and then those for any task, local name or definition. *)
let rules =
  [
    event_when;
    after_a_number;
    after_a_field;
    after_a_formula;
    of_three;
    of_two_limits;
    event_as_choice;
    element;
    initial_value;
    started_afresh;
    without_do;
    task_of_the_input;
    signature_of_task;
    task;
    infix;
    local;
    signature;
  ]

let not_a_function words ~head ~position ~(argument : Resolve.Ir.expr) left =
  let fact = { words; head; position; argument; at = argument.span; left } in
  let complete = List.find_map (fun rule -> rule fact) rules in
  Option.value complete ~default:Fun.id (not_taken fact)

(* {1 Other mistakes} *)

let applied_without_parentheses ~name ~runs_a_task ~inner ~whole (d : Diagnostic.t) =
  hint "%s"
    (if String.equal name "return" && runs_a_task then
       Printf.sprintf "to run a task, remove `return`: `%s`" inner
     else Printf.sprintf "put parentheses around the argument: `%s`" whole)
    { d with hints = []; fixes = [] }

let not_a_signal_function words ~(head : Resolve.Ir.expr) found =
  let diagnostic =
    error ~code:"E0304" ~at:head.span "`-<` needs a signal function, but this is %s"
      (Wording.described words found)
  in
  match Type.expand found with
  | Function _ -> hint "use `arr` to turn a function into a signal function" diagnostic
  | _ -> diagnostic
