open Basis
open Ir

type walk = {
  sink : Diagnostic.sink;
  sources : Source.t;
  data : data list;
  coverage : Coverage.t;
  mutable left : int; (* remaining steps *)
}

(* The number of combinations of patterns is exponential in the number of columns. *)
let most_steps_of_one = 3_000_000
let most_steps = 8_000_000

let within w check =
  let before = Work.left () in
  let checked = Work.within (Int.min most_steps_of_one w.left) check in
  w.left <- w.left - (before - Work.left ());
  checked

(* Can all guards at the end of a right-hand side fail? *)
let rec falls (e : expr) =
  match e.desc with Guards (_, None) -> true | Let (_, body) -> falls body | _ -> false

let listed ({ named; more } : Coverage.missing) =
  Enumeration.some (List.map (Printf.sprintf "`%s`") named) ~more

(* A branch that binds a variable whose name, if capitalized, is the name of a constructor. *)
let taken_for_a_constructor w (branches : branch list) =
  let constructor name =
    let name = String.capitalize_ascii name in
    List.exists
      (fun (d : data) ->
        List.exists (fun (c : constructor) -> String.equal c.constructor.name name) d.constructors)
      w.data
  in
  List.find_map
    (fun (b : branch) ->
      match b.pattern.desc with
      | Bound local when constructor local.name ->
          Some (String.capitalize_ascii local.name, b.pattern.span)
      | _ -> None)
    branches

(* Numbers cannot be listed completely, so a number in an example represents many others. *)
let has_number text =
  let is_digit c = '0' <= c && c <= '9' in
  String.split_on_char ' ' (String.map (function '(' | '[' | ',' | '-' -> ' ' | c -> c) text)
  |> List.exists (fun word -> word <> "" && is_digit word.[0])

(* {1 Fixes for missing cases} *)

(* The end of the line after the code, or after a comment on that line. *)
let end_of_line w (at : Span.t) =
  let line = Span.line at.stop and column = Span.column at.stop in
  match Source.line w.sources at.file line with
  | Some text when column <= String.length text + 1 ->
      let rest = String.sub text (column - 1) (String.length text - column + 1) in
      if String.starts_with ~prefix:"--" (String.trim rest) then
        Span.position ~line ~column:(String.length text + 1)
      else at.stop
  | Some _ | None -> at.stop

(* Adds the fix that inserts these lines below the code, at this column. The values are `_`, which
   does not compile, so the user must fill them in. *)
let written w ~below:(at : Span.t) ~column lines d =
  let line text = Printf.sprintf "\n%s%s" (String.make (max 0 (column - 1)) ' ') text in
  let stop = end_of_line w at in
  let at = { at with start = stop; stop } in
  Diagnostic.fix "name the missing cases" [ (at, String.concat "" (List.map line lines)) ] d

let most_written = 20

(* The fix for a [case] with this span. If not all missing patterns can be listed, adds a `_`
   branch. *)
let with_branches w rows (branches : branch list) (at : Span.t) d =
  match (within w (fun () -> Coverage.check ~most:most_written w.coverage rows), branches) with
  | Some { missing = Some { named; more }; _ }, first :: _ ->
      let numbers, others = List.partition has_number named in
      let patterns = if numbers = [] && more = 0 then others else others @ [ "_" ] in
      written w ~below:at
        ~column:(Span.column first.pattern.span.start)
        (List.map (fun p -> p ^ " -> _") patterns)
        d
  | (Some _ | None), _ -> d

let with_otherwise w ~arrow guarded d =
  match (guarded, List.rev guarded) with
  | ((first : expr), _) :: _, (_, (last : expr)) :: _ ->
      let column = Span.column first.span.start - String.length "| " in
      written w ~below:last.span ~column [ Printf.sprintf "| otherwise %s _" arrow ] d
  | _ -> d

let rec guards_of (e : expr) =
  match e.desc with Guards (guarded, _) -> guarded | Let (_, body) -> guards_of body | _ -> []

(* Does the last branch match everything, and so cover all remaining values? *)
let ends_in_any (branches : branch list) =
  match List.rev branches with
  | { pattern = { desc = Any | Bound _; _ }; value; _ } :: _ -> not (falls value)
  | [] | _ :: _ -> false

let refuse_many w (scrutinee : expr) branches =
  if not (ends_in_any branches) then
    Diagnostic.(
      error ~code:"E0413" ~at:scrutinee.span
        "this `case` is too complex to check that it covers every value"
      |> note "its patterns have too many combinations"
      |> hint "add a last branch `_ -> …`, or split it into a `case` within a branch"
      |> emit w.sink)

let rec case w (at : Span.t) (scrutinee : expr) branches =
  let row (b : branch) : Coverage.row = { pattern = b.pattern; guarded = falls b.value } in
  let rows = Long_list.map row branches in
  match within w (fun () -> Coverage.check w.coverage rows) with
  | Some result -> covered w at scrutinee branches rows result
  | None -> refuse_many w scrutinee branches

and covered w at scrutinee branches rows (result : Coverage.result) =
  (match result.missing with
  | None -> ()
  | Some missing ->
      let d =
        Diagnostic.(
          error ~code:"E0350" ~at:scrutinee.span "this `case` does not cover every value"
          |> here (Printf.sprintf "there is no branch for %s" (listed missing)))
      in
      let d =
        match (result.guarded_only, missing) with
        | None, { named = [ one ]; more = 0 } when not (has_number one) ->
            Diagnostic.hint (Printf.sprintf "add a branch `%s -> …`" one) d
            |> with_branches w rows branches at
        | None, { named = one :: _; _ } ->
            Diagnostic.hint
              (Printf.sprintf "add branches such as `%s -> …`, or `_ -> …` for all other values" one)
              d
            |> with_branches w rows branches at
        | None, { named = []; _ } -> d
        | Some index, _ ->
            let b : branch = List.nth branches index in
            d
            |> Diagnostic.label ~at:b.pattern.span "all guards of this branch may fail"
            |> Diagnostic.hint "add a last guard `| otherwise`"
            |> with_otherwise w ~arrow:"->" (guards_of b.value)
      in
      Diagnostic.emit w.sink d);
  let for_a_constructor = lazy (taken_for_a_constructor w branches) in
  let rec warn index useless (branches : branch list) =
    match (useless, branches) with
    | next :: useless, b :: branches when next = index ->
        Diagnostic.(
          warning ~code:"W0301" ~at:b.pattern.span "this branch is never taken"
          |> here "the branches before it cover all its values"
          |> (match Lazy.force for_a_constructor with
             | Some (name, (at : Span.t)) when Basis.Span.compare at b.pattern.span < 0 ->
                 fun d ->
                   label ~at "this starts with a lower-case letter, so it is a name for any value" d
                   |> hint (Printf.sprintf "for the constructor, write `%s`" name)
                   |> write at name
             | Some _ | None -> Fun.id)
          |> emit w.sink);
        warn (index + 1) useless branches
    | _ :: _, _ :: branches -> warn (index + 1) useless branches
    | [], _ | _, [] -> ()
  in
  warn 0 result.useless branches

let always_matches w what (p : pattern) =
  match p.desc with
  | Any | Bound _ -> ()
  | As _ | Tuple_of _ | Array_of _ | Constructed _ | Literal _ -> (
      match (Coverage.check w.coverage [ { pattern = p; guarded = false } ]).missing with
      | None -> ()
      | Some missing ->
          Diagnostic.(
            error ~code:"E0351" ~at:p.span "the pattern of %s must match every value" what
            |> here (Printf.sprintf "does not match %s" (listed missing))
            |> hint
                 (match missing.named with
                 | one :: _ -> Printf.sprintf "use a `case`, with a branch for `%s` too" one
                 | [] -> "use a `case`, with branches for all values")
            |> emit w.sink))

let rec expr w (e : expr) =
  match e.desc with
  | Local _ | Global _ | Primitive _ | Method _ | Constructor _ | Number _ | String _ -> ()
  | Tuple es | Array es -> List.iter (expr w) es
  | Apply
      ( { desc = Apply ({ desc = Primitive (g, _); _ }, task); _ },
        { desc = Lambda ([ p ], rest); _ } )
    when g = Environment.sequence ->
      expr w task;
      always_matches w "a `<-`" p;
      expr w rest
  | Apply (a, b) | Run (a, b) ->
      expr w a;
      expr w b
  | Negate a | Power (a, _) | Field (a, _, _) | Index (a, _) -> expr w a
  | If (a, b, c) ->
      expr w a;
      expr w b;
      expr w c
  | Case (scrutinee, branches) ->
      expr w scrutinee;
      case w e.span scrutinee branches;
      List.iter (fun (b : branch) -> right w b.value) branches
  | Let (bindings, body) ->
      List.iter (binding w) bindings;
      expr w body
  | Lambda (patterns, body) ->
      List.iter (always_matches w "a function") patterns;
      expr w body
  | Guards (guarded, last) ->
      (if last = None then
         Diagnostic.(
           error ~code:"E0352" ~at:e.span "all these guards may fail"
           |> here "there is no value if they do"
           |> hint "add a last guard `| otherwise`"
           |> with_otherwise w ~arrow:"=" guarded
           |> emit w.sink));
      guards w guarded last
  | Proc { input; equations; output } ->
      always_matches w "a `proc`" input;
      List.iter (binding w) equations;
      expr w output
  | Record (_, fields) -> List.iter (fun (_, e) -> expr w e) fields
  | Update (record, _, fields) ->
      expr w record;
      List.iter (fun (_, e) -> expr w e) fields

(* The right-hand side of a branch: if its guards fail, the next branch is tried. *)
and right w (e : expr) =
  match e.desc with
  | Guards (guarded, last) -> guards w guarded last
  | Let (bindings, body) ->
      List.iter (binding w) bindings;
      right w body
  | _ -> expr w e

and guards w guarded last =
  List.iter
    (fun (guard, value) ->
      expr w guard;
      expr w value)
    guarded;
  Option.iter (expr w) last

and binding w (b : binding) =
  always_matches w "an equation" b.pattern;
  expr w b.value

let check ?(sources = Source.create ()) sink (p : program) =
  let w = { sink; sources; data = p.data; coverage = Coverage.create p.data; left = most_steps } in
  List.iter (fun (d : definition) -> expr w d.value) p.definitions
