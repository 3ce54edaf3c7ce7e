open Basis
open Ros_declarations
module Ir = Typing.Ir
module Types = Probe.Signal_types

let name_of field =
  let buffer = Buffer.create 32 in
  let is_small = function 'a' .. 'z' | '0' .. '9' -> true | _ -> false in
  String.iteri
    (fun k c ->
      match c with
      | 'A' .. 'Z' ->
          if k > 0 && is_small field.[k - 1] then Buffer.add_char buffer '_';
          Buffer.add_char buffer (Char.lowercase_ascii c)
      | c -> Buffer.add_char buffer c)
    field;
  Buffer.contents buffer

(* {1 Messages} *)

let is_package_or_type text =
  let is_letter = function 'a' .. 'z' | 'A' .. 'Z' | '0' .. '9' | '_' -> true | _ -> false in
  text <> "" && String.for_all is_letter text

let is_type text =
  match String.split_on_char '/' text with
  | [ package; "msg"; name ] -> is_package_or_type package && is_package_or_type name
  | _ -> false

let messages =
  "use Bool, Int, Float, an enumeration with an instance of `RosText`, or a record with an \
   instance of `Message`, such as those in the module Ros; `frobc ros2 import PACKAGE/Type` writes \
   the record for any other message"

(* The ROS 2 message type for a Frob type. *)
let message c ~at ~in_ (ty : Ir.ty) =
  match ty with
  | Bool -> Some "std_msgs/msg/Bool"
  | Number (Int, _) -> Some "std_msgs/msg/Int32"
  | Number (Float, _) -> Some "std_msgs/msg/Float64"
  | Tuple [] -> Some "std_msgs/msg/Empty"
  | ty when Ros_texts.is_enumeration c ty ->
      Ros_texts.check c ~at ~in_ ty;
      Some "std_msgs/msg/String"
  | Data { tycon; _ } when instance c "Message" tycon <> None -> (
      let found = Option.get (instance c "Message" tycon) in
      match method_ c found with
      | Some (_, { desc = String text; _ }) when is_type text ->
          Ros_message.check c ~named:found.span ~type_:text ty tycon;
          Some text
      | Some _ | None ->
          Ros_message.check c ~named:found.span ~type_:"" ty tycon;
          refuse c ~at:found.span
            (Printf.sprintf "the instance of `%s` does not name a message type" tycon.name)
            "return the name as a string literal, as in `rosType _ = \"geometry_msgs/msg/Twist\"`";
          None)
  | _ ->
      refuse c ~at
        (Printf.sprintf "%s is not a topic: `%s` is not a message type" in_ (Typing.Show.ty ty))
        messages;
      None

(* {1 Topics} *)

let is_command c (ty : Ir.ty) =
  match ty with Data { tycon; _ } -> instance c "Command" tycon <> None | _ -> false

let of_message c ~at ~in_ ?(is_counted = false) field ty : Cgen.Node_table.topic option =
  let is_fine = function 'a' .. 'z' | 'A' .. 'Z' | '0' .. '9' | '_' -> true | _ -> false in
  if not (String.for_all is_fine field) then (
    refuse c ~at
      (Printf.sprintf "%s is not a topic: a topic's name cannot contain `'`" in_)
      "rename the field";
    None)
  else
    Option.map
      (fun type_ ->
        {
          Cgen.Node_table.field;
          name = name_of field;
          type_;
          is_counted;
          is_command = is_command c ty;
        })
      (message c ~at ~in_ ty)

let topic c ~in_record tycon field (ty : Ir.ty) : Cgen.Node_table.topic option =
  let at = place c tycon field in
  let in_ = Printf.sprintf "the field `%s` of `%s`" field tycon.Ir.Global.name in
  match ty with
  | Data { tycon = console; _ } when in_record = `Input && Core.Console.is_console console -> None
  | Data { tycon = event; arguments = [ Data { tycon = counted; arguments = [ ty ]; _ } ]; _ }
    when event = in_prelude "Event" && counted = in_ros "Counted" && in_record = `Input ->
      of_message c ~at ~in_ ~is_counted:true field ty
  | Data { tycon = event; arguments = [ ty ]; _ } when event = in_prelude "Event" ->
      of_message c ~at ~in_ field ty
  | Tuple [] ->
      refuse c ~at
        (Printf.sprintf "%s cannot be a topic: `()` carries no data that a message could contain"
           in_)
        "write `Event ()` for messages of the type std_msgs/msg/Empty";
      None
  | ty -> of_message c ~at ~in_ field ty

(* Reports two fields with the same topic. *)
let check_names c tycon (topics : Cgen.Node_table.topic list) =
  let rec check = function
    | (first : Cgen.Node_table.topic) :: others ->
        let is_same (other : Cgen.Node_table.topic) = String.equal other.name first.name in
        Option.iter
          (fun (other : Cgen.Node_table.topic) ->
            refuse c ~at:(place c tycon other.field)
              (Printf.sprintf "the fields `%s` and `%s` have the same topic, %s" first.field
                 other.field first.name)
              "rename one of them")
          (List.find_opt is_same others);
        check others
    | [] -> ()
  in
  check topics

let side c ~in_record (ty : Ir.ty) =
  let verb, example =
    match in_record with
    | `Input -> ("reads", "data In = In { enable :: Event Bool }")
    | `Output -> ("returns", "data Out = Out { cmdVel :: Twist }")
  in
  match ty with
  | Tuple [] -> []
  | Data { tycon; _ } when instance c "Message" tycon <> None ->
      refuse c ~at:c.entry.span
        (Printf.sprintf "`%s` is a node, which %s a record of topics; `%s` is a message"
           c.entry.name.name verb (Typing.Show.ty ty))
        (Printf.sprintf
           "declare a record with a field for each topic, as in `%s`; the field's name is the \
            topic's"
           example);
      []
  | Data { tycon; _ } when fields c tycon <> None ->
      let field name =
        Option.bind (Types.part c.types ty [ name ]) (topic c ~in_record tycon name)
      in
      let topics = List.filter_map field (Option.get (fields c tycon)) in
      check_names c tycon topics;
      topics
  | _ ->
      refuse c ~at:c.entry.span
        (Printf.sprintf "`%s` is a node, which %s a record of topics, not `%s`" c.entry.name.name
           verb (Typing.Show.ty ty))
        (Printf.sprintf "declare a record with a field for each topic, as in `%s`%s" example
           (if in_record = `Output then ", or return `()` if there are no topics" else ""));
      []

let of_program sink ~resolved typed (entry : Ir.definition) ~rate =
  let own = Diagnostic.sink () in
  let c = { sink = own; resolved; typed; types = Types.of_program typed; entry } in
  let found =
    match entry.scheme.ty with
    | Data { tycon = { name = "Program"; _ }; arguments = [ input; output ]; _ } ->
        let inputs = side c ~in_record:`Input input in
        let outputs = side c ~in_record:`Output output in
        Some { Cgen.Node_table.rate; inputs; outputs; texts = Ros_texts.all c }
    | _ -> None
  in
  List.iter (Diagnostic.emit sink) (Diagnostic.all own);
  if Diagnostic.has_errors own then None else found
