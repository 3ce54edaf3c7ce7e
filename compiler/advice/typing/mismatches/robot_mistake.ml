open Basis
open Typing

let is_of_a_robot (g : Ir.Global.t) =
  List.mem g.name [ g.module_ ^ "Input"; g.module_ ^ "Output" ]
  && not (List.mem g.module_ [ "Prelude"; "Robot" ])

(* The library's robots, which the option [--robot] selects by name. *)
let with_option = [ "Create"; "Pioneer"; "Ros"; "Scout" ]
let is_an_output (tycon : Ir.Global.t) = String.ends_with ~suffix:"Output" tycon.name

(* The words of a line, without the spaces and punctuation between them. *)
let words_of line =
  let is_letter c =
    Character.is_lower c || Character.is_upper c || Character.is_digit c || c = '_'
  in
  String.map (fun c -> if is_letter c then c else ' ') line |> String.split_on_char ' '

(* The name and the type of a signature on this line. *)
let signature line =
  match String.split_on_char ' ' line with
  | name :: "::" :: (_ :: _ as ty) when name <> "" && not (List.mem "=>" ty) ->
      Some (name, String.concat " " ty)
  | _ -> None

let replace ~name ~by text = Option.fold (Text_place.replaced ~name ~by text) ~none:text ~some:snd

(* The signature with classes in place of the robot's types. *)
let generalized (class_ : Ir.Global.t) ~is_of_outputs ~input ~output (name, ty) =
  let has word = List.mem word (words_of ty) in
  let constraints =
    (if has input then [ (if is_of_outputs then "HasOdometry i" else class_.name ^ " i") ] else [])
    @ if has output then [ (if is_of_outputs then class_.name ^ " o" else "DiffDrive o") ] else []
  in
  match constraints with
  | [] -> None
  | _ ->
      let context =
        match constraints with [ one ] -> one | all -> "(" ^ String.concat ", " all ^ ")"
      in
      let ty = replace ~name:input ~by:"i" ty |> replace ~name:output ~by:"o" in
      Some (Printf.sprintf "`%s :: %s => %s`" name context ty)

(* The signatures to change. *)
let signatures text class_ (robot : Ir.Global.t) =
  let lines = String.split_on_char '\n' text in
  let names (input, output) =
    List.filter_map signature lines
    |> List.filter_map (generalized class_ ~is_of_outputs:(is_an_output robot) ~input ~output)
  in
  names (robot.module_ ^ "Input", robot.module_ ^ "Output")
  @ if String.equal robot.module_ "Pioneer" then names ("RobotInput", "RobotOutput") else []

let rec listed = function
  | [] -> ""
  | [ one ] -> one
  | [ a; b ] -> a ^ " and " ^ b
  | a :: others -> a ^ ", " ^ listed others

let most_signatures = 3

let lacking words ~user ~(at : Span.t) (class_ : Ir.class_) ~of_ =
  match (class_, Type.expand of_) with
  | Declared ({ module_ = "Capability"; _ } as class_), Data { tycon; _ } when is_of_a_robot tycon
    ->
      let text = Option.value (Source.text (Wording.sources words) at.file) ~default:"" in
      let robots =
        List.filter_map
          (function
            | Head.Data g when is_of_a_robot g && List.mem g.module_ with_option -> Some g.module_
            | _ -> None)
          (Environment.heads (Wording.environment words) class_)
        |> List.sort_uniq String.compare
      in
      let written =
        let named = if is_an_output tycon then "RobotOutput" else "RobotInput" in
        let has word =
          List.exists (fun line -> List.mem word (words_of line)) (String.split_on_char '\n' text)
        in
        if String.equal tycon.module_ "Pioneer" && has named && not (has tycon.name) then named
        else tycon.name
      in
      let option robot = Printf.sprintf "`--robot %s`" (String.lowercase_ascii robot) in
      let to_change =
        match signatures text class_ tycon with
        | _ :: _ as all when List.compare_length_with all most_signatures <= 0 -> Some (listed all)
        | _ -> None
      in
      Some
        (fun d ->
          Diagnostic.message "a %s does not have the capability `%s`, which %s needs" tycon.module_
            class_.name user d
          |> Diagnostic.note "`%s` is the %s of a %s" written
               (if is_an_output tycon then "output" else "input")
               tycon.module_
          |>
          match (robots, to_change) with
          | [], _ -> Fun.id
          | first :: _, to_change ->
              fun d ->
                Diagnostic.note "robots with `%s`: %s" class_.name (listed robots) d
                |> Diagnostic.hint "for such a robot, write %s, and compile with %s"
                     (Option.value to_change
                        ~default:
                          "its class instead of the robot's type in each signature, as in `main :: \
                           (HasSonar i, DiffDrive o) => Program i o`")
                     (option first))
  | _ -> None
