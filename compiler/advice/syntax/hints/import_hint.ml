open Syntax
open Grammar
open Found

(* The module name to suggest for `my-robot`: [MyRobot]. The token is only the part before the
   `-`. *)
let module_name found =
  let is_part c =
    match c with 'a' .. 'z' | 'A' .. 'Z' | '0' .. '9' | '_' | '-' -> true | _ -> false
  in
  let rec stop i = if is_part (char_at found i) then stop (i + 1) else i in
  let start = found.token.start.pos_cnum in
  String.split_on_char '-' (String.sub found.text start (stop start - start))
  |> List.map String.capitalize_ascii |> String.concat ""

let path found =
  match (found.token.token, found.before) with
  | (LOWER _ | STRING _ | SLASH | OPERATOR "."), Some { token = IMPORT | QUALIFIED; _ } ->
      Lacking.path found
  | _ -> None

(* The hint for `import math`, as in Python. *)
let mathematics found =
  match (found.token.token, found.before) with
  | LOWER _, Some { token = IMPORT; _ }
    when List.mem (written found found.token) [ "math"; "cmath"; "numpy" ] ->
      Some "remove the import: mathematical functions are built in, as in `sin x` and `sqrt x`"
  | _ -> None

let of_library = function
  | "rclpy" | "rospy" | "rclcpp" | "roscpp" | "geometry_msgs" | "sensor_msgs" | "nav_msgs"
  | "std_msgs" | "tf" | "tf2" | "tf2_ros" ->
      Some "remove this line: `frobc run --ros2` runs a program as a ROS 2 node"
  | "time" | "datetime" ->
      Some
        "remove this line: time is built in; write `time ()` for the time since the start of the \
         program"
  | "sys" | "os" | "threading" | "asyncio" | "typing" | "dataclasses" | "enum" | "collections" ->
      Some "remove this line: Frob has no such module"
  | "serial" | "gpiozero" | "RPi" | "pigpio" | "smbus" ->
      Some "remove this line: the program's host connects to the robot; write `import Robot`"
  | "random" ->
      Some "write `import Sources` instead; `whiteNoise 1 ()` returns random numbers, with seed 1"
  | "cv2" | "picamera" -> Some "write `import Vision` instead"
  | _ -> None

(* Is this the name of a Python module, such as `rclpy`? *)
let of_python found =
  match (found.token.token, found.before) with
  | (LOWER _ | QUALIFIED_LOWER _), Some { token = IMPORT; _ } ->
      of_library (List.hd (String.split_on_char '.' (written found found.token)))
  | _ -> None

let capital found =
  match (found.token.token, found.before) with
  | LOWER _, Some { token = MODULE | IMPORT | QUALIFIED; _ } ->
      let name = module_name found in
      Some
        (Printf.sprintf
           "start the name of the module and of its file with a capital letter: `%s`, in `%s.frob`"
           name name)
  | LOWER name, Some { token = AS; _ } ->
      Some
        (Printf.sprintf "start the module's alias with a capital letter: `%s`"
           (String.capitalize_ascii name))
  | _ -> None

let of_haskell found =
  match (found.token.token, found.before) with
  | ( QUALIFIED_UPPER (("Data" | "Control" | "Prelude" | "Math" | "System" | "Text" | "GHC"), _),
      Some { token = IMPORT | QUALIFIED; _ } ) ->
      Some
        "remove the import: functions such as `map`, `foldl` and `maybe` are built in; other \
         modules of the library are `Control`, `Geometry` and `Robot`"
  | _ -> None

let with_points found =
  match (found.token.token, found.before) with
  | QUALIFIED_UPPER _, Some { token = IMPORT | QUALIFIED; _ } ->
      Some "remove the dots: a module's file is in the same folder as this one, or in the library"
  | _ -> None

let hiding found =
  match (found.token.token, found.before) with
  | LOWER _, Some _ when first_word found = "import" && written found found.token = "hiding" ->
      Some
        "remove `hiding`: your own definitions hide imported ones, and two imports of the same \
         name clash only if you use it"
  | _ -> None

(* `import Control exposing (pid)`, as in Elm *)
let exposing found =
  match (found.token.token, found.before) with
  | LOWER "exposing", Some { token = UPPER module_; _ } when first_word found = "import" ->
      let stop = found.token.stop.pos_cnum in
      let names = between found stop (end_of_line found stop) in
      Some
        (if String.starts_with ~prefix:"(..)" names then
           Printf.sprintf "remove `exposing (..)`: `import %s` imports everything" module_
         else if String.starts_with ~prefix:"(" names then
           Printf.sprintf "remove `exposing`: write `import %s %s`" module_ names
         else Printf.sprintf "remove `exposing`: write `import %s (…)`" module_)
  | _ -> None
