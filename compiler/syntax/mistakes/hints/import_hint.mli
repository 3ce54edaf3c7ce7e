(** Hints about the names of modules, and about imports. *)

val path : Found.rule
(** The name of a module written as a path of a file. *)

val mathematics : Found.rule
(** [import math], whose functions are built in. *)

val capital : Found.rule
(** The name of a module that begins with a small letter. *)

val of_haskell : Found.rule
(** A module of Haskell. *)

val with_points : Found.rule
(** The name of a module with points. *)

val hiding : Found.rule
(** [import Control hiding (limit)]. *)
