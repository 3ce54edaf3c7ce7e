(** The names of a program's C files. *)

val name : string -> string
(** [name "walls/follow it.frob"] is ["follow it"]: the file's name without folder and extension.
    Control characters, and characters that C does not allow between quotes, become [_]. *)

val is_standard_header : string -> bool
(** [is_standard_header "math.h"] is true for headers of C and POSIX. *)

val check : ?beside_c:bool -> string -> (unit, string) result
(** Checks that C files can be named after this program. Returns an error if the name is too long
    for a file, or if [NAME.h] would hide a header that the C files include. If the user's C is
    compiled with them ([beside_c]), [NAME.h] must not hide a header that the user's C may include,
    either. *)
