;;; placedpar.el --- Netlists of transputer networks, and occam  -*- lexical-binding: t -*-

;; Load this file. Eglot (part of Emacs 29, a package before) then starts `placedpar language-server'.

;;; Code:

(defconst placedpar-netlist-keywords
  '("val" "define" "connection" "connect" "process" "input" "output" "use" "place" "rep" "if"
    "else" "for" "to" "by" "on" "interface")
  "Words of the netlist language.")

(defconst placedpar-netlist-types
  '("int" "char" "short" "long" "float" "double" "unsigned")
  "Types of parameters.")

(defconst placedpar-occam-keywords
  '("AFTER" "ALT" "AND" "ANY" "AT" "BITAND" "BITNOT" "BITOR" "BOOL" "BYTE" "CASE" "CHAN" "ELSE"
    "FALSE" "FOR" "FROM" "FUNCTION" "IF" "IN" "INLINE" "INT" "INT16" "INT32" "INT64" "IS" "MINUS"
    "MOSTNEG" "MOSTPOS" "NOT" "OF" "OR" "PAR" "PLACE" "PLACED" "PLUS" "PORT" "PRI" "PROC"
    "PROCESSOR" "PROTOCOL" "REAL32" "REAL64" "REM" "RESULT" "RETYPES" "ROUND" "SEQ" "SIZE" "SKIP"
    "STOP" "TIMER" "TIMES" "TRUE" "TRUNC" "VAL" "VALOF" "VECSPACE" "WHILE" "WORKSPACE")
  "Keywords of occam 2.")

(defvar placedpar-netlist-syntax
  (let ((table (make-syntax-table)))
    (modify-syntax-entry ?/ ". 14" table)
    (modify-syntax-entry ?* ". 23" table)
    (modify-syntax-entry ?_ "w" table)
    table)
  "C's comments and strings.")

(defvar placedpar-occam-syntax
  (let ((table (make-syntax-table)))
    (modify-syntax-entry ?- ". 12" table)
    (modify-syntax-entry ?\n ">" table)
    (modify-syntax-entry ?* "\\" table)
    (modify-syntax-entry ?\\ "." table)
    (modify-syntax-entry ?. "w" table)
    table)
  "Comments begin with two dashes, escapes with a star.")

;;;###autoload
(define-derived-mode placedpar-netlist-mode prog-mode "Netlist"
  "Mode for netlists of transputer networks."
  :syntax-table placedpar-netlist-syntax
  (setq-local comment-start "/* " comment-end " */" indent-tabs-mode nil)
  (setq-local font-lock-defaults
              `(((,(regexp-opt placedpar-netlist-keywords 'words) . font-lock-keyword-face)
                 (,(regexp-opt placedpar-netlist-types 'words) . font-lock-type-face)))))

;;;###autoload
(define-derived-mode placedpar-occam-mode prog-mode "occam"
  "Mode for programs in occam 2."
  :syntax-table placedpar-occam-syntax
  (setq-local comment-start "-- " comment-end "" indent-tabs-mode nil)
  (setq-local font-lock-defaults
              `(((,(regexp-opt placedpar-occam-keywords 'words) . font-lock-keyword-face)))))

;;;###autoload
(add-to-list 'auto-mode-alist '("\\.cfs\\'" . placedpar-netlist-mode))
;;;###autoload
(add-to-list 'auto-mode-alist '("\\.\\(occ\\|pgm\\)\\'" . placedpar-occam-mode))

(with-eval-after-load 'eglot
  (defvar eglot-server-programs)
  (add-to-list 'eglot-server-programs
               '((placedpar-netlist-mode placedpar-occam-mode) . ("placedpar" "language-server"))))

(provide 'placedpar)
;;; placedpar.el ends here
