open Basis
open Typing
open Typing.Ir

let longest = 60

let quote sources (e : expr) =
  match Source.quote sources e.span with
  | Some text when String.length text <= longest -> Some text
  | Some _ | None -> None

(* A choice between constants: the conditions in source order, and the constants. *)
let rec chosen ~value (e : expr) =
  match e.desc with
  | Local (x, _) -> Option.bind (value x) (conditions ~value:(fun _ -> None))
  | _ -> conditions ~value e

and conditions ~value (e : expr) =
  match e.desc with
  | If (test, a, rest) when is_constant a -> (
      match conditions ~value rest with
      | Some (tests, constants) -> Some (test :: tests, a :: constants)
      | None when is_constant rest -> Some ([ test ], [ a; rest ])
      | None -> None)
  | _ -> None

and is_constant (e : expr) =
  match e.desc with
  | Local _ | Run _ | If _ | Case _ -> false
  | _ -> not (Parts.exists (fun e -> match e.desc with Local _ -> true | _ -> false) e)

let rec arguments (e : expr) found =
  match e.desc with Apply (f, a) -> arguments f (a :: found) | _ -> (e, found)

let names = [ "one"; "two"; "three"; "four" ]
let all options = if List.mem None options then None else Some (List.filter_map Fun.id options)

(* `f a setting b x`, where `setting` replaces the argument that contains the choice. *)
let run sources f arguments ~replaced ~input setting =
  let argument a =
    Option.map Source.grouped (quote sources (if a == replaced then setting else a))
  in
  Option.map (String.concat " ")
    (all
       ((quote sources f :: List.map argument arguments)
       @ [ Option.map Source.grouped (quote sources input) ]))

let hint sources ~value ~head ~input =
  let f, arguments = arguments head [] in
  let choice a = Option.map (fun choice -> (a, choice)) (chosen ~value a) in
  match List.find_map choice arguments with
  | Some (replaced, (tests, settings)) when List.length settings <= List.length names -> (
      let instance name setting =
        Option.map (Printf.sprintf "`%s = %s`" name)
          (run sources f arguments ~replaced ~input setting)
      in
      let names = List.filteri (fun i _ -> i < List.length settings) names in
      match (all (List.map2 instance names settings), all (List.map (quote sources) tests)) with
      | Some equations, Some tests ->
          let rec output names tests =
            match (names, tests) with
            | name :: names, test :: tests ->
                Printf.sprintf "if %s then %s else %s" test name (output names tests)
            | name :: _, [] -> name
            | [], _ -> ""
          in
          let last = List.nth equations (List.length equations - 1) in
          let others = List.filteri (fun i _ -> i + 1 < List.length equations) equations in
          Some
            (Printf.sprintf
               "run one instance for each setting, and choose between their outputs: add the \
                equations %s and %s, and write `%s` here"
               (String.concat ", " others) last (output names tests))
      | _ -> None)
  | Some _ | None -> None
