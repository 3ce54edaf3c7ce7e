type image = nativeint
type frames = nativeint Lazy.t
type argument = Image of image | Struct of Bytes.t

external find : string -> int = "frob_kernel_find" [@@noalloc]
external call_number : int -> argument list -> Bytes.t -> unit = "frob_kernel_call" [@@noalloc]
external open_frames : string -> nativeint = "frob_kernel_frames"
external find_frame : nativeint -> int -> int64 -> int64 -> image * string = "frob_kernel_frame"
external name : image -> int * int64 * int64 = "frob_kernel_name"

let is_known name = find name >= 0

let call name arguments ~size =
  let result = Bytes.make size '\000' in
  call_number (find name) arguments result;
  result

let frames ~record = lazy (open_frames record)

let frame frames ~number ~size ~hash =
  match find_frame (Lazy.force frames) number size hash with
  | 0n, expected -> Error expected
  | image, _ -> Ok image
