"""The numbered requirements of docs/requirements and the places that name them. Used by the other tools here."""
import pathlib
import re

ROOT = pathlib.Path(__file__).resolve().parent.parent
ID = re.compile(r"\b(?:S5|S7|POS|CNT|PID|PTP)-[A-Z0-9]+-[0-9]+\b")
ROW = re.compile(r"\|\s*\**([A-Z0-9]+-[A-Z0-9]+-[0-9]+)\**\s*\|(.*)")

# The areas of STEP 7 of which every number is either shown by a test or named in docs/compatibility.md. Of STEP 5, counting
# and closed-loop control it is every area.
SETTLED = ("OPND ADDR BIT BRACKET SETRESET TYPES LOAD FC FB CNT TMR REG STW CYCLE SYM BLK INSTR "
           "IND PAR SRC MNE MGR EDIT HWCFG SIM VIS").split()

# Files that talk about numbers without showing them.
NOT_TESTS = ("tests/architecture", "tests/documents")


def area(number):
    return number.rsplit("-", 1)[0]


def is_due(number):
    family, name, _ = number.split("-")
    return family in ("S5", "CNT", "PID", "POS") or (family == "S7" and name in SETTLED)


def defined(root=ROOT):
    """Number to text, in the order of the documents: the first two cells of a table row."""
    found = {}
    for document in sorted((root / "docs" / "requirements").glob("*.md")):
        for line in document.read_text(encoding="utf-8").splitlines():
            row = ROW.match(line)
            if row and ID.fullmatch(row.group(1)):
                found.setdefault(row.group(1), first_cell(row.group(2)))
    return found


def first_cell(text):
    return re.split(r"(?<!\\)\|", text, maxsplit=1)[0].strip()


def titles(root=ROOT):
    """Area to the heading it stands under: S7-TMR to "Timers"."""
    found = {}
    for document in sorted((root / "docs" / "requirements").glob("*.md")):
        heading = ""
        for line in document.read_text(encoding="utf-8").splitlines():
            if line.startswith("#"):
                heading = re.sub(r"^#+\s*(?:[A-Z0-9]+ (?:—|-) )?", "", line)
            row = ROW.match(line)
            if row and ID.fullmatch(row.group(1)):
                found.setdefault(area(row.group(1)), heading)
    return found


def numbers_in(path):
    try:
        return set(ID.findall(path.read_text(encoding="utf-8", errors="ignore")))
    except OSError:
        return set()


def left_open(root=ROOT):
    """The numbers that docs/compatibility.md speaks of."""
    return numbers_in(root / "docs" / "compatibility.md")


def test_files(root=ROOT):
    for folder in ("tests", "examples"):
        for path in sorted((root / folder).rglob("*")):
            name = path.relative_to(root).as_posix()
            if path.is_file() and not name.startswith(NOT_TESTS) and "__pycache__" not in name:
                yield path, name


def natural(number):
    return [int(part) if part.isdigit() else part for part in re.split(r"(\d+)", number)]
