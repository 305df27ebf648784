#!/usr/bin/env python3
"""Every command line `merker COMMAND ...` that stands on a line of its own in a Markdown page names a command and options that exist.

usage: commands.py MERKER
"""
import functools
import re
import subprocess
import sys

from links import ROOT, pages

COMMAND = re.compile(r"^(?:\$ )?merker ([a-z]+(?: serial)?)((?: .*)?)$", re.MULTILINE)
OPTION = re.compile(r"(?<=\s)--[a-z0-9-]+")


@functools.cache
def options(command):
    """None: there is no such command."""
    done = subprocess.run([sys.argv[1], *command.split(), "--help"], capture_output=True, text=True)
    return set(re.findall(r"--[a-z0-9-]+", done.stdout)) if done.returncode == 0 else None


def findings(page):
    for command, rest in COMMAND.findall(page.read_text(encoding="utf-8")):
        known = options(command)
        if known is None:
            yield f"{page.relative_to(ROOT)}: merker {command}: not found"
            continue
        for option in OPTION.findall(rest.split("#")[0]):
            if option not in known:
                yield f"{page.relative_to(ROOT)}: merker {command} {option}: not found"


found = [finding for page in pages() for finding in findings(page)]
print("\n".join(found) if found else "every command exists")
sys.exit(1 if found else 0)
