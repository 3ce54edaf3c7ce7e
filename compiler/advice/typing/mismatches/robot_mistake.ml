open Basis
open Typing

let is_of_a_robot (g : Ir.Global.t) =
  List.mem g.name [ g.module_ ^ "Input"; g.module_ ^ "Output" ]
  && not (List.mem g.module_ [ "Prelude"; "Robot" ])

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

let replace ~word ~by text =
  let n = String.length word in
  let buffer = Buffer.create (String.length text) in
  let rec go i =
    if i < String.length text then
      if i + n <= String.length text && String.equal (String.sub text i n) word then (
        Buffer.add_string buffer by;
        go (i + n))
      else (
        Buffer.add_char buffer text.[i];
        go (i + 1))
  in
  go 0;
  Buffer.contents buffer

(* The signature with classes in place of the robot's types. *)
let generalized (class_ : Ir.Global.t) ~input ~output (name, ty) =
  let has word = List.mem word (words_of ty) in
  let is_of_outputs = List.mem class_.name [ "HasLight"; "HasSound"; "HasDisplay"; "DiffDrive" ] in
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
      let ty = replace ~word:input ~by:"i" ty |> replace ~word:output ~by:"o" in
      Some (Printf.sprintf "`%s :: %s => %s`" name context ty)

(* The signatures to change. *)
let signatures text class_ (robot : Ir.Global.t) =
  let lines = String.split_on_char '\n' text in
  let names (input, output) =
    List.filter_map signature lines |> List.filter_map (generalized class_ ~input ~output)
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
          (function Head.Data g when is_of_a_robot g -> Some g.module_ | _ -> None)
          (Environment.heads (Wording.environment words) class_)
        |> List.sort_uniq String.compare
      in
      let written =
        let named =
          if String.ends_with ~suffix:"Input" tycon.name then "RobotInput" else "RobotOutput"
        in
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
               (if String.ends_with ~suffix:"Input" tycon.name then "input" else "output")
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
