(** Calls the runtime's vision kernels ([runtime/vision]) by name.

    The interpreter and compiled programs use the same C functions. When the interpreter checks a
    compiled program that uses images, it therefore checks everything that the compiler generated,
    but not the kernels themselves. Programs can call kernels without a C file of their own. *)

val is_known : string -> bool
(** Whether there is a kernel with this name. *)

type image
(** An image from a camera, which stays in memory until the process ends. *)

type argument = Image of image | Struct of Bytes.t  (** a struct, laid out as in C *)

val call : string -> argument list -> size:int -> Bytes.t
(** Calls a kernel, which must exist. [size] is the size of its result in bytes. *)

type frames
(** The frames of a recording, stored in a folder next to it. *)

val frames : record:string -> frames
(** Takes the path of the recording. Does not read any frame yet. *)

val frame : frames -> number:int -> size:int64 -> hash:int64 -> (image, string) result
(** Loads the frame that a cell refers to. The error says what was expected instead. *)

val name : image -> int * int64 * int64
(** The number, size and hash of the image. *)
