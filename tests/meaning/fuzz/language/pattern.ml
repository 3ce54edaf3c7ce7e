open Choice
open Scope

type bound = string * (string * Type.t) list

let f = Printf.sprintf

let variable s ty =
  let name = fresh s "x" in
  (name, [ (name, ty) ])

let rec any s (ty : Type.t) =
  match ty with
  | _ when chance s.random 8 -> ("_", [])
  | Tuple parts when not (chance s.random 4) ->
      let patterns = List.map (any s) parts in
      (f "(%s)" (String.concat ", " (List.map fst patterns)), List.concat_map snd patterns)
  | Array (n, element) when n <= 4 && chance s.random 4 ->
      note s "pattern of an array";
      let patterns = List.init n (fun _ -> any s element) in
      (Constant.array (List.map fst patterns), List.concat_map snd patterns)
  (* Only this pattern may determine the size. *)
  | Data { constructors = [ { name = "Series"; _ } ]; _ } -> variable s ty
  | Data ({ constructors = [ c ]; _ } as data) when chance s.random 2 ->
      let patterns = List.map (fun (_, t) -> any s t) c.fields in
      (f "(%s)" (Constant.construct data c (List.map fst patterns)), List.concat_map snd patterns)
  | Float | Measure _ | Int | Bool | Tuple _ | Array _ | Data _ -> variable s ty

(* Patterns that together cover a type, each with its variables. *)
let rec cover s depth (ty : Type.t) =
  match ty with
  | _ when depth = 0 -> [ any s ty ]
  | Array (n, element) when n <= 4 && chance s.random 4 ->
      let array (texts, bound) = (Constant.array texts, bound) in
      List.map array (one_split s depth (List.init n (fun _ -> element)))
  | Float | Measure _ | Array _ -> [ variable s ty ]
  | Int ->
      let number = f "%d" (Random.State.int s.random 4) in
      [ (number, []); any s ty ]
  | Bool -> [ ("True", []); ("False", []) ]
  | Tuple parts ->
      let all = one_split s depth parts in
      List.map (fun (texts, bound) -> (f "(%s)" (String.concat ", " texts), bound)) all
  | Data data ->
      let of_constructor (c : Type.constructor) =
        List.map
          (fun (texts, bound) -> (f "(%s)" (Constant.construct data c texts), bound))
          (one_split s depth (List.map snd c.fields))
      in
      let all = List.concat_map of_constructor data.constructors in
      List.map
        (fun (text, bound) ->
          if chance s.random 6 then
            let name = fresh s "w" in
            (f "%s@%s" name text, (name, ty) :: bound)
          else (text, bound))
        all

(* Only one of several parts is covered by more than one pattern. *)
and one_split s depth parts =
  let chosen = Random.State.int s.random (max 1 (List.length parts)) in
  let rec go i = function
    | [] -> [ ([], []) ]
    | ty :: others ->
        let here = if i = chosen then cover s (depth - 1) ty else [ any s ty ] in
        let rest = go (i + 1) others in
        List.concat_map
          (fun (text, bound) -> List.map (fun (texts, more) -> (text :: texts, bound @ more)) rest)
          here
  in
  (* Each row needs new names, because a name is bound only once. *)
  match parts with
  | [] -> [ ([], []) ]
  | _ -> go 0 parts
