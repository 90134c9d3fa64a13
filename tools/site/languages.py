"""Colours for occam and netlists. Blocks in languages that Pygments does not know are shown as plain text."""

from pygments.lexer import RegexLexer
from pygments.lexers.special import TextLexer
from pygments.token import Comment, Keyword, Name, Number, Operator, String, Text


class OccamLexer(RegexLexer):
    """occam: a word in upper case is a keyword, or a name from a library."""

    tokens = {
        "root": [
            (r"--.*$", Comment.Single),
            (r'"(\*.|[^"*])*"?', String),
            (r"'(\*.[^']*|[^'*])'", String.Char),
            (r"^\s*#[A-Z]+", Comment.Preproc),
            (r"\b[A-Z][A-Z0-9]+\b", Keyword),
            (r"#[0-9A-Fa-f]+\b|\b[0-9]+(\.[0-9]+(E[+-]?[0-9]+)?)?", Number),
            (r"[A-Za-z][A-Za-z0-9.]*", Name),
            (r"[:=!?;&|+\-*/\\<>~@]+", Operator),
            (r"\s+|.", Text),
        ]
    }


class NetlistLexer(RegexLexer):
    """The netlist language (docs/reference/netlist-language.md)."""

    tokens = {
        "root": [
            (r"/\*(.|\n)*?\*/", Comment.Multiline),
            (r'"(\\.|[^"\\\n])*"?', String),
            (r"#include\b", Comment.Preproc),
            (r"\b(val|define|connection|connect|process|interface|input|output|use|for|to|on|by|place|rep|if|else)\b", Keyword),
            (r"\b[0-9]+(\.[0-9]+)?([KMG]|[a-z]+)?\b", Number),
            (r"[A-Za-z_][A-Za-z0-9_]*", Name),
            (r"[-+*/%=<>!&|]+", Operator),
            (r"\s+|.", Text),
        ]
    }


PLAIN = ("assembly", "btl", "csv", "in", "lines", "monitor", "pgm", "sbatch", "tas", "txt")


def setup(app):
    app.add_lexer("occam", OccamLexer)
    app.add_lexer("netlist", NetlistLexer)
    for name in PLAIN:
        app.add_lexer(name, TextLexer)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
