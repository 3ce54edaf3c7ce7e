open Basis
open Typing
open Typing.Ir

let listed ({ named; more } : Pattern_fact.missing) =
  Enumeration.some (List.map (Printf.sprintf "`%s`") named) ~more

(* A branch that binds a variable whose name, if capitalized, is the name of a constructor. *)
let taken_for_a_constructor (case : Pattern_fact.case) =
  let constructor name =
    let name = String.capitalize_ascii name in
    List.exists
      (fun (d : data) ->
        List.exists (fun (c : constructor) -> String.equal c.constructor.name name) d.constructors)
      case.data
  in
  List.find_map
    (fun (b : branch) ->
      match b.pattern.desc with
      | Bound local when constructor local.name ->
          Some (String.capitalize_ascii local.name, b.pattern.span)
      | _ -> None)
    case.branches

(* Not all numbers can be listed, so a number in an example represents many others. *)
let has_number text =
  let is_digit c = '0' <= c && c <= '9' in
  String.split_on_char ' ' (String.map (function '(' | '[' | ',' | '-' -> ' ' | c -> c) text)
  |> List.exists (fun word -> word <> "" && is_digit word.[0])

(* {1 Fixes for missing cases} *)

(* The end of the code or, if only a comment follows on that line, the end of the comment. *)
let end_of_line sources (at : Span.t) =
  let line = Span.line at.stop and column = Span.column at.stop in
  match Source.line sources at.file line with
  | Some text when column <= String.length text + 1 ->
      let rest = String.sub text (column - 1) (String.length text - column + 1) in
      if String.starts_with ~prefix:"--" (String.trim rest) then
        Span.position ~line ~column:(String.length text + 1)
      else at.stop
  | Some _ | None -> at.stop

(* Adds the fix that inserts these lines below the code, at this column. The values are `_`, which
   does not compile, so the user must fill them in. *)
let written sources ~below:(at : Span.t) ~column lines d =
  let line text = Printf.sprintf "\n%s%s" (String.make (max 0 (column - 1)) ' ') text in
  let stop = end_of_line sources at in
  let at = { at with start = stop; stop } in
  Diagnostic.fix "add the missing cases" [ (at, String.concat "" (List.map line lines)) ] d

(* Adds the fix with the missing branches. If not all of them can be listed, a `_` branch covers the
   rest. *)
let with_branches sources (case : Pattern_fact.case) (all : Pattern_fact.missing option) d =
  match (all, case.branches) with
  | Some { named; more }, first :: _ ->
      let numbers, others = List.partition has_number named in
      let patterns = if numbers = [] && more = 0 then others else others @ [ "_" ] in
      written sources ~below:case.at
        ~column:(Span.column first.pattern.span.start)
        (List.map (fun p -> p ^ " -> _") patterns)
        d
  | _ -> d

let with_otherwise sources ~arrow guarded d =
  match (guarded, List.rev guarded) with
  | ((first : expr), _) :: _, (_, (last : expr)) :: _ ->
      let column = Span.column first.span.start - String.length "| " in
      written sources ~below:last.span ~column [ Printf.sprintf "| otherwise %s _" arrow ] d
  | _ -> d

let rec guards_of (e : expr) =
  match e.desc with Guards (guarded, _) -> guarded | Let (_, body) -> guards_of body | _ -> []

(* {1 Messages} *)

let too_complex (case : Pattern_fact.case) =
  Diagnostic.(
    error ~code:"E0413" ~at:case.scrutinee.span
      "this `case` is too complex to check for missing branches"
    |> note "its patterns have too many combinations"
    |> hint "add a last branch `_ -> …`, or split this `case` into nested `case` expressions")

let missing sources (case : Pattern_fact.case) missing ~guarded_only ~listed:all =
  let d =
    Diagnostic.(
      error ~code:"E0350" ~at:case.scrutinee.span "this `case` does not cover every value"
      |> here "there is no branch for %s" (listed missing))
  in
  match (guarded_only, (missing : Pattern_fact.missing)) with
  | None, { named = [ one ]; more = 0 } when not (has_number one) ->
      Diagnostic.hint "add a branch `%s -> …`" one d |> with_branches sources case all
  | None, { named = one :: _; _ } ->
      Diagnostic.hint "add branches such as `%s -> …`, or `_ -> …` for all other values" one d
      |> with_branches sources case all
  | None, { named = []; _ } -> d
  | Some index, _ ->
      let b : branch = List.nth case.branches index in
      d
      |> Diagnostic.label ~at:b.pattern.span "all guards of this branch may fail"
      |> Diagnostic.hint "add a final guard, `| otherwise`"
      |> with_otherwise sources ~arrow:"->" (guards_of b.value)

let unreachable (case : Pattern_fact.case) (branch : branch) =
  Diagnostic.(
    warning ~code:"W0301" ~at:branch.pattern.span "this branch is never taken"
    |> here "the branches before it cover all its values"
    |>
    match taken_for_a_constructor case with
    | Some (name, (at : Span.t)) when Span.compare at branch.pattern.span < 0 ->
        fun d ->
          label ~at
            "this starts with a lower-case letter, so it is a variable that matches any value" d
          |> hint "for the constructor, write `%s`" name
          |> write at name
    | Some _ | None -> Fun.id)

let refutable (pattern : pattern) (of_ : Pattern_fact.refutable) (missing : Pattern_fact.missing) =
  let what =
    match of_ with
    | Equation -> "an equation"
    | Bind -> "a `<-`"
    | Function -> "a function"
    | Proc -> "a `proc`"
  in
  Diagnostic.(
    error ~code:"E0351" ~at:pattern.span "the pattern of %s must match every value" what
    |> here "does not match %s" (listed missing)
    |> hint "%s"
         (match missing.named with
         | one :: _ -> Printf.sprintf "use a `case`, with a branch for `%s` too" one
         | [] -> "use a `case`, with branches for all values"))

let guards_fail sources (guards : expr) guarded =
  Diagnostic.(
    error ~code:"E0352" ~at:guards.span "all these guards may fail"
    |> here "there is no value if they do"
    |> hint "add a final guard, `| otherwise`")
  |> with_otherwise sources ~arrow:"=" guarded

let matched_twice (constructor : Ir.Global.t) ~(first : Resolve.Ir.pattern)
    ~(second : Resolve.Ir.pattern) ~missing =
  Diagnostic.error ~code:"E0301" ~at:second.span "`%s` is matched twice, and `%s` is never matched"
    constructor.name missing
  |> Diagnostic.label ~at:first.span "this branch already matches every such value"
  |> Diagnostic.hint "if this branch is for the other values, write `%s`" missing

let diagnostic sources (fact : Pattern_fact.t) =
  match fact with
  | Too_complex case -> too_complex case
  | Missing { case; missing = values; guarded_only; listed } ->
      missing sources case values ~guarded_only ~listed
  | Unreachable { case; branch } -> unreachable case branch
  | Refutable { pattern; of_; missing } -> refutable pattern of_ missing
  | Guards_fail { guards; guarded } -> guards_fail sources guards guarded
