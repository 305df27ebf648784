"""Reading the rows of operations.inc and encodings.inc. Used by the tools that print the instruction pages."""
import re
import sys

import requirements


def read(module, name, pattern, macro):
    """The groups of `pattern` for each row; a row that the pattern does not fit ends the program."""
    text = (requirements.ROOT / "src" / module / name).read_text(encoding="utf-8")
    rows = re.findall(pattern, text, re.MULTILINE)
    if len(rows) != len(re.findall(rf"^{macro}\(", text, re.MULTILINE)):
        sys.exit(f"src/{module}/{name} has a row that this tool cannot read")
    return rows


def cell(text):
    """Text for a cell of a Markdown table."""
    return text.replace("|", "\\|").replace("<", "&lt;").replace("*", "\\*")


if __name__ == "__main__":
    sys.exit("this file is used by the other tools")
