open Basis

let hint ws (doc : Document.t) offset text tooltip : Json.t =
  Object
    [
      ("position", Workspace.position ws doc.text offset);
      ("label", String text);
      ("kind", Int 1);
      ("tooltip", String tooltip);
    ]

let longest = 60

(* Shows hints only for names that start a line. Hints for the variables in patterns would fill the
   line with types. *)
let begins_line (doc : Document.t) offset =
  let text = Text.contents doc.text in
  let rec back i = i = 0 || text.[i - 1] = '\n' || (text.[i - 1] = ' ' && back (i - 1)) in
  back offset

(* The hints for top-level and local definitions without a signature. *)
let of_version ws (doc : Document.t) (seen : View.seen) facts (start, stop) =
  let index = Index.all (View.index seen.view) in
  let signed = Hashtbl.create 64 in
  List.iter
    (fun (o : Index.occurrence) ->
      match View.place seen o.place with
      | Some (_, stop) when not o.declares ->
          let text = Text.contents doc.text in
          let rec blank i = if i < String.length text && text.[i] = ' ' then blank (i + 1) else i in
          let i = blank stop in
          if i + 1 < String.length text && text.[i] = ':' && text.[i + 1] = ':' then
            Hashtbl.replace signed o.symbol.at ()
      | _ -> ())
    index;
  let of_occurrence (o : Index.occurrence) =
    match View.place seen o.place with
    | Some (first, behind)
      when o.declares && start <= behind && behind <= stop && begins_line doc first
           && not (Hashtbl.mem signed o.symbol.at) -> (
        let shown ?(level = "") type_ tooltip =
          if String.length type_ > longest then None
          else Some (hint ws doc behind (Printf.sprintf " :: %s%s" type_ level) tooltip)
        in
        match o.symbol.what with
        | Local ->
            Option.bind (Place_types.local facts o.symbol.at) (fun (l : Place_types.local) ->
                let level =
                  match l.level with
                  | Level Constant -> Some ", constant"
                  | Level Static -> Some ", static"
                  | Level Signal -> Some ""
                  | Parameter -> None
                in
                Option.bind level (fun level ->
                    shown ~level (Typing.Show.scheme l.scheme) (Description.level l.level)))
        | Value g ->
            Option.bind (Place_types.global facts g) (fun scheme ->
                shown (Typing.Show.scheme scheme) "inferred")
        | Constructor _ | Type _ | Class _ | Unit _ | Field _ | Module -> None)
    | _ -> None
  in
  List.filter_map of_occurrence index

let answer ws (doc : Document.t) params : Json.t =
  let range = Workspace.offsets ws doc.text (Json.member "range" params) in
  match Document.types doc with
  | Some seen when ws.inlay_hints ->
      List
        (Option.fold (View.facts seen.view) ~none:[] ~some:(fun facts ->
             of_version ws doc seen facts range))
  | Some _ | None -> List []
