open Basis

type trial = { world : string; first : int; last : int; chance : Chance.t option }
type plan = Alone | Traced of { input : string; output : string } | Simulated of trial
type t = { name : string; label : string; lasts : float; plan : plan }

let refuse sink at format =
  Format.kasprintf
    (fun text ->
      Diagnostic.emit sink (Diagnostic.error ~code:"E0392" ~at "%s" text);
      None)
    format

let check_time sink at lasts =
  if lasts > 0. && lasts <= 1e5 then Some lasts
  else
    refuse sink at "a test must last more than 0 s and at most 100,000 s, but this one lasts %g s"
      lasts

let check_seeds sink at first last =
  if first >= 1 && last >= first then Some ()
  else
    refuse sink at
      "the first seed must be at least 1, and the last seed must not be less than the first, but \
       these seeds are %d to %d"
      first last

let check_chance sink at ({ share; confidence } as chance : Chance.t) =
  let is_within low x = x > low && x < 1. in
  if is_within 0. share && is_within 0.5 confidence then Some chance
  else
    refuse sink at
      "`holdsWith` needs a proportion between 0 and 1 and a confidence between 0.5 and 1, not %g \
       and %g"
      share confidence

let demand = Interp.Thunk.demand
let bug () = Diagnostic.bug ~stage:"Build.Checks" "a value that is not a test"

(* The order of the arguments is the order of the fields in the library's types. *)
let seeds_of sink at (arguments : Interp.Value.t list) =
  let open Basis.Let_syntax.Option in
  let seeds first last chance =
    let first = Int32.to_int first and last = Int32.to_int last in
    let* () = check_seeds sink at first last in
    Some (first, last, chance)
  in
  match arguments with
  | [ Int first; Int last ] -> seeds first last None
  | [ Float share; Float confidence; Int first; Int last ] ->
      let* chance = check_chance sink at { share; confidence } in
      seeds first last (Some chance)
  | _ -> bug ()

let of_value sink at ~name ~label (value : Interp.Value.t) =
  let open Basis.Let_syntax.Option in
  let arguments =
    match value with Data { arguments; _ } -> Array.to_list arguments | _ -> bug ()
  in
  let time thunk = match demand thunk with Interp.Value.Float x -> x | _ -> bug () in
  match arguments with
  | [ lasts; _; golden ] -> (
      match demand golden with
      | Data { arguments = [| input; output |]; _ } -> (
          match (demand input, demand output) with
          | Text input, Text output ->
              Some { name; label; lasts = 0.; plan = Traced { input; output } }
          | _, _ -> bug ())
      | _ ->
          let* lasts = check_time sink at (time lasts) in
          Some { name; label; lasts; plan = Alone })
  | [ world; lasts; seeds; _ ] -> (
      match (demand world, demand seeds) with
      | Text world, Data { arguments; _ } ->
          let* lasts = check_time sink at (time lasts) in
          let* first, last, chance = seeds_of sink at (List.map demand (Array.to_list arguments)) in
          Some { name; label; lasts; plan = Simulated { world; first; last; chance } }
      | _, _ -> bug ())
  | _ -> bug ()

let unknown sink at reason =
  refuse sink at "a test must be a constant, but this one depends on %s" reason

let of_definition sink (core : Core.Ir.program) constants (d : Core.Ir.definition) =
  match Resolve.Labels.kind_of_check d.name.name with
  | Some (_, label) when String.equal d.name.module_ core.main_module -> (
      let read value =
        Interp.Constant.known constants (fun () ->
            of_value sink d.span ~name:d.name.name ~label value)
      in
      match Result.bind (Interp.Constant.value constants d.name) read with
      | Ok check -> check
      | Error (Param p) ->
          unknown sink d.span
            (Printf.sprintf "the parameter `%s`, which can be set for each run" p.label)
      | Error (Foreign f) -> unknown sink d.span (Printf.sprintf "`%s`, which is written in C" f)
      | Error Too_much ->
          Diagnostic.error ~code:"E0413" ~at:d.span
            "this test takes too long to compute at compile time"
          |> Diagnostic.hint "write its numbers as literals instead of computing them"
          |> Diagnostic.emit sink;
          None)
  | Some _ | None -> None

let of_program sink (core : Core.Ir.program) =
  let by_place (a : Core.Ir.definition) (b : Core.Ir.definition) = Span.compare a.span b.span in
  let constants = Interp.Constant.program core in
  List.filter_map (of_definition sink core constants) (List.stable_sort by_place core.definitions)
