(** A text with positions as editors count them. Lines are numbered from 0 and end with [\n], [\r\n]
    or [\r]. Characters within a line are counted in units of the negotiated encoding. Offsets are
    in bytes. *)

type t

val of_string : string -> t
val contents : t -> string

type encoding = Utf8 | Utf16 | Utf32
type position = { line : int; character : int }

val position : encoding -> t -> int -> position
(** Position of an offset. For an offset inside a character, the position of the character's start.
*)

val offset : encoding -> t -> position -> int
(** Offset of a position. For a position past the end of a line, the offset of the line's end; past
    the last line, the end of the text. *)

val replace : t -> int -> int -> string -> t
(** [replace t start stop text] replaces the text between two offsets. *)
