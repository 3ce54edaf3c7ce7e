(** Random signal functions: as expressions, and as procs with equations that feed back through
    [delay] and [integral]. *)

type parameter =
  | Value of Type.t
  | Function of Type.t * Type.t
  | Signal_function of Type.t * Type.t

type named = { name : string; parameters : parameter list; input : Type.t; output : Type.t }

val parameter_text : parameter -> string
(** The type of a parameter. *)

type scope = { values : Scope.t;  (** static *) known : named list }

val expression : scope -> int -> Type.t -> Type.t -> string
(** A signal function of these types. *)

val argument : scope -> int -> parameter -> string
(** A random argument for this parameter. *)

val maker : scope -> Reactive.maker

(** The output of a proc. *)
type output = Computed of Type.t | All_signals  (** so that every equation matters *)

val body : scope -> indent:string -> input:Type.t -> signals:Type.t list -> output -> string
(** The text [proc … -> … where …], on several lines, with equations for signals of these types, of
    which there must be at least two. *)

val any_signals : scope -> Type.t list
(** Types for some signals. *)
