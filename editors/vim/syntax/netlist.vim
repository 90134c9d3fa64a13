" Netlists in the configuration language of the C toolset.
if exists("b:current_syntax")
  finish
endif

syntax keyword netlistKeyword val define connection connect process input output use place rep if else for to
syntax keyword netlistKeyword by on interface
syntax keyword netlistType int char short long float double unsigned
syntax keyword netlistConstant TRUE FALSE HIGH LOW true false high low
syntax match netlistNumber "\<\(0x\x\+\|\d\+\(\.\d*\)\?\)\([KMG]\|ns\|us\|ms\|s\)\?\>"
syntax match netlistInclude "^\s*#\s*include"
syntax match netlistMember "\.\@<=\h\w*"
syntax region netlistString start=+"+ skip=+\\.+ end=+"+ oneline
syntax region netlistComment start="/\*" end="\*/"

highlight default link netlistKeyword Keyword
highlight default link netlistType Type
highlight default link netlistConstant Constant
highlight default link netlistNumber Number
highlight default link netlistInclude PreProc
highlight default link netlistMember Identifier
highlight default link netlistString String
highlight default link netlistComment Comment

setlocal commentstring=/*%s*/ shiftwidth=4 expandtab
let b:current_syntax = "netlist"
