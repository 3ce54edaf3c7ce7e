(** The wording of one message: the texts of types and units, and the parts of the program that the
    message may mention.

    Unsolved variables get names in the usual style: [a], [b] for types, [u], [v] for units, [n] for
    representations. Within one message, a variable always has the same name, and that name does not
    occur in any signature. *)

open Basis
open Typing

type t
(** The variable names chosen so far, and the fact's {!Surroundings}. *)

val of_surroundings : Surroundings.t -> t
val sources : t -> Source.t
val environment : t -> Environment.t

val quote : t -> Span.t -> string option
(** The source text in this span, if it is short. *)

val argument : t -> Resolve.Ir.expr -> string option
(** The source text of the expression, if it is short, in parentheses if it needs them as an
    argument. *)

val argument_or : string -> t -> Resolve.Ir.expr -> string
(** Like {!argument}, with this text as the fallback if the source text is long. *)

val needs_class : t -> Type.t -> bool
val definition : t -> Resolve.Ir.Local.t -> Resolve.Ir.expr option
val local : t -> Resolve.Ir.Local.t -> Type.t option
val unit_written : t -> Resolve.Ir.unit_ -> Units.t option
val binding : t -> Resolve.Ir.Global.t -> Resolve.Ir.binding option

val hidden : t -> Resolve.Ir.Local.t -> (Resolve.Ir.Global.t * Type.t) option
(** A function or signal function of the program, the prelude or an imported module that has the
    same name as this local variable. *)

val local_function : t -> Resolve.Ir.Local.t -> Resolve.Ir.binding option
val parameter : t -> Resolve.Ir.Local.t -> (Resolve.Ir.binding * int) option
val unnamed_input : t -> Span.t option
val declared_type : t -> Resolve.Ir.Global.t -> Type.t option
val named : t -> string -> (Resolve.Ir.Global.t * Type.t) list
val values : t -> Type.t -> file:string -> string list

val inputs : t -> (string * Type.t) list
(** The input signals of the enclosing proc. *)

val fields : t -> Type.t -> (string * string list) option
val enclosing : t -> Surroundings.enclosing list
val field_type : t -> Type.t -> string -> Type.t option
val field_of : t -> Type.t -> of_:Type.t -> string option
val choices : t -> Type.t -> string list
val owner : t -> Ir.variable -> Surroundings.owned option
val makers : t -> Type.t -> of_:Type.t -> string list

val declared : t -> Resolve.Ir.Global.t -> string option
(** The text of the type in the signature. *)

val declared_parameter : t -> Resolve.Ir.Global.t -> int -> string option
(** The text of the type of this parameter, counted from 1, in the signature. *)

val is_input : t -> string -> bool
(** Is this the name of an input of the enclosing proc? *)

val signal : t -> Type.t -> string option
(** An input of the enclosing proc that may have this type. *)

val tell_apart : t -> Type.t list -> unit
(** From now on, qualifies a data type's name with its module if these types include data types with
    that name from different modules. *)

val namesakes : t -> string list
(** The names that are shown with their module. *)

val type_ : t -> Type.t -> string
(** Uses the type's alias if it has one. *)

val quoted : t -> Type.t -> string
(** The type in backticks; the alias of a number is followed by its unit, as in [`Velocity` (m/s)].
*)

val is_any_number : Type.t -> bool
(** Whether all that is known about the type is that it is a number. Then its text does not contain
    names of variables. *)

val has_any_representation : Type.t -> bool
(** Is this a number whose representation is undetermined? *)

val described : t -> Type.t -> string
(** The text of a type, for use in a sentence: quoted, or [a number]. *)

val constraint_ : t -> Ir.class_ -> Type.t -> string
(** For example [Eq (Maybe a)]. *)

val measure : t -> Units.t -> string
val representation : t -> Type.representation -> string

val parameters : Type.t -> Type.t list
(** The parameter types of a function, or the input type of a signal function. *)
