type severity = Error | Warning
type text = string
type topic = ..
type label = { at : Span.t; text : text }
type hint = { text : text; topic : topic option }
type edit = { span : Span.t; text : string }
type fix = { title : text; edits : edit list; safe : bool }

type t = {
  severity : severity;
  code : string;
  at : Span.t;
  message : text;
  here : text option;
  labels : label list;
  notes : text list;
  hints : hint list;
  fixes : fix list;
  about : topic list;
}

let for_display text = text

let make severity ~code ~at format =
  Format.kasprintf
    (fun message ->
      {
        severity;
        code;
        at;
        message;
        here = None;
        labels = [];
        notes = [];
        hints = [];
        fixes = [];
        about = [];
      })
    format

let error ~code ~at format = make Error ~code ~at format
let warning ~code ~at format = make Warning ~code ~at format

let here format =
  Printf.ksprintf (fun text t -> { t with here = (if text = "" then None else Some text) }) format

let label ~at format =
  Printf.ksprintf (fun text t -> { t with labels = t.labels @ [ ({ at; text } : label) ] }) format

let note format = Printf.ksprintf (fun text t -> { t with notes = t.notes @ [ text ] }) format
let suggestion ?topic format = Printf.ksprintf (fun text : hint -> { text; topic }) format
let suggest hint t = { t with hints = t.hints @ [ hint ] }
let hint ?topic format = Printf.ksprintf (fun text -> suggest { text; topic }) format
let message format = Printf.ksprintf (fun message t -> { t with message }) format
let about topic t = { t with about = topic :: t.about }
let topics t = t.about @ List.filter_map (fun hint -> hint.topic) t.hints

let fix ?(safe = false) title edits t =
  let edits = List.map (fun (span, text) -> ({ span; text } : edit)) edits in
  { t with fixes = t.fixes @ [ { title; edits; safe } ] }

let write span text t = fix (Printf.sprintf "write `%s`" text) [ (span, text) ] t
let is_same a b = Span.compare a.at b.at = 0 && String.equal a.code b.code
let has_same_effect (a : fix) (b : fix) = String.equal a.title b.title

type wording = string * text * text list * text list

let wording ?(without_hints = false) t =
  let text (hint : hint) = hint.text in
  (t.code, t.message, t.notes, if without_hints then [] else List.map text t.hints)

type sink = t list ref

let sink () = ref []
let emit sink t = sink := t :: !sink
let errors sink = ref (List.filter (fun t -> t.severity = Error) !sink)
let has_errors sink = List.exists (fun t -> t.severity = Error) !sink

let all sink =
  let by_place a b =
    match Span.compare a.at b.at with 0 -> compare a.code b.code | order -> order
  in
  let once kept t = match kept with a :: _ when is_same a t -> kept | _ -> t :: kept in
  List.rev (List.fold_left once [] (List.stable_sort by_place (List.rev !sink)))

exception Bug of { stage : string; message : string }

let bug ~stage format = Format.kasprintf (fun message -> raise (Bug { stage; message })) format
