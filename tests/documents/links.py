#!/usr/bin/env python3
"""Every relative link of a Markdown page leads to a file or folder of the repository, and so does every page that a
comment names (docs/….md)."""
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
LINK = re.compile(r"\]\(([^)\s#]+)(?:#[^)]*)?\)")

MENTION = re.compile(r"\bdocs/[\w/-]+\.md\b")


def pages():
    yield from ROOT.glob("*.md")
    for folder in ("docs", "src", "apps", "lib", "examples", "tests", "fuzz", "bench", "tools"):
        yield from sorted((ROOT / folder).rglob("*.md"))


def broken(page):
    outside_code = re.sub(r"```.*?```|`[^`\n]*`(?!\])", "", page.read_text(encoding="utf-8"), flags=re.DOTALL)
    for target in LINK.findall(outside_code):
        if not re.match(r"[a-z]+:", target) and not (page.parent / target).exists():
            yield f"{page.relative_to(ROOT)}: {target} does not exist"


def missing_pages():
    for folder in ("src", "apps", "web/src"):
        for path in sorted((ROOT / folder).rglob("*")):
            if path.suffix not in (".h", ".cpp", ".inc", ".md", ".txt", ".ts", ".svelte", ".css"):
                continue
            for page in MENTION.findall(path.read_text(encoding="utf-8", errors="ignore")):
                if not (ROOT / page).exists():
                    yield f"{path.relative_to(ROOT)}: {page} does not exist"


if __name__ == "__main__":
    findings = [finding for page in pages() for finding in broken(page)] + list(missing_pages())
    print("\n".join(findings) if findings else "every link leads somewhere")
    sys.exit(1 if findings else 0)
