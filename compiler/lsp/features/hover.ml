open Basis

let content (d : Description.t) =
  let notes = List.map (fun note -> "*" ^ note ^ "*") d.notes in
  String.concat "\n\n" (Printf.sprintf "```frob\n%s\n```" d.code :: (Option.to_list d.doc @ notes))

let hover ws (doc : Document.t) range text : Json.t =
  Object
    [
      ("contents", Object [ ("kind", String "markdown"); ("value", String text) ]);
      ("range", Workspace.range ws doc.text range);
    ]

(* Describes the symbol at this offset in the given version of the text. *)
let of_symbol ws (doc : Document.t) offset (seen : View.seen) =
  let open Basis.Let_syntax.Option in
  let* position = View.position seen offset in
  let* occurrence = Index.at (View.index seen.view) position in
  let* range = View.place_at seen offset occurrence.place in
  let* description = Description.of_symbol seen.view occurrence.symbol in
  Some (hover ws doc range (content description))

let of_expression ws (doc : Document.t) offset (seen : View.seen) =
  let open Basis.Let_syntax.Option in
  let* position = View.position seen offset in
  let* facts = View.facts seen.view in
  let* span, ty = Place_types.type_at facts position in
  let* range = View.range seen span in
  let* range = if fst range <= offset && offset <= snd range then Some range else None in
  Some (hover ws doc range (Printf.sprintf "```frob\n:: %s\n```" (Typing.Show.ty ty)))

let answer ws (doc : Document.t) params =
  let offset = Workspace.offset ws doc.text (Json.member "position" params) in
  let names = Document.names doc and types = Document.types doc in
  let attempts = [ (of_symbol, types); (of_symbol, names); (of_expression, types) ] in
  (* The last version that passed type checking contains the types of symbols, but may lack a new
     symbol. *)
  let attempt (f, seen) = Option.bind seen (f ws doc offset) in
  Option.value (List.find_map attempt attempts) ~default:Json.Null
