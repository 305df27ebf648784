#!/usr/bin/env python3
"""Every relative link of a Markdown page leads to a file or folder of the repository."""
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
LINK = re.compile(r"\]\(([^)\s#]+)(?:#[^)]*)?\)")


def pages():
    yield from ROOT.glob("*.md")
    for folder in ("docs", "src", "apps", "examples", "tests", "fuzz", "bench", "tools"):
        yield from sorted((ROOT / folder).rglob("*.md"))


def broken(page):
    outside_code = re.sub(r"```.*?```|`[^`\n]*`(?!\])", "", page.read_text(encoding="utf-8"), flags=re.DOTALL)
    for target in LINK.findall(outside_code):
        if not re.match(r"[a-z]+:", target) and not (page.parent / target).exists():
            yield f"{page.relative_to(ROOT)}: {target} does not exist"


findings = [finding for page in pages() for finding in broken(page)]
print("\n".join(findings) if findings else "every link leads somewhere")
sys.exit(1 if findings else 0)
