open Basis
open Ir

type walk = {
  facts : Fact.t Facts.t;
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

let report w fact = Facts.report w.facts (Fact.Pattern fact)

(* Can all guards at the end of a right-hand side fail? *)
let rec falls (e : expr) =
  match e.desc with Guards (_, None) -> true | Let (_, body) -> falls body | _ -> false

let most_listed = 20

(* Does the last branch match everything, so that it covers all remaining values? *)
let ends_in_any (branches : branch list) =
  match List.rev branches with
  | { pattern = { desc = Any | Bound _; _ }; value; _ } :: _ -> not (falls value)
  | [] | _ :: _ -> false

let rec warn case index useless (branches : branch list) ~report =
  match (useless, branches) with
  | next :: useless, branch :: branches when next = index ->
      report (Pattern_fact.Unreachable { case; branch });
      warn case (index + 1) useless branches ~report
  | _ :: _, _ :: branches -> warn case (index + 1) useless branches ~report
  | [], _ | _, [] -> ()

let case w (case : Pattern_fact.case) =
  let row (b : branch) : Coverage.row = { pattern = b.pattern; guarded = falls b.value } in
  let rows = Long_list.map row case.branches in
  match within w (fun () -> Coverage.check w.coverage rows) with
  | None -> if not (ends_in_any case.branches) then report w (Too_complex case)
  | Some { missing; guarded_only; useless } ->
      let more () =
        within w (fun () -> Coverage.check ~most:most_listed w.coverage rows)
        |> Fun.flip Option.bind (fun (all : Coverage.result) -> all.missing)
      in
      Option.iter
        (fun missing ->
          let listed = if guarded_only = None then more () else None in
          report w (Missing { case; missing; guarded_only; listed }))
        missing;
      warn case 0 useless case.branches ~report:(report w)

let always_matches w (of_ : Pattern_fact.refutable) (pattern : pattern) =
  match pattern.desc with
  | Any | Bound _ -> ()
  | As _ | Tuple_of _ | Array_of _ | Constructed _ | Literal _ ->
      (Coverage.check w.coverage [ { pattern; guarded = false } ]).missing
      |> Option.iter (fun missing -> report w (Refutable { pattern; of_; missing }))

let rec expr w (e : expr) =
  match e.desc with
  | Apply
      ( { desc = Apply ({ desc = Primitive (g, _); _ }, task); _ },
        { desc = Lambda ([ p ], rest); _ } )
    when g = Environment.sequence ->
      expr w task;
      always_matches w Bind p;
      expr w rest
  | Case (scrutinee, branches) ->
      expr w scrutinee;
      case w { at = e.span; scrutinee; branches; data = w.data };
      List.iter (fun (b : branch) -> right w b.value) branches
  | Let (bindings, body) ->
      List.iter (binding w) bindings;
      expr w body
  | Lambda (patterns, body) ->
      List.iter (always_matches w Function) patterns;
      expr w body
  | Guards (guarded, last) ->
      if last = None then report w (Guards_fail { guards = e; guarded });
      guards w guarded last
  | Proc { input; equations; output } ->
      always_matches w Proc input;
      List.iter (binding w) equations;
      expr w output
  | _ -> Walk.parts (expr w) e

(* The right-hand side of a branch. If its guards fail, the next branch is tried. *)
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
  always_matches w Equation b.pattern;
  expr w b.value

let check facts (p : program) =
  let w = { facts; data = p.data; coverage = Coverage.create p.data; left = most_steps } in
  List.iter (fun (d : definition) -> expr w d.value) p.definitions
