type format = Text | Json
type asserts = Off | Count | Stop | Margin

type t = {
  format : format;
  dump : Stage.t option;
  stop_after : Stage.t option;
  lint : bool;
  specialization_limit : int;
  real : Basis.Real.t;
  robot : string option;
  probes : string list;
  asserts : asserts;
  params : string list;
}

let default =
  {
    format = Text;
    dump = None;
    stop_after = None;
    lint = false;
    specialization_limit = Specialize.Context.default.limit;
    real = Double;
    robot = None;
    probes = [];
    asserts = Off;
    params = [];
  }

let to_repeat t ~sources =
  let operand = Basis.Printable.operand and limit = t.specialization_limit in
  Option.fold ~none:[] ~some:(fun robot -> [ "--robot"; operand robot ]) t.robot
  @ (match t.real with Double -> [] | Single -> [ "--real"; "float" ])
  @ (if limit = default.specialization_limit then []
     else [ "--specialization-limit"; string_of_int limit ])
  @ List.concat_map (fun source -> [ "--with"; operand source ]) sources

let assert_options t = if t.asserts = Stop then [ "--stop-when-violated" ] else []
