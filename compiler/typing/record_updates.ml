open Basis
open Ir

let most_fields = 1_000_000

(* A record type, and the number of its updates found so far. *)
type of_type = { record : constructor; mutable updates : int }

let size (c : constructor) = List.length c.fields

let report facts ~at found =
  let all o = o.updates * size o.record in
  let larger _ o = function Some other when all other >= all o -> Some other | _ -> Some o in
  match Resolve.Global_table.fold larger found None with
  | None -> ()
  | Some { record; updates } ->
      Facts.report facts (Fact.Too_many_updates { at; record; updates; most_fields })

exception Too_many of Span.t

let check facts (program : program) =
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
  with Too_many at -> report facts ~at found
