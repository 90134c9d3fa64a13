// The syntax of netlists and of occam, for colours in the editors.
"use strict";

const netlistWords = ["val", "define", "connection", "connect", "process", "input", "output", "use", "place", "rep", "if", "else", "for",
  "to", "by", "on", "interface"];
const occamWords = ["AFTER", "ALT", "AND", "ANY", "AT", "BITAND", "BITNOT", "BITOR", "BOOL", "BYTE", "CASE", "CHAN", "ELSE", "FALSE",
  "FOR", "FROM", "FUNCTION", "IF", "IN", "INLINE", "INT", "INT16", "INT32", "INT64", "IS", "MINUS", "MOSTNEG", "MOSTPOS", "NOT", "OF",
  "OR", "PAR", "PLACE", "PLACED", "PLUS", "PORT", "PRI", "PROC", "PROCESSOR", "PROTOCOL", "REAL32", "REAL64", "REM", "RESULT",
  "RETYPES", "ROUND", "SEQ", "SIZE", "SKIP", "STOP", "TIMER", "TIMES", "TRUE", "TRUNC", "VAL", "VALOF", "VECSPACE", "WHILE",
  "WORKSPACE"];
const anyOf = words => new RegExp(`(?:${words.join("|")})\\b`);

CodeMirror.defineSimpleMode("netlist", {
  start: [
    { regex: /\/\*/, token: "comment", next: "comment" },
    { regex: /#\s*include\b/i, token: "meta" },
    { regex: /"(?:[^\\"]|\\.)*"?/, token: "string" },
    { regex: /'(?:[^\\']|\\.)'/, token: "string" },
    { regex: anyOf(netlistWords), token: "keyword" },
    { regex: /(?:T\d{3}|TRUE|FALSE|HIGH|LOW|host|edge)\b/i, token: "atom" },
    { regex: /0x[\da-f]+|\d+(?:\.\d+)?(?:e[+-]?\d+)?[a-z]*/i, token: "number" },
    { regex: /[A-Za-z_]\w*/, token: "variable" },
    { regex: /[{}()[\]]/ },
  ],
  comment: [
    { regex: /.*?\*\//, token: "comment", next: "start" },
    { regex: /.*/, token: "comment" },
  ],
  meta: { blockCommentStart: "/*", blockCommentEnd: "*/" },
});

CodeMirror.defineSimpleMode("occam", {
  start: [
    { regex: /--.*/, token: "comment" },
    { regex: /#[A-Z]+/, token: "meta", sol: false },
    { regex: /"(?:[^*"]|\*.)*"?/, token: "string" },
    { regex: /'(?:[^*']|\*(?:#..|.))'/, token: "string" },
    { regex: anyOf(occamWords), token: "keyword" },
    { regex: /#[\dA-F]+|\d+(?:\.\d+)?(?:E[+-]?\d+)?/, token: "number" },
    { regex: /[A-Za-z][\w.]*/, token: "variable" },
    { regex: /[()[\]]/ },
  ],
  meta: { lineComment: "--" },
});
