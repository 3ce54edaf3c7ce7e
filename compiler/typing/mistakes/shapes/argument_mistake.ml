open Basis
open Diagnostic
open Unrun_mistake

(* The head of an application, with its type as it is declared. *)
let rec declared words (e : Resolve.Ir.expr option) =
  match e with
  | Some { desc = Apply { head; style = Juxtaposed; _ }; _ } -> declared words (Some head)
  | Some { desc = Global g; _ } -> Option.map (fun ty -> (g.name, ty)) (Show.declared words g)
  | _ -> None

let rec missing_arguments t =
  match Type.expand t with Function (_, result) -> 1 + missing_arguments result | _ -> 0

(* What lacks arguments: the head of this, or of what it stands for. *)
let lacking_arguments words ~subject missing d =
  match (subject : Resolve.Ir.expr option) with
  | Some { desc = Local x; _ } -> (
      match Option.map (fun e -> (e, Plain_name.of_head e)) (Show.definition words x) with
      | Some (({ desc = Apply _; _ } as e), Some head) ->
          let all = missing + List.length (arguments_of e) in
          label ~at:e.span (Printf.sprintf "`%s` is this, and lacks %s" x.name (count missing)) d
          |> hint
               (match declared words (Some e) with
               | Some (_, ty) when List.compare_length_with (arguments_of e) 0 > 0 ->
                   Printf.sprintf "`%s` takes %s: `%s :: %s`" head (count all) head ty
               | _ -> Printf.sprintf "`%s` takes %s" head (count all))
          |> Option.some
      | _ -> None)
  | _ -> None

(* The result of a function that is given an argument too many. *)
let one_too_many words ~subject ~wanted d =
  match (wanted, subject) with
  | ( Type.Function _,
      Some ({ desc = Apply { style = Juxtaposed; head; _ }; _ } as e : Resolve.Ir.expr) ) -> (
      match (Plain_name.of_head e, Show.quote words head.span) with
      | Some name, Some text ->
          hint (Printf.sprintf "`%s` has an argument too many here: `%s` is a function" name text) d
      | _ -> d)
  | _ -> d

(* The last argument, if it is the input of the proc around and what is still wanted is one. *)
let input_given words (subject : Resolve.Ir.expr option) found =
  let rec last t =
    match Type.expand t with
    | Function (parameter, result) -> (
        match last result with None -> Some parameter | later -> later)
    | _ -> None
  in
  match (subject, Option.map Type.expand (last found)) with
  | Some { desc = Apply { argument = { desc = Local x; _ }; _ }; _ }, Some (Flexible _)
    when Show.is_input words x.name ->
      Some x.name
  | _ -> None
