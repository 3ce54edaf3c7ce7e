open Plan

let nothing =
  {
    program = { place = ""; value = "" };
    trial = None;
    seeds = None;
    lasts = None;
    rate = None;
    worlds = [];
    robots = [];
    sampling = Grid;
    points = 0;
    sampling_seed = 1;
    params = [];
  }

let sampling = function "random" -> Random | "latin" -> Latin | _ -> Grid

(* Parses a line of the host's output; plan_file.h documents the format. *)
let with_line t line =
  match String.split_on_char '\t' line with
  | [ "program"; place; value ] -> { t with program = { place; value } }
  | [ "trial"; place; value ] -> { t with trial = Some { place; value } }
  | [ "seeds"; first; last ] -> { t with seeds = Some (int_of_string first, int_of_string last) }
  | [ "lasts"; seconds ] -> { t with lasts = Some (float_of_string seconds) }
  | [ "rate"; hertz ] -> { t with rate = Some (float_of_string hertz) }
  | [ "world"; place; value ] -> { t with worlds = t.worlds @ [ { place; value } ] }
  | [ "robot"; place; value ] -> { t with robots = t.robots @ [ { place; value } ] }
  | [ "sampling"; how; points; seed ] ->
      {
        t with
        sampling = sampling how;
        points = int_of_string points;
        sampling_seed = int_of_string seed;
      }
  | [ "range"; place; name; low; high; steps ] ->
      let range = Range { low; high; steps = int_of_string steps } in
      { t with params = t.params @ [ { place; value = (name, range) } ] }
  | "values" :: place :: name :: values ->
      { t with params = t.params @ [ { place; value = (name, Values values) } ] }
  | _ -> t

let read (resources : Resources.t) path =
  match Process.result resources.simulator [ "--plan"; path ] with
  | Ok text -> Ok (List.fold_left with_line nothing (String.split_on_char '\n' text))
  | Error (Not_found host) ->
      Error (Printf.sprintf "error: the host %s is missing: reinstall frobc\n" host)
  | Error (Failed { errors; _ }) -> Error errors
