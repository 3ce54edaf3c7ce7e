;;; frob-mode.el --- Frob, a language for mobile robots -*- lexical-binding: t -*-

;; Package-Requires: ((emacs "27.1"))

;;; Commentary:

;; Highlighting, and support for the language server `frobc lsp' through eglot: `M-x eglot' in a
;; program. Emacs 29 and later include eglot; for older versions it is on GNU ELPA.

;;; Code:

(require 'frob-words)

(defvar frob-mode-syntax-table
  (let ((table (make-syntax-table)))
    (modify-syntax-entry ?- ". 123" table)
    (modify-syntax-entry ?{ "(}1nb" table)
    (modify-syntax-entry ?} "){4nb" table)
    (modify-syntax-entry ?\n ">" table)
    (modify-syntax-entry ?_ "w" table)
    (modify-syntax-entry ?' "w" table)
    (modify-syntax-entry ?\" "\"" table)
    (modify-syntax-entry ?\\ "\\" table)
    table))

(defconst frob-font-lock-keywords
  `((,(regexp-opt frob-words-declarations 'words) . font-lock-keyword-face)
    (,(regexp-opt frob-words-keywords 'words) . font-lock-keyword-face)
    (,(regexp-opt frob-words-types 'words) . font-lock-type-face)
    (,(regexp-opt frob-words-constants 'words) . font-lock-constant-face)
    ("^\\([a-z_][A-Za-z0-9_']*\\)[ \t]*::" 1 font-lock-function-name-face)
    ("[A-Za-z0-9_']\\(\\[[^]\n]*\\]\\)" 1 font-lock-builtin-face)
    ("\\<[A-Z][A-Za-z0-9_']*\\>" . font-lock-type-face)))

;;;###autoload
(define-derived-mode frob-mode prog-mode "Frob"
  "Major mode for programs in Frob."
  (setq-local comment-start "-- ")
  (setq-local comment-start-skip "--[ \t]*")
  (setq-local indent-tabs-mode nil)
  (setq-local tab-width 4)
  (setq-local indent-line-function #'indent-relative)
  (setq-local font-lock-defaults '(frob-font-lock-keywords)))

;;;###autoload
(add-to-list 'auto-mode-alist '("\\.frob\\'" . frob-mode))

(defvar eglot-server-programs)
(with-eval-after-load 'eglot
  (add-to-list 'eglot-server-programs '(frob-mode . ("frobc" "lsp"))))

(provide 'frob-mode)
;;; frob-mode.el ends here
