open Basis

(* The type of the local variable with this name that is declared closest to the offset. *)
let local (seen : View.seen) facts ~offset name =
  let source = (View.analysis seen.view).sources in
  let is_it ((span : Span.t), (l : Place_types.local)) =
    match (Source.quote source span, View.place seen span) with
    | Some text, Some (start, _) when String.equal text name -> Some (abs (offset - start), l)
    | _ -> None
  in
  List.filter_map is_it (Place_types.locals facts)
  |> List.sort (fun (a, _) (b, _) -> Int.compare a b)
  |> function
  | (_, l) :: _ -> Some l.scheme.ty
  | [] -> None

let of_name (doc : Document.t) ~offset name =
  match Document.types doc with
  | None -> None
  | Some seen -> (
      match View.facts seen.view with
      | None -> None
      | Some facts -> (
          match local seen facts ~offset name with
          | Some ty -> Some ty
          | None ->
              let module_ = (View.program seen.view).main_module in
              Option.map
                (fun (s : Typing.Ir.scheme) -> s.ty)
                (Place_types.global facts { module_; name })))

let fields (doc : Document.t) (ty : Typing.Ir.ty) =
  match (ty, Option.bind (Document.types doc) (fun seen -> View.facts seen.view)) with
  | Data { tycon; _ }, Some facts -> (
      let is_it (d : Typing.Ir.data) = d.tycon = tycon in
      match List.find_opt is_it (Place_types.data facts) with
      | Some { constructors = [ { record = true; fields; _ } ]; _ } -> fields
      | Some _ | None -> [])
  | _ -> []
