(** Messages about an index of [!] that is not constant ([E0347]) or is out of range ([E0332]). *)

open Basis
open Typing

val not_constant : Source.t -> ?array:Ir.expr -> Ir.expr -> Level_fact.problem -> Diagnostic.t

val outside : Source.t -> array:Ir.expr -> index:Ir.expr -> int -> size:int option -> Diagnostic.t
(** The integer is the value of the index. [size]: the size of the array, if it is known. *)
