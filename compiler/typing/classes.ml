open Basis
open Context

let class_name = function Ir.Eq -> "Eq" | Ir.Ord -> "Ord"

(* What a class needs of a type: the same class of some variables. *)
type atom = Quantified of Type.rigid | Open

exception Lacking of Type.t

(* [tycons] remembers which type parameters each data type compares. *)
let rec atoms ctx tycons found t =
  match Type.expand t with
  | Flexible _ -> Open :: found
  | Rigid r -> Quantified r :: found
  | Number _ | Bool | Erroneous -> found
  | Tuple elements -> List.fold_left (atoms ctx tycons) found elements
  | Data { tycon; arguments; _ } ->
      let compared = compared ctx tycons tycon in
      List.fold_left2
        (fun found is_compared argument ->
          if is_compared then atoms ctx tycons found argument else found)
        found compared arguments
  | (String | Function _ | Signal_function _ | Alias _) as t -> raise_notrace (Lacking t)

and compared ctx tycons tycon =
  match Hashtbl.find_opt tycons tycon with
  | Some compared -> compared
  | None ->
      let environment = ctx.reader.environment in
      let { Environment.parameters; definition } = Environment.type_ environment tycon in
      let constructors =
        match definition with
        | Data data -> data.constructors
        | Alias _ | Builtin ->
            let arguments = List.map (fun r -> Type.Rigid r) parameters.types in
            raise_notrace (Lacking (Data { tycon; units = []; arguments }))
      in
      let field_atoms found (c : Ir.constructor) =
        let constructor = Environment.constructor environment c.constructor in
        let fields, _ = Environment.fields constructor constructor.scheme.body in
        List.fold_left (atoms ctx tycons) found fields
      in
      let found = List.fold_left field_atoms [] constructors in
      let is_compared (r : Type.rigid) =
        List.exists
          (function Quantified other -> other.variable.id = r.variable.id | Open -> false)
          found
      in
      let compared = List.map is_compared parameters.types in
      Hashtbl.replace tycons tycon compared;
      compared

let entails given wanted =
  List.exists
    (fun class_ ->
      match (class_, wanted) with
      | Ir.Ord, (Ir.Ord | Ir.Eq) | Ir.Eq, Ir.Eq -> true
      | Ir.Eq, Ir.Ord -> false)
    given

let give (scheme : Type.scheme) =
  List.iter
    (fun (class_, argument) ->
      match Type.expand argument with
      | Rigid r -> r.given <- class_ :: r.given
      | _ -> ())
    scheme.context

(* {1 Diagnostics} *)

let lacking ctx { class_; argument; at; by } culprit =
  report ctx (fun words ->
      let what = match class_ with Ir.Eq -> "equality" | Ir.Ord -> "order" in
      let diagnostic =
        Diagnostic.error ~code:"E0307" ~at "%s has no %s" (Show.quoted words argument) what
        |> Diagnostic.here (Printf.sprintf "`%s` needs it" by)
      in
      if Type.expand argument == culprit then diagnostic
      else
        Diagnostic.note
          (Printf.sprintf "it contains %s" (Show.quoted words culprit))
          diagnostic)

let undecided ctx { class_; at; by; _ } =
  report ctx (fun _ ->
      Diagnostic.error ~code:"E0308" ~at "nothing decides the type at which `%s` is used" by
      |> Diagnostic.note (Printf.sprintf "it must be a type with `%s`" (class_name class_))
      |> Diagnostic.hint "annotate it, as in `(e :: T)`")

let not_promised ctx { class_; at; by; _ } (variable : Ir.variable) =
  report ctx (fun _ ->
      let constraint_ = Printf.sprintf "%s %s" (class_name class_) variable.name in
      let diagnostic =
        Diagnostic.error ~code:"E0309" ~at "`%s` needs `%s`, which the signature does not promise" by
          constraint_
      in
      match Hashtbl.find_opt ctx.owners variable.id with
      | None -> diagnostic
      | Some (name, at) ->
          diagnostic
          |> Diagnostic.label ~at (Printf.sprintf "the signature of `%s`" name)
          |> Diagnostic.hint (Printf.sprintf "begin the signature with `%s =>`" constraint_))

(* {1 Solving} *)

let solve ctx generalized =
  let tycons = Hashtbl.create 16 in
  let own = Hashtbl.create 8 in
  List.iter (fun (r : Type.rigid) -> Hashtbl.replace own r.variable.id []) generalized;
  let answer required = function
    | Open -> if errors ctx = 0 then undecided ctx required
    | Quantified r -> (
        match Hashtbl.find_opt own r.variable.id with
        | Some classes ->
            if not (entails classes required.class_) then
              Hashtbl.replace own r.variable.id (required.class_ :: classes)
        | None ->
            if not (entails r.given required.class_) then not_promised ctx required r.variable)
  in
  List.iter
    (fun required ->
      match atoms ctx tycons [] required.argument with
      | found -> List.iter (answer required) (List.rev found)
      | exception Lacking culprit -> lacking ctx required culprit)
    (requirements ctx);
  List.filter_map
    (fun (r : Type.rigid) ->
      match Hashtbl.find own r.variable.id with
      | [] -> None
      | classes ->
          let class_ = if List.mem Ir.Ord classes then Ir.Ord else Ir.Eq in
          Some (class_, Type.Rigid r))
    generalized
