open Basis

type plan = Alone | Simulated of { world : string; first : int; last : int }
type t = { name : string; label : string; lasts : float; plan : plan }

let refuse sink at format =
  Format.kasprintf
    (fun text ->
      Diagnostic.emit sink (Diagnostic.error ~code:"E0392" ~at "%s" text);
      None)
    format

let check_time sink at lasts =
  if lasts > 0. && lasts <= 1e5 then Some lasts
  else refuse sink at "a test lasts for more than 0 s, and for 100,000 s at most; this one for %g s"
      lasts

let check_seeds sink at first last =
  if first >= 1 && last >= first then Some ()
  else
    refuse sink at "the seeds are from a number of at least 1 to one that is not less, not from %d \
                    to %d" first last

let demand = Interp.Thunk.demand
let bug () = Diagnostic.bug ~stage:"Driver.Checks" "a test that is none"

(* As the library's types have their fields. *)
let of_value sink at ~name ~label (value : Interp.Value.t) =
  let ( let* ) = Option.bind in
  let arguments =
    match value with Data { arguments; _ } -> Array.to_list arguments | _ -> bug ()
  in
  let time thunk = match demand thunk with Interp.Value.Float x -> x | _ -> bug () in
  match arguments with
  | [ lasts; _ ] ->
      let* lasts = check_time sink at (time lasts) in
      Some { name; label; lasts; plan = Alone }
  | [ world; lasts; seeds; _ ] -> (
      match (demand world, demand seeds) with
      | Text world, Data { arguments = [| first; last |]; _ } -> (
          let* lasts = check_time sink at (time lasts) in
          match (demand first, demand last) with
          | Int first, Int last ->
              let first = Int32.to_int first and last = Int32.to_int last in
              let* () = check_seeds sink at first last in
              Some { name; label; lasts; plan = Simulated { world; first; last } }
          | _, _ -> bug ())
      | _, _ -> bug ())
  | _ -> bug ()

let unknown sink at reason =
  refuse sink at "what this test is to do is not known before it runs: it depends on %s" reason

let of_definition sink (core : Core.Ir.program) (d : Core.Ir.definition) =
  match Resolve.Labels.kind_of_check d.name.name with
  | Some (_, label) when String.equal d.name.module_ core.main_module -> (
      let read value =
        Interp.Constant.known (fun () ->
            of_value sink d.span ~name:d.name.name ~label value)
      in
      match Result.bind (Interp.Constant.value core d.name) read with
      | Ok check -> check
      | Error (Param p) ->
          unknown sink d.span (Printf.sprintf "the parameter `%s`, which a run may set" p.label)
      | Error (Foreign f) -> unknown sink d.span (Printf.sprintf "`%s`, which is in C" f))
  | Some _ | None -> None

let of_program sink (core : Core.Ir.program) =
  let by_place (a : Core.Ir.definition) (b : Core.Ir.definition) = Span.compare a.span b.span in
  List.filter_map (of_definition sink core) (List.stable_sort by_place core.definitions)
