(** What a program asks of its operator: buttons, knobs and their like, by their labels.

    In the library the type [Console] has one constructor and nothing in it. What a program asks for
    is known when all that is static has been run ({!Specialize.Operator}); then it becomes the
    fields of that type, by {!declare}, and from there on a console is a record as any other. *)

val asks : Ir.program -> bool
(** Whether some definition may ask for something. *)

val asks_itself : Ir.expr -> bool
(** Not only by what it calls. *)

val is_console : Ir.Global.t -> bool
(** Is it the type [Console]? *)

val has_name : module_:string -> string -> bool
(** Likewise. *)

val declare : Ir.control list -> Ir.program -> Ir.program
(** With these fields in the type [Console], in this order. *)

val field : Ir.control list -> string -> int
(** The number of the field with the label. *)

(** What a field has while nobody touches the console. *)
type rest = No_event | Off of bool | At of float

val at_rest : Ir.control_kind -> rest

val map_label : string
(** The map has no label of its own. *)

val tags_label : string -> string
(** Of the tags that the camera of this label sees; hosts find the camera by it. *)

val camera : Ir.control -> string option
(** The label of the camera through which it looks. *)

val describe : Ir.control_kind -> string
(** For messages: "a knob from 0 to 1, at first 0.5" *)
