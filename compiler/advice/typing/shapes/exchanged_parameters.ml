open Basis
open Typing
open Diagnostic

(* The parameters and the result of a function of two arguments. *)
let of_two t =
  match Type.expand t with
  | Function (a, rest) -> (
      match Type.expand rest with
      | Function (b, result) -> (
          match Type.expand result with Function _ -> None | _ -> Some (a, b, result))
      | _ -> None)
  | _ -> None

(* Does this parameter of the function have the type `b -> a -> b`, with variables? *)
let takes_a_step words (g : Resolve.Ir.Global.t) position =
  let is_variable text = text <> "" && Character.is_lower text.[0] in
  match Wording.declared_type words g with
  | None -> false
  | Some ty -> (
      match List.nth_opt (Wording.parameters ty) (position - 1) with
      | None -> false
      | Some parameter -> (
          match of_two parameter with
          | Some (b, a, result) ->
              let b = Wording.type_ words b and a = Wording.type_ words a in
              is_variable a && is_variable b && b <> a
              && String.equal b (Wording.type_ words result)
          | None -> false))

let order name =
  match name with
  | "foldl" | "scanl" ->
      Printf.sprintf "`%s` passes the accumulated result first, then an element" name
  | "accumBy" | "accumHoldBy" | "dAccumHoldBy" ->
      Printf.sprintf "`%s` passes the current value first, then the value of the event" name
  | _ ->
      Printf.sprintf "the first parameter of the function for `%s` must have the type of its result"
        name

(* The names of the function's parameters, or other names. *)
let names words (subject : Resolve.Ir.expr) =
  let binding =
    match subject.desc with
    | Global g -> Wording.binding words g
    | Local x -> Wording.local_function words x
    | _ -> None
  in
  let of_pattern (p : Resolve.Ir.pattern) =
    match Wording.quote words p.span with
    | Some name when Text_place.is_a_name name -> Some name
    | Some _ | None -> None
  in
  match Option.map (fun (b : Resolve.Ir.binding) -> List.map of_pattern b.parameters) binding with
  | Some [ Some a; Some b ] when a <> b -> (a, b)
  | _ -> ("x", "y")

let diagnostic words ~(subject : Resolve.Ir.expr option) ~at ~(expected : Expected.t) ~found =
  match (expected.because, subject) with
  | ( Parameter { head = Some ({ desc = Global g; _ } as head); position; _ },
      Some ({ desc = Global _ | Local _; _ } as f) ) -> (
      match of_two found with
      | Some (a, b, result) when takes_a_step words g position ->
          let shown = Wording.type_ words in
          if (not (String.equal (shown b) (shown result))) || String.equal (shown a) (shown b) then
            None
          else
            Option.map
              (fun name ->
                let x, y = names words f in
                let text = Printf.sprintf "(\\%s %s -> %s %s %s)" y x name x y in
                error ~code:"E0301" ~at "the parameters of `%s` are in the wrong order" name
                |> here "this is %s" (Wording.described words found)
                |> label ~at:head.span "%s" (order g.name)
                |> hint "write `%s`" text |> write at text)
              (Wording.quote words f.span)
      | Some _ | None -> None)
  | _ -> None
