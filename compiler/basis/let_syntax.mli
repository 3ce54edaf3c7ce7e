(** Binding operators, for local [open]. *)

module Option : sig
  val ( let* ) : 'a option -> ('a -> 'b option) -> 'b option
end

module Result : sig
  val ( let* ) : ('a, 'e) result -> ('a -> ('b, 'e) result) -> ('b, 'e) result
end
