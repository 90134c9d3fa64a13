" Programs in occam 2.
if exists("b:current_syntax")
  finish
endif

setlocal iskeyword+=.
syntax keyword occamKeyword ALT ANY AT CASE ELSE FOR FROM FUNCTION IF IN INLINE IS PAR PLACE PLACED PRI PROC
syntax keyword occamKeyword PROCESSOR PROTOCOL RESULT RETYPES SEQ SKIP STOP VAL VALOF VECSPACE WHILE WORKSPACE
syntax keyword occamOperator AFTER AND BITAND BITNOT BITOR MINUS MOSTNEG MOSTPOS NOT OR PLUS REM ROUND SIZE
syntax keyword occamOperator TIMES TRUNC
syntax keyword occamType BOOL BYTE CHAN INT INT16 INT32 INT64 OF PORT REAL32 REAL64 TIMER
syntax keyword occamConstant FALSE TRUE
syntax match occamNumber "\<\d\+\(\.\d\+\)\?\|#\x\+"
syntax match occamDirective "^\s*#\a\+"
syntax match occamCharacter "'\(\*#\x\x\|\*.\|[^'*]\)'"
syntax region occamString start=+"+ skip=+\*.+ end=+"+
syntax match occamComment "--.*$"

highlight default link occamKeyword Keyword
highlight default link occamOperator Operator
highlight default link occamType Type
highlight default link occamConstant Constant
highlight default link occamNumber Number
highlight default link occamDirective PreProc
highlight default link occamCharacter Character
highlight default link occamString String
highlight default link occamComment Comment

setlocal commentstring=--%s shiftwidth=2 expandtab
let b:current_syntax = "occam"
