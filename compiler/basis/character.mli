(** Classes of ASCII characters, as the Frob lexer defines them. *)

val is_digit : char -> bool

val is_lower : char -> bool
(** A lowercase letter or [_]: a name that starts with it is a variable. *)

val is_upper : char -> bool
(** An uppercase letter: a name that starts with it is a type, constructor or module. *)

val is_name : char -> bool
(** A letter, digit, [_] or [']: any character of a name after the first. *)
