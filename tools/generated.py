"""Pages that are printed from the code or the tests: write them, or compare them with what is committed."""
import argparse
import difflib
import sys

from requirements import ROOT


def main(description, name, text):
    """`--check` compares docs/<name> with `text`; without it the page is written."""
    parser = argparse.ArgumentParser(description=description)
    parser.add_argument("--check", action="store_true", help="change nothing; exit 1 if the page is out of date")
    path = ROOT / "docs" / name
    if not parser.parse_args().check:
        path.write_text(text, encoding="utf-8")
        return 0
    return compare(path, text)


def compare(path, text, tool=None):
    """Whether the committed file is another one, and how: 0 or 1."""
    committed = path.read_text(encoding="utf-8") if path.exists() else ""
    if committed == text:
        return 0
    lines = list(difflib.unified_diff(committed.splitlines(), text.splitlines(), "committed", "regenerated", lineterm="", n=0))
    print(f"{path.relative_to(ROOT)} is out of date: run tools/{tool or path.stem} and commit the page")
    print("\n".join(lines[:20]))
    return 1


if __name__ == "__main__":
    sys.exit("this file is used by the other tools")
