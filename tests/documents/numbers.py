#!/usr/bin/env python3
"""usage: numbers.py exist|settled

exist    every requirement number that a test, a source, a table or docs/compatibility.md names is a requirement
settled  every requirement of the areas that are due is shown by a test or named in docs/compatibility.md
"""
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "tools"))
import requirements  # noqa: E402  (the path above)
from named_tests import shown as shown_in  # noqa: E402
from requirements import ROOT  # noqa: E402


def named_somewhere():
    for path, name in requirements.test_files():
        yield name, requirements.numbers_in(path)
    for folder in ("src", "apps"):
        for path in sorted((ROOT / folder).rglob("*")):
            if path.suffix in (".h", ".cpp", ".inc", ".md"):
                yield path.relative_to(ROOT).as_posix(), requirements.numbers_in(path)
    for document in sorted((ROOT / "docs").glob("*.md")):
        yield document.relative_to(ROOT).as_posix(), requirements.numbers_in(document)


def exist():
    known = requirements.defined()
    for name, numbers in named_somewhere():
        for number in sorted(numbers - set(known), key=requirements.natural):
            yield f"{name}: {number} is no requirement"


def settled():
    shown = {number for path, _ in requirements.test_files()
             for number, _ in shown_in(path, path.read_text(encoding="utf-8", errors="ignore"))}
    left = requirements.left_open()
    for number in requirements.defined():
        if requirements.is_due(number) and number not in shown | left:
            yield f"{number}: no test shows it and docs/compatibility.md does not name it"


findings = list({"exist": exist, "settled": settled}[sys.argv[1]]())
print("\n".join(findings) if findings else f"{sys.argv[1]}: holds")
print(f"{len(findings)} findings")
sys.exit(1 if findings else 0)
