open Basis
open Ros_declarations
module Ir = Typing.Ir
module Types = Probe.Signal_types
module F = Message_file

(* The definition of a message type, with its name. *)
type message = { type_ : string; definition : F.t option }

let unknown = { type_ = ""; definition = None }

let message_of (base : F.base) =
  match base with
  | Message { package; name } -> (
      let type_ = package ^ "/msg/" ^ name in
      match Message_definitions.find ~package ~name with
      | Defined definition -> { type_; definition = Some definition }
      | No_message _ | No_package | Unreadable _ -> { unknown with type_ })
  | Truth | Real _ | Whole _ | Text -> unknown

(* {1 Types} *)

type shape =
  | Truth
  | Real
  | Whole
  | Text
  | Record of Ir.Global.t
  | Elements of int * Ir.ty  (** an array *)
  | Sequence of int * Ir.ty  (** an [Upto] *)
  | Other

let shape c (ty : Ir.ty) =
  match ty with
  | Bool -> Truth
  | Number (Int, _) -> Whole
  | Number (Float, _) -> Real
  | Data { tycon = { name = "Array"; _ }; arguments = [ Size n; element ]; _ } ->
      Elements (n, element)
  | Data { tycon; arguments = [ Size n; element ]; _ } when tycon = in_ros "Upto" ->
      Sequence (n, element)
  | ty when Ros_texts.is_enumeration c ty -> Text
  | Data { tycon; _ } when fields c tycon <> None -> Record tycon
  | _ -> Other

let matches (base : F.base) shape =
  match (base, shape) with
  | Truth, Truth | Real _, Real | Whole _, Whole | Text, Text | Message _, Record _ -> true
  | (Truth | Real _ | Whole _ | Text | Message _), _ -> false

(* Says how to declare a field of the record. *)
let hint ~name (f : F.field) =
  let declared element =
    match f.length with
    | One -> element
    | Exactly n -> Printf.sprintf "Array %d %s" n element
    | At_most n -> Printf.sprintf "Upto %d %s" n element
    | Any -> Printf.sprintf "Upto 16 %s" element
  in
  let say element more = Printf.sprintf "declare it as `%s :: %s`%s" name (declared element) more in
  match f.base with
  | Truth -> say "Bool" ""
  | Whole _ -> say "Int" ""
  | Real _ -> say "Float" ", with any unit"
  | Text -> "declare strings as an enumeration with an instance of `RosText`, or omit the field"
  | Message { package = "std_msgs"; name = "Header" } ->
      say "Header Frame" ", where `Frame` is an enumeration with an instance of `RosText`"
  | Message { package; name = type_ } -> (
      match List.assoc_opt (package, type_) Library_messages.all with
      | Some (_, _, record) -> say record ""
      | None when type_ = "Vector3" -> say "Vec3[m]" ", with any unit"
      | None -> say type_ (Printf.sprintf ", a record with fields of %s/msg/%s" package type_))

let mismatch c ~at ~in_ ~message ~name (f : F.field) ty =
  refuse c ~code:"E0510" ~at
    (Printf.sprintf "%s is `%s`, but %s has `%s %s`" in_ (Typing.Show.ty ty) message.type_
       (F.type_text f) f.name)
    (hint ~name f)

(* {1 Records} *)

let no_field c ~at ~message ~tycon field (d : F.t) =
  let names = List.map (fun (f : F.field) -> F.frob_name f.name) d.fields in
  refuse c ~code:"E0510" ~at
    (Printf.sprintf "%s has no field for `%s` of `%s`" message.type_ field tycon.Ir.Global.name)
    (match Suggest.closest field names with
    | Some name -> Printf.sprintf "did you mean `%s`?" name
    | None -> (
        match names with
        | [] -> "this message has no fields"
        | names ->
            Printf.sprintf "remove it, or give it the name of one of the message's fields: %s"
              (Enumeration.all names)))

(* Whether the record is a library record for another message, with fields that this message does
   not have. *)
let is_of_other c ~message tycon =
  let is_field (d : F.t) field = List.exists (F.is_named field) d.fields in
  match (message.definition, fields c tycon) with
  | Some d, Some fields ->
      instance c "Message" tycon <> None && not (List.for_all (is_field d) fields)
  | _ -> false

(* [checked]: the records that were compared, with their message types. *)
let rec check_part c ~checked ~at ~in_ ~message ~name (wanted : F.field option) ty =
  let mismatch f = mismatch c ~at ~in_ ~message ~name f ty in
  let element f element =
    check_part c ~checked ~at ~in_ ~message ~name
      (Option.map (fun (f : F.field) -> { f with length = One }) f)
      element
  in
  match (shape c ty, wanted) with
  | Other, _ ->
      refuse c ~at
        (Printf.sprintf "%s cannot be part of a message: its type is `%s`" in_ (Typing.Show.ty ty))
        "use Bool, Int, Float, an enumeration, an array or a record of these, or `Upto` for a \
         sequence; or omit the field, so that messages contain its default value"
  | Elements (n, ty), Some ({ length = Exactly m; _ } as f) when n = m -> element (Some f) ty
  | Elements (n, ty), Some ({ length = At_most m; _ } as f) when n <= m -> element (Some f) ty
  | Elements (_, ty), Some ({ length = Any; _ } as f) -> element (Some f) ty
  | Sequence (n, ty), Some ({ length = At_most m; _ } as f) when n <= m -> element (Some f) ty
  | Sequence (_, ty), Some ({ length = Any; _ } as f) -> element (Some f) ty
  | (Elements (_, ty) | Sequence (_, ty)), None -> element None ty
  | (Elements _ | Sequence _), Some f -> mismatch f
  | shape, Some f when f.length <> One || not (matches f.base shape) -> mismatch f
  | Text, (Some _ | None) -> Ros_texts.check c ~at ~in_ ty
  | Record tycon, Some f ->
      let message = message_of f.base in
      if is_of_other c ~message tycon then mismatch f else check_record c ~checked ~message ty tycon
  | Record tycon, None -> check_record c ~checked ~message:unknown ty tycon
  | (Truth | Real | Whole), (Some _ | None) -> ()

and check_record c ~checked ~message ty tycon =
  let check field part =
    let at = place c tycon field in
    let in_ = Printf.sprintf "the field `%s` of `%s`" field tycon.Ir.Global.name in
    let check = check_part c ~checked ~at ~in_ ~message ~name:field in
    match message.definition with
    | None -> check None part
    | Some d -> (
        match List.find_opt (F.is_named field) d.fields with
        | Some f -> check (Some f) part
        | None -> no_field c ~at:(name_place c tycon field) ~message ~tycon field d)
  in
  let this = (message.type_, ty) in
  if not (List.mem this !checked) then (
    checked := this :: !checked;
    List.iter
      (fun field -> Option.iter (check field) (Types.part c.types ty [ field ]))
      (Option.value (fields c tycon) ~default:[]))

let check c ~named ~type_ ty tycon =
  let message definition = { type_; definition } in
  let check definition = check_record c ~checked:(ref []) ~message:(message definition) ty tycon in
  match String.split_on_char '/' type_ with
  | [ package; "msg"; name ] -> (
      match Message_definitions.find ~package ~name with
      | Defined definition -> check (Some definition)
      | No_package -> check None
      | Unreadable why -> refuse c ~code:"E0510" ~at:named why "correct the definition"
      | No_message messages ->
          refuse c ~code:"E0510" ~at:named
            (Printf.sprintf "the package %s of the sourced ROS 2 installation has no message %s"
               package name)
            (match Suggest.closest name messages with
            | Some other -> Printf.sprintf "did you mean `%s/msg/%s`?" package other
            | None -> Printf.sprintf "its messages are %s" (Enumeration.all messages)))
  | _ -> check None
