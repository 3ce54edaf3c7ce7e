open Basis

type t = { variable : string; of_ : string; array : string option }

(* The types whose elements [length] counts, with the size as their first argument. *)
let is_array (tycon : Ir.Global.t) =
  match (tycon.module_, tycon.name) with
  | _, "Array" | "Matrix", ("Vector" | "Matrix") -> true
  | _ -> false

let rec size_variables (ty : Ir.ty) =
  match ty.desc with
  | Named { tycon; arguments = { desc = Type_variable n; _ } :: rest; _ } when is_array tycon ->
      n :: List.concat_map size_variables rest
  | Named { arguments; _ } | Tuple_type arguments -> List.concat_map size_variables arguments
  | Function (a, b) -> size_variables a @ size_variables b
  | Type_variable _ | Representation _ | Size _ -> []

let rec arrays (ty : Ir.ty) (parameters : Ir.pattern list) =
  match (ty.desc, parameters) with
  | Function (a, rest), p :: others -> (
      match (a.desc, p.desc) with
      | ( Named { tycon; arguments = { desc = Type_variable n; _ } :: _; _ },
          (Bound local | As (local, _)) )
        when is_array tycon ->
          (n, local.name) :: arrays rest others
      | _ -> arrays rest others)
  | _ -> []

let of_signature ~name (scheme : Ir.scheme) parameters =
  let arrays = arrays scheme.ty parameters in
  let size variable = { variable; of_ = name; array = List.assoc_opt variable arrays } in
  List.map size (List.sort_uniq String.compare (size_variables scheme.ty))

let find sizes name = List.find_opt (fun size -> String.equal size.variable name) sizes

let report context size (name : Syntax.Ir.name) =
  let diagnostic = Diagnostic.error ~code:"E0205" ~at:name.span "unknown name `%s`" name.text in
  (match size.array with
  | Some array ->
      let text = "length " ^ array in
      Diagnostic.hint
        (Printf.sprintf "`%s` is a size in the type of `%s`; as a number, write `%s`" name.text
           size.of_ text)
        diagnostic
      |> Diagnostic.write name.span (Source.grouped text)
  | None ->
      Diagnostic.hint
        (Printf.sprintf
           "`%s` is a size in the type of `%s`; as a number, write `length xs`, where `xs` is an \
            array of this size"
           name.text size.of_)
        diagnostic)
  |> Context.emit context
