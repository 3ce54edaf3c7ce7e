val text : string
(** The contents of [words.txt]. *)
