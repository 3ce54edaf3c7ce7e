type severity = Error | Warning
type label = { at : Span.t; text : string }
type edit = { span : Span.t; text : string }
type fix = { title : string; edits : edit list; safe : bool }

type t = {
  severity : severity;
  code : string;
  at : Span.t;
  message : string;
  here : string;
  labels : label list;
  notes : string list;
  hints : string list;
  fixes : fix list;
}

let make severity ~code ~at format =
  Format.kasprintf
    (fun message ->
      { severity; code; at; message; here = ""; labels = []; notes = []; hints = []; fixes = [] })
    format

let error ~code ~at format = make Error ~code ~at format
let warning ~code ~at format = make Warning ~code ~at format
let here format = Printf.ksprintf (fun text t -> { t with here = text }) format

let label ~at format =
  Printf.ksprintf (fun text t -> { t with labels = t.labels @ [ ({ at; text } : label) ] }) format

let note format = Printf.ksprintf (fun text t -> { t with notes = t.notes @ [ text ] }) format
let hint format = Printf.ksprintf (fun text t -> { t with hints = t.hints @ [ text ] }) format

let fix ?(safe = false) title edits t =
  let edits = List.map (fun (span, text) -> { span; text }) edits in
  { t with fixes = t.fixes @ [ { title; edits; safe } ] }

let write span text t = fix (Printf.sprintf "write `%s`" text) [ (span, text) ] t

type sink = t list ref

let sink () = ref []
let emit sink t = sink := t :: !sink
let errors sink = ref (List.filter (fun t -> t.severity = Error) !sink)
let has_errors sink = List.exists (fun t -> t.severity = Error) !sink

let all sink =
  let by_place a b =
    match Span.compare a.at b.at with 0 -> compare a.code b.code | order -> order
  in
  let same a b = Span.compare a.at b.at = 0 && String.equal a.code b.code in
  let once kept t = match kept with a :: _ when same a t -> kept | _ -> t :: kept in
  List.rev (List.fold_left once [] (List.stable_sort by_place (List.rev !sink)))

exception Bug of { stage : string; message : string }

let bug ~stage format = Format.kasprintf (fun message -> raise (Bug { stage; message })) format
