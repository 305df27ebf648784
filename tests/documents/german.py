#!/usr/bin/env python3
"""Every example that the workbench offers has its German words in german.txt (docs/how-to-add.md): each comment, title,
symbol, scenario, name of a project, alarm text; and each name of a variable, module, plant and station, with a # before
it. None is left over, and symbols are at most 24 characters long and differ. Each README.md has a README.de.md with the same parts."""
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2] / "examples"
COMMENTS = {".awl": ("//",), ".s5": ("//", "! "), ".sym": ("//",), ".scn": ("# ",), ".toml": ("# ",)}
TITLES = {".awl": r"\s*TITLE\s*=(.*)", ".s5": r"\s*NETZWERK \d+  (.*)"}
TYPES = "ARRAY|STRUCT|BOOL|BYTE|WORD|DWORD|INT|DINT|REAL|TIME|S5TIME|DATE|TIME_OF_DAY|DATE_AND_TIME|CHAR|STRING|ANY"
DECLARED = re.compile(rf"\s*(\w+)\s*:\s*(?:{TYPES}|POINTER|TIMER|COUNTER|BLOCK_\w+|UDT|S?FB|\")")
LONGEST_SYMBOL = 24


def projects(root):
    """The outermost folders with a merker.toml: each is one entry of the list of examples."""
    found = sorted(path.parent for path in root.rglob("merker.toml"))
    return [one for one in found if not any(other in one.parents for other in found)]


def split(line, marks):
    """The code of a line and its comment: none begins between quotation marks, and //= is a check."""
    quoted = False
    for at, character in enumerate(line):
        quoted ^= character == '"'
        mark = next((mark for mark in marks if not quoted and line.startswith(mark, at)), None)
        if mark:
            comment = line[at + len(mark):]
            return (line, "") if comment[:1] in ("=", "#") else (line[:at], comment.strip())
    return line, ""


def settings(code, section):
    for key, text in re.findall(r'(\w+)\s*=\s*"([^"]+)"', code):
        if key == "name" and section != "project" and re.fullmatch(r"[A-Za-z]\w*", text):
            yield "#" + text
        elif key == "name" or key.isdigit() and section == "alarm_texts":
            yield text


def phrases(path):
    section = ""
    for line in path.read_text(encoding="utf-8").splitlines():
        if title := re.match(TITLES.get(path.suffix, "(?!)"), line):
            yield title[1].strip()
            continue
        code, comment = split(line, COMMENTS[path.suffix])
        yield comment
        if path.suffix == ".toml":
            section = (re.match(r"\[+([\w.]+)", code) or ["", section])[1]
            yield from settings(code, section)
        # What the diagnostics say is Merker's own text, unless it is an alarm text.
        elif path.suffix != ".s5" and 'contains "rack"' not in code:
            yield from re.findall(r'"([^"]+)"', code)
        if path.suffix == ".awl" and (declared := DECLARED.match(code)):
            yield "#" + declared[1]


def wanted(project):
    """Phrases with a word in them, in the order of the files."""
    files = sorted(path for path in project.rglob("*") if path.suffix in COMMENTS)
    found = dict.fromkeys(phrase for path in files for phrase in phrases(path))
    return [phrase for phrase in found if re.search("[A-Za-z][a-z]", phrase)]


def symbols(project):
    for path in project.rglob("*.sym"):
        yield from re.findall(r'^"([^"]+)"', path.read_text(encoding="utf-8"), re.MULTILINE)


def problems(project):
    words = project / "german.txt"
    lines = words.read_text(encoding="utf-8").splitlines() if words.exists() else []
    pairs = [line.split("\t") for line in lines if not line.startswith("# ")]
    yield from (f"'{line}' is not English, one tab, German" for line in pairs if len(line) != 2 or not line[1].strip())
    german = {line[0]: line[1] for line in pairs if len(line) == 2}
    needed = wanted(project)
    yield from (f"no German for '{phrase}'" for phrase in needed if phrase not in german)
    yield from (f"nothing says '{phrase}'" for phrase in german if phrase not in needed)
    names = [german.get(one, one) for one in symbols(project)]
    yield from (f"symbol '{one}' has more than {LONGEST_SYMBOL} characters" for one in names if len(one) > LONGEST_SYMBOL)
    yield from (f"symbol '{one}' twice" for one in set(names) if names.count(one) > 1)


def parts(page):
    """What a page has in any language: its headings and rows of tables by number, its pictures, its commands without values."""
    text = page.read_text(encoding="utf-8")
    return {"headings": len(re.findall(r"^#", text, re.MULTILINE)), "rows of tables": len(re.findall(r"^\|", text, re.MULTILINE)),
            "items": len(re.findall(r"^- ", text, re.MULTILINE)), "pictures": re.findall(r"\]\((\S+)\)", text),
            "commands": re.findall(r"^merker +(\S+) +(\S+)", text, re.MULTILINE)}


def pages():
    for english in sorted(ROOT.rglob("README.md")):
        german = english.with_name("README.de.md")
        if not german.exists():
            yield f"{german.relative_to(ROOT)} is missing"
            continue
        of, here = parts(english), parts(german)
        yield from (f"{german.relative_to(ROOT)}: other {part} than README.md" for part in of if of[part] != here[part])


def main():
    told = [f"{project.relative_to(ROOT)}/german.txt: {problem}" for project in projects(ROOT) for problem in problems(project)]
    told += pages()
    print("\n".join(told))
    sys.exit(1 if told else 0)


if __name__ == "__main__":
    main()
