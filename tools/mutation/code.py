"""C++ text with its comments, strings and character literals blanked out: the same lines, the same columns."""
import re

TOKEN = re.compile(
    r"""(?P<raw>R"(?P<mark>[^()\s\\]*)\(.*?\)(?P=mark)")"""
    r"""|(?P<comment>//[^\n]*|/\*.*?\*/)"""
    r"""|(?P<text>"(?:\\.|[^"\\\n])*")"""
    r"""|(?P<char>(?<![0-9A-Fa-f])'(?:\\.[^'\n]*|[^'\\\n])')""", re.DOTALL | re.VERBOSE)


def blank(match):
    """A comment becomes spaces; a literal keeps a place holder, so that the line is still seen to have an operand there."""
    filler = " " if match.group("comment") else "\""
    return "".join("\n" if sign == "\n" else filler for sign in match.group(0))


def code_lines(text):
    return TOKEN.sub(blank, text).split("\n")
