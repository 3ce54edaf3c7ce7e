open Primitive

(* name in the library, primitive, number of arguments *)
let table =
  [
    ("+", Add, 2);
    ("-", Subtract, 2);
    ("*", Multiply, 2);
    ("negate", Negate, 1);
    ("abs", Absolute, 1);
    ("signum", Signum, 1);
    ("/", Divide, 2);
    ("**", Power, 2);
    ("sqrt", Elementary Sqrt, 1);
    ("hypot", Elementary Hypot, 2);
    ("exp", Elementary Exp, 1);
    ("log", Elementary Log, 1);
    ("sin", Elementary Sin, 1);
    ("cos", Elementary Cos, 1);
    ("tan", Elementary Tan, 1);
    ("asin", Elementary Asin, 1);
    ("acos", Elementary Acos, 1);
    ("atan", Elementary Atan, 1);
    ("atan2", Elementary Atan2, 2);
    ("div", Div, 2);
    ("mod", Mod, 2);
    (".&.", Bitwise Bit_and, 2);
    (".|.", Bitwise Bit_or, 2);
    ("xor", Bitwise Bit_xor, 2);
    ("shiftL", Bitwise Shift_left, 2);
    ("shiftR", Bitwise Shift_right, 2);
    ("toFloat", To_float, 1);
    ("round", Round, 1);
    ("floor", Floor, 1);
    ("ceiling", Ceiling, 1);
    ("truncate", Truncate, 1);
    ("floorFloat", Elementary Floor_float, 1);
    ("ceilingFloat", Elementary Ceiling_float, 1);
    ("nanoseconds", Elementary Nanoseconds, 1);
    ("==", Equal, 2);
    ("/=", Not_equal, 2);
    ("<", Less, 2);
    ("<=", Less_equal, 2);
    (">", Greater, 2);
    (">=", Greater_equal, 2);
    ("min", Minimum, 2);
    ("max", Maximum, 2);
    ("&&", And, 2);
    ("||", Or, 2);
    ("at", At, 3);
    ("length", Length, 1);
    ("replace", Replace, 3);
    ("generate", Generate, 1);
    ("map", Map, 2);
    ("imap", Imap, 2);
    ("zipWith", Zip_with, 3);
    ("foldl", Foldl, 3);
    ("scanl", Scanl, 3);
    (* for a signal function: the number of static arguments, not counting the signal *)
    ("delay", Delay, 1);
    ("time", Time, 0);
    ("timeSince", Time_since, 0);
    ("stepTime", Step_time, 0);
    ("ticks", Ticks, 1);
    ("integral", Integral, 0);
    ("derivative", Derivative, 0);
    ("switch", Switch, 2);
    ("dSwitch", Delayed_switch, 2);
    ("rSwitch", Recurring_switch, 1);
    ("drSwitch", Delayed_recurring_switch, 1);
    ("initially", Initially, 1);
    ("onEvent", On_event, 1);
    ("mkTask", Make_task, 1);
    ("untilRight", Until_right, 1);
    ("return", Return, 1);
    ("do", Sequence, 2);
    ("runTask", Run_task, 1);
    ("mapSF", Map_sf, 1);
    ("parZ", Parallel, 1);
    ("reactimateRobot", Reactimate, 1);
    ("node", Node, 2);
    ("ending", Ending, 1);
    ("consoleButton", Console Button, 2);
    ("consoleHold", Console Hold, 2);
    ("consoleKnob", Console Knob, 5);
    ("consoleToggle", Console Toggle, 3);
    ("consoleMap", Console Map, 1);
    ("consoleCamera", Console Camera, 2);
    ("consoleTags", Console Tags, 2);
    ("consoleLidar", Console Lidar, 2);
    ("consoleImu", Console Imu, 2);
    ("textOf", Text_of, 1);
    ("blank", Blank, 0);
    ("drawn", Drawn, 2);
    ("together", Together, 2);
  ]

(* Lookup tables, which are never modified. *)
let by_name =
  Basis.String_table.of_seq (Seq.map (fun (name, t, _) -> (name, t)) (List.to_seq table))

let by_meaning = Hashtbl.of_seq (Seq.map (fun ((_, t, _) as row) -> (t, row)) (List.to_seq table))
let of_name text = Basis.String_table.find_opt by_name text
let row t = Hashtbl.find_opt by_meaning t

let name t =
  match (t, row t) with
  | Power_literal k, _ -> Printf.sprintf "^%d" k
  | Foreign f, _ -> f.foreign_name
  | _, Some (name, _, _) -> name
  | _, None ->
      Basis.Diagnostic.bug ~stage:"Core.Primitive_table" "the primitive is not in the table"

let key t =
  match t with Foreign f -> Printf.sprintf "foreign %s.%s" f.module_ f.foreign_name | _ -> name t

let arity t =
  match (t, row t) with
  | Power_literal _, _ -> 1
  | Foreign { kind = Stateless arity; _ }, _ -> arity
  | Foreign { kind = Stateful; _ }, _ -> 0
  | _, Some (_, _, arity) -> arity
  | _, None ->
      Basis.Diagnostic.bug ~stage:"Core.Primitive_table" "the primitive is not in the table"
