type looks =
  | Region of { width : int; height : int }
  | Line of { length : int; width : int }
  | Iterated of { samples : int; level : int; iterations : int }
  | Samples of int

type t = { looks : looks; stack : int }

let kilobytes n = n * 1024

(* In the argument list, x, y, width and height follow the image. *)
let region = Region { width = 3; height = 4 }

let all =
  [
    ("frob_find_blob", { looks = region; stack = kilobytes 30 });
    ("frob_find_blobs", { looks = region; stack = kilobytes 250 });
    ("frob_get_statistics", { looks = region; stack = kilobytes 30 });
    ("frob_get_histogram", { looks = region; stack = kilobytes 30 });
    ("frob_find_corner", { looks = region; stack = kilobytes 140 });
    ("frob_find_template", { looks = region; stack = kilobytes 30 });
    ("frob_stereo_depths", { looks = Region { width = 4; height = 5 }; stack = kilobytes 350 });
    ("frob_find_edges", { looks = Line { length = 4; width = 5 }; stack = kilobytes 30 });
    ("frob_get_patch", { looks = Samples 1024; stack = kilobytes 30 });
    ( "frob_match_patch",
      { looks = Iterated { samples = 1024; level = 6; iterations = 7 }; stack = kilobytes 100 } );
  ]

let find name = List.assoc_opt name all

(* Limits of the kernels: the maximum width and height of an image, and the maximum length and width
   of the line along which edges are found. *)
let side = 4096
let longest = 257
let widest = 32
let levels = 3
let most_iterations = 30

let pixels looks arguments =
  let size most k : int option =
    match (List.nth_opt arguments k : Step.Ir.expr option) with
    | Some (Float x) when x > 0. -> Some (int_of_float (ceil (min x (float_of_int most))))
    | Some (Float _) -> Some 0
    | Some _ | None -> None
  in
  let whole most k =
    match (List.nth_opt arguments k : Step.Ir.expr option) with
    | Some (Int n) -> max 0 (min most (Int32.to_int n))
    | Some _ | None -> most
  in
  match looks with
  | Samples n -> Some n
  | Iterated { samples; level; iterations } ->
      Some (samples * (1 + whole (levels - 1) level) * (1 + whole most_iterations iterations))
  | Region { width; height } -> (
      match (size side width, size side height) with Some w, Some h -> Some (w * h) | _, _ -> None)
  | Line { length; width } ->
      let at_most most k = Option.value (size most k) ~default:most in
      Some (at_most longest length * at_most widest width)
