;;; frob-words.el --- the words of Frob -*- lexical-binding: t -*-

;; Generated from the compiler's tables (compiler/editors/generate).

(defconst frob-words-declarations
  '("module" "import" "qualified" "as" "data" "type" "unit" "primitive" "class" "instance" "foreign" "param"))

(defconst frob-words-keywords
  '("let" "in" "where" "do" "of" "case" "if" "then" "else" "proc" "rec"))

(defconst frob-words-types
  '("Float" "Int" "Bool" "String" "Array" "SF" "Task" "Program" "Eq" "Ord" "Double" "Integer" "Time" "Distance" "Velocity" "Acceleration" "Angle" "AngularVelocity" "Maybe" "Either" "Event" "Verdict" "Claim"))

(defconst frob-words-constants
  '("True" "False" "Nothing" "Just" "Left" "Right" "NoEvent" "Event" "NotAsked" "Holds" "Open" "Fails"))

(provide 'frob-words)
;;; frob-words.el ends here
