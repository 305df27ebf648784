#!/usr/bin/env python3
"""usage: listings.py MERKER PAGE...

The listings of a page are true. A fence ```awl NAME, ```s5 NAME or ```scn NAME is a file; a fence ```console shows commands
after "$ " and, below each, exactly what it prints. All of a page runs in one empty folder, from top to bottom.
In the expected output a line "..." stands for any lines. Only commands of merker and `echo $?` run.
"""
import pathlib
import re
import subprocess
import sys
import tempfile

FENCE = re.compile(r"^```(\w+)(?: +(\S+))?\n(.*?)^```$", re.DOTALL | re.MULTILINE)


def commands(text):
    """(command, expected lines) of a console fence."""
    found = []
    for line in text.splitlines():
        if line.startswith("$ "):
            found.append((line[2:], []))
        elif found:
            found[-1][1].append(line)
    return found


def matches(expected, printed):
    pattern = "\n".join(r"(?:[^\n]*\n)*?[^\n]*" if line == "..." else re.escape(line) for line in expected)
    return re.fullmatch(pattern, printed.rstrip("\n")) is not None


def run(command, merker, folder, last):
    if command == "echo $?":
        return last, f"{last}\n"
    if not command.startswith("merker "):
        return last, None
    done = subprocess.run(["bash", "-c", f'merker() {{ "{merker}" "$@"; }}; {command}'], cwd=folder, check=False,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=60)
    return done.returncode, done.stdout


def check(page, merker):
    ran = 0
    with tempfile.TemporaryDirectory() as folder:
        last = 0
        for language, name, text in FENCE.findall(page.read_text(encoding="utf-8")):
            if name:
                path = pathlib.Path(folder) / name
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_text(text, encoding="utf-8")
            elif language == "console":
                for command, expected in commands(text):
                    last, printed = run(command, merker, folder, last)
                    if printed is None:
                        continue
                    ran += 1
                    if not matches(expected, printed):
                        yield f"{page}: $ {command}\n--- the page says\n" + "\n".join(expected) + \
                              f"\n--- it prints (exit code {last})\n{printed}"
    print(f"{page}: {ran} commands run")


merker = pathlib.Path(sys.argv[1]).resolve()
findings = [finding for page in sys.argv[2:] for finding in check(pathlib.Path(page), merker)]
print("\n".join(findings))
sys.exit(1 if findings else 0)
