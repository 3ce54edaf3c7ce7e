open Basis
open Ir

let most_fields = 1_000_000

(* The updates of one type so far. *)
type of_type = { record : constructor; mutable updates : int }

let size (c : constructor) = List.length c.fields

let report sink ~at found =
  let all o = o.updates * size o.record in
  let larger _ o = function Some other when all other >= all o -> Some other | _ -> Some o in
  match Resolve.Global_table.fold larger found None with
  | None -> ()
  | Some { record; updates } ->
      Diagnostic.error ~code:"E0413" ~at
        "the record updates up to here write more than %d fields, which is too many to compile"
        most_fields
      |> Diagnostic.note
           (Printf.sprintf
              "an update writes all fields of its record; `%s` has %d fields and %d updates so far"
              record.constructor.name (size record) updates)
      |> Diagnostic.hint "change several fields in one update: `r { a = 1, b = 2 }`"
      |> Diagnostic.hint
           "put fields that change together into a smaller record, or keep them in an array"
      |> Diagnostic.emit sink

exception Too_many of Span.t

let check sink (program : program) =
  let found = Resolve.Global_table.create 16 and fields = ref 0 in
  let count at (record : constructor) =
    fields := !fields + size record;
    (match Resolve.Global_table.find_opt found record.constructor with
    | Some o -> o.updates <- o.updates + 1
    | None -> Resolve.Global_table.replace found record.constructor { record; updates = 1 });
    if !fields > most_fields then raise_notrace (Too_many at)
  in
  let rec visit (e : expr) =
    (match e.desc with Update (_, record, _) -> count e.span record | _ -> ());
    Walk.parts visit e
  in
  try List.iter (fun (d : definition) -> visit d.value) program.definitions
  with Too_many at -> report sink ~at found
