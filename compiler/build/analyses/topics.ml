open Basis
module Ir = Typing.Ir
module Types = Probe.Signal_types

type context = {
  sink : Diagnostic.sink;
  resolved : Resolve.Ir.program;
  typed : Ir.program;
  types : Types.t;
  entry : Ir.definition;
}

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

(* {1 Declarations} *)

let in_ros name : Ir.Global.t = { module_ = "Ros"; name }
let in_prelude name : Ir.Global.t = { module_ = "Prelude"; name }

let instance c class_ tycon =
  List.find_opt
    (fun (i : Ir.instance) ->
      i.class_ = in_ros class_ && match i.head with Data d -> d.tycon = tycon | _ -> false)
    c.typed.instances

(* The text that the only method of the instance returns. *)
let text_of c (i : Ir.instance) =
  let is name (d : Ir.definition) = d.name = name in
  match i.methods with
  | [ (_, Given name) ] -> (
      match List.find_opt (is name) c.typed.definitions with
      | Some { value = { desc = Lambda (_, { desc = String text; _ }); _ }; _ } -> Some text
      | Some _ | None -> None)
  | _ -> None

let is_package_or_type text =
  let is_letter = function 'a' .. 'z' | 'A' .. 'Z' | '0' .. '9' | '_' -> true | _ -> false in
  text <> "" && String.for_all is_letter text

let is_type text =
  match String.split_on_char '/' text with
  | [ package; "msg"; name ] -> is_package_or_type package && is_package_or_type name
  | _ -> false

let fields c tycon =
  let is_it (d : Ir.data) = d.tycon = tycon in
  match List.find_opt is_it c.typed.data with
  | Some { constructors = [ { record = true; fields; _ } ]; _ } -> Some (List.map fst fields)
  | Some _ | None -> None

(* The place where a field is declared. *)
let place c tycon field =
  let of_declaration (d : Resolve.Ir.type_declaration) =
    match d.definition with
    | Data [ only ] when d.tycon = tycon ->
        List.find_opt (fun (f : Resolve.Ir.field) -> f.field_name = field) only.fields
    | Data _ | Alias _ | Builtin | Foreign _ -> None
  in
  match List.find_map of_declaration c.resolved.types with
  | Some field -> field.ty.span
  | None -> c.entry.span

(* {1 Messages} *)

let refuse c ~at text hint =
  Diagnostic.error ~code:"E0509" ~at "%s" text |> Diagnostic.hint hint |> Diagnostic.emit c.sink

let messages =
  "messages are Bool, Int, Float, and records with an instance of `Message`, such as those of the \
   module Ros; `frobc ros2 import PACKAGE/Type` writes the record of any other message"

(* Checks that a message can consist of values of this type. *)
let rec check_part c ~at ~in_ (ty : Ir.ty) =
  match ty with
  | Bool | Number _ -> ()
  | Data { tycon = { name = "Array"; _ }; arguments = [ Size _; element ]; _ } ->
      check_part c ~at ~in_ element
  | Data { tycon; _ } when fields c tycon <> None -> check_record c ty tycon
  | _ ->
      refuse c ~at
        (Printf.sprintf "%s cannot be part of a message: its type is `%s`" in_ (Typing.Show.ty ty))
        "fields of messages are Bool, Int, Float, arrays and records of them, and `Upto` for \
         sequences; leave the field out, and the message has its default there"

and check_record c ty tycon =
  let check field =
    match Types.part c.types ty [ field ] with
    | Some part ->
        let in_ = Printf.sprintf "the field `%s` of `%s`" field tycon.Ir.Global.name in
        check_part c ~at:(place c tycon field) ~in_ part
    | None -> ()
  in
  List.iter check (Option.value (fields c tycon) ~default:[])

(* The type of the messages, for a Frob type. *)
let message c ~at ~in_ (ty : Ir.ty) =
  match ty with
  | Bool -> Some "std_msgs/msg/Bool"
  | Number (Int, _) -> Some "std_msgs/msg/Int32"
  | Number (Float, _) -> Some "std_msgs/msg/Float64"
  | Tuple [] -> Some "std_msgs/msg/Empty"
  | Data { tycon; _ } when instance c "Message" tycon <> None -> (
      let found = Option.get (instance c "Message" tycon) in
      check_part c ~at ~in_ ty;
      match text_of c found with
      | Some text when is_type text -> Some text
      | Some _ | None ->
          refuse c ~at:found.span
            (Printf.sprintf "the instance of `%s` does not name a type of messages" tycon.name)
            "return the name itself, as in `rosType _ = \"geometry_msgs/msg/Twist\"`";
          None)
  | _ ->
      refuse c ~at
        (Printf.sprintf "%s is not a topic: `%s` is not a type of messages" in_ (Typing.Show.ty ty))
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
        (Printf.sprintf "%s is not a topic: `()` has no value that a message could change" in_)
        "write `Event ()`, for messages of the type std_msgs/msg/Empty";
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
              (Printf.sprintf "the fields `%s` and `%s` are the same topic, %s" first.field
                 other.field first.name)
              "rename one of them")
          (List.find_opt is_same others);
        check others
    | [] -> ()
  in
  check topics

let side c ~in_record ~verb (ty : Ir.ty) =
  match ty with
  | Tuple [] -> []
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
        "declare a record with a field for each topic, as in `data In = In { enable :: Event Bool \
         }`";
      []

let of_program sink ~resolved typed (entry : Ir.definition) ~rate =
  let own = Diagnostic.sink () in
  let c = { sink = own; resolved; typed; types = Types.of_program typed; entry } in
  let found =
    match entry.scheme.ty with
    | Data { tycon = { name = "Program"; _ }; arguments = [ input; output ]; _ } ->
        let inputs = side c ~in_record:`Input ~verb:"reads" input in
        let outputs = side c ~in_record:`Output ~verb:"returns" output in
        Some { Cgen.Node_table.rate; inputs; outputs }
    | _ -> None
  in
  List.iter (Diagnostic.emit sink) (Diagnostic.all own);
  if Diagnostic.has_errors own then None else found
