let bug format = Basis.Diagnostic.bug ~stage:"Interp.Operator" format

let rec last = function
  | [ console ] -> Thunk.force console
  | _ :: others -> last others
  | [] -> bug "a missing console"

let label (kind : Core.Primitive.console) ~size (arguments : Value.thunk list) =
  match (kind, arguments) with
  | Map, _ -> Core.Console.map_label
  | (Button | Hold | Knob | Toggle | Camera | Tags | Lidar | Imu), first :: _ -> (
      match (Thunk.force first : Value.t) with
      | Text camera when kind = Tags -> Core.Console.tags_label camera
      | Text lidar when kind = Lidar -> Core.Console.lidar_label lidar size
      | Text text -> text
      | _ -> bug "a label that is not a string")
  | (Button | Hold | Knob | Toggle | Camera | Tags | Lidar | Imu), [] ->
      bug "a console primitive without a label"

let apply controls kind ~size arguments =
  match (last arguments : Value.t) with
  | Data { arguments = fields; _ } ->
      Thunk.force fields.(Core.Console.field controls (label kind ~size arguments))
  | _ -> bug "a console that is not a record"

let control_at_rest (c : Core.Ir.control) : Value.t =
  match Core.Console.at_rest c.kind with
  | No_event -> Data { constructor = 0; arguments = [||] }
  | Off b -> Bool b
  | At x -> Float x

let at_rest controls : Value.t =
  let fields = List.map (fun c -> Thunk.known (control_at_rest c)) controls in
  Data { constructor = 0; arguments = Array.of_list fields }
