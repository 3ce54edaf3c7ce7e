open Basis
open Ir

type walk = { sink : Diagnostic.sink; sources : Source.t; data : data list; coverage : Coverage.t }

(* Whether the guards that end a right side may all fail. *)
let rec falls (e : expr) =
  match e.desc with Guards (_, None) -> true | Let (_, body) -> falls body | _ -> false

let listed ({ named; more } : Coverage.missing) =
  Enumeration.some (List.map (Printf.sprintf "`%s`") named) ~more

(* Of these branches one that has a name for all values, which in capitals is a
   constructor's. *)
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

(* Numbers are never all named: one in an example stands for more of them. *)
let has_number text =
  let is_digit c = '0' <= c && c <= '9' in
  String.split_on_char ' ' (String.map (function '(' | '[' | ',' | '-' -> ' ' | c -> c) text)
  |> List.exists (fun word -> word <> "" && is_digit word.[0])

(* {1 What is missing, written} *)

(* The end of what is there, or of a comment beside it. *)
let end_of_line w (at : Span.t) =
  let line = Span.line at.stop and column = Span.column at.stop in
  match Source.line w.sources at.file line with
  | Some text when column <= String.length text + 1 ->
      let rest = String.sub text (column - 1) (String.length text - column + 1) in
      if String.starts_with ~prefix:"--" (String.trim rest) then
        Span.position ~line ~column:(String.length text + 1)
      else at.stop
  | Some _ | None -> at.stop

(* Below what is there, from this column on; for the value stands `_`, which is none. *)
let written w ~below:(at : Span.t) ~column lines d =
  let line text = Printf.sprintf "\n%s%s" (String.make (max 0 (column - 1)) ' ') text in
  let stop = end_of_line w at in
  let at = { at with start = stop; stop } in
  Diagnostic.fix "name the missing cases" [ (at, String.concat "" (List.map line lines)) ] d

let most_written = 20

(* Of a case of this span; where not all can be named, the rest too. *)
let with_branches w rows (branches : branch list) (at : Span.t) d =
  match ((Coverage.check ~most:most_written w.coverage rows).missing, branches) with
  | Some { named; more }, first :: _ ->
      let numbers, others = List.partition has_number named in
      let patterns = if numbers = [] && more = 0 then others else others @ [ "_" ] in
      written w ~below:at
        ~column:(Span.column first.pattern.span.start)
        (List.map (fun p -> p ^ " -> _") patterns)
        d
  | Some _, [] | None, _ -> d

let with_otherwise w ~arrow guarded d =
  match (guarded, List.rev guarded) with
  | ((first : expr), _) :: _, (_, (last : expr)) :: _ ->
      let column = Span.column first.span.start - String.length "| " in
      written w ~below:last.span ~column [ Printf.sprintf "| otherwise %s _" arrow ] d
  | _ -> d

let rec guards_of (e : expr) =
  match e.desc with Guards (guarded, _) -> guarded | Let (_, body) -> guards_of body | _ -> []

let case w (at : Span.t) (scrutinee : expr) branches =
  let row (b : branch) : Coverage.row = { pattern = b.pattern; guarded = falls b.value } in
  let rows = Long_list.map row branches in
  let result = Coverage.check w.coverage rows in
  (match result.missing with
  | None -> ()
  | Some missing ->
      let d =
        Diagnostic.(
          error ~code:"E0350" ~at:scrutinee.span "this `case` does not cover every value"
          |> here (Printf.sprintf "no branch for %s" (listed missing)))
      in
      let d =
        match (result.guarded_only, missing) with
        | None, { named = [ one ]; more = 0 } when not (has_number one) ->
            Diagnostic.hint (Printf.sprintf "add a branch `%s -> …`" one) d
            |> with_branches w rows branches at
        | None, { named = one :: _; _ } ->
            Diagnostic.hint
              (Printf.sprintf "add branches such as `%s -> …`, or `_ -> …` for all that is left" one)
              d
            |> with_branches w rows branches at
        | None, { named = []; _ } -> d
        | Some index, _ ->
            let b : branch = List.nth branches index in
            d
            |> Diagnostic.label ~at:b.pattern.span "the guards of this branch may all fail"
            |> Diagnostic.hint "end the guards with `otherwise`"
            |> with_otherwise w ~arrow:"->" (guards_of b.value)
      in
      Diagnostic.emit w.sink d);
  let for_a_constructor = lazy (taken_for_a_constructor w branches) in
  let rec warn index useless (branches : branch list) =
    match (useless, branches) with
    | next :: useless, b :: branches when next = index ->
        Diagnostic.(
          warning ~code:"W0301" ~at:b.pattern.span "this branch is never taken"
          |> here "the branches before it cover these values"
          |> (match Lazy.force for_a_constructor with
             | Some (name, (at : Span.t)) when Basis.Span.compare at b.pattern.span < 0 ->
                 fun d ->
                   label ~at "a small letter: this is a name for any value" d
                   |> hint (Printf.sprintf "the constructor is `%s`" name)
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
                 | one :: _ -> Printf.sprintf "a `case` has branches for all: one for `%s` too" one
                 | [] -> "a `case` has branches for all values")
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
           error ~code:"E0352" ~at:e.span "these guards may all fail"
           |> here "no value where they do" |> hint "end them with `otherwise`"
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

(* The right side of a branch: its guards may fall through to the next. *)
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
  let w = { sink; sources; data = p.data; coverage = Coverage.create p.data } in
  List.iter (fun (d : definition) -> expr w d.value) p.definitions
