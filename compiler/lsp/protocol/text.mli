(** A text and the places in it, as editors count them: lines from 0, which end at [\n], [\r\n] or
    [\r], and within a line units of the encoding agreed on. Offsets are in bytes. *)

type t

val of_string : string -> t
val contents : t -> string

type encoding = Utf8 | Utf16 | Utf32
type position = { line : int; character : int }

val position : encoding -> t -> int -> position
(** Of an offset; inside a character, where that begins. *)

val offset : encoding -> t -> position -> int
(** The other way round. Past the end of a line it is that end; past the last line the end of the
    text. *)

val replace : t -> int -> int -> string -> t
(** [replace t start stop text]: what is between two offsets becomes the text. *)
