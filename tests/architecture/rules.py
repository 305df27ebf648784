"""The rules of docs/architecture.md that a program can check. Each rule yields findings as text; none means it holds."""
import os
import pathlib
import re
import subprocess

INCLUDE = re.compile(r'^\s*#\s*include\s+"([a-z0-9_]+)/')
MODULE_ROW = re.compile(r"^\|\s*\[`(\w+)`\]\([^)]*\)\s*\|[^|]*\|([^|]*)\|")
MARK = re.compile(r"\b(?:TO" r"DO|FIX" r"ME|X" r"XX)\b")
WORKPLACE = re.compile(r"/(?:home|root|work|farm|Users)/|\b[A-Z]:\\Users\\")
CODE = (".cpp", ".h", ".ts", ".svelte", ".css", ".mjs")
LONGEST = 400


def table(root):
    """Module to the modules its row names, from the table in docs/architecture.md."""
    rows = {}
    for line in (root / "docs" / "architecture.md").read_text(encoding="utf-8").splitlines():
        row = MODULE_ROW.match(line)
        if row:
            rows[row.group(1)] = set(re.findall(r"\b[a-z][a-z0-9]+\b", row.group(2)))
    return rows


def closure(rows, module):
    """What a module may include: itself, the modules of its row, and what those stand on."""
    allowed, waiting = {module}, list(rows.get(module, ()))
    while waiting:
        used = waiting.pop()
        if used not in allowed:
            allowed.add(used)
            waiting += rows.get(used, ())
    return allowed


def code_files(root, *folders):
    for folder in folders:
        for path in sorted((root / folder).rglob("*")):
            if path.suffix in CODE and path.is_file():
                yield path


def include_rule(root):
    rows = table(root)
    for path in code_files(root, "src"):
        module = path.relative_to(root / "src").parts[0]
        allowed = closure(rows, module)
        for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
            used = INCLUDE.match(line)
            if used and used.group(1) not in allowed:
                yield f"{path.relative_to(root)}:{number}: {module} may not include {used.group(1)}"
            if re.match(r'\s*#\s*include\s+"[^"]*(?:\.\./|apps/)', line):
                yield f"{path.relative_to(root)}:{number}: includes name a module, never ../ or apps/"


def same_modules(root):
    """The picture is the code's: each folder has a row, each row a folder, and no row looks back in the order."""
    rows = table(root)
    folders = {path.name for path in (root / "src").iterdir() if path.is_dir()}
    yield from (f"src/{name}: not in the table of docs/architecture.md" for name in sorted(folders - set(rows)))
    yield from (f"docs/architecture.md: there is no src/{name}" for name in sorted(set(rows) - folders))
    above = set()
    for name, used in rows.items():
        yield from (f"docs/architecture.md: {name} uses {late}, which stands below it" for late in sorted(used - above))
        above.add(name)


def module_readmes(root):
    for path in sorted((root / "src").iterdir()):
        if path.is_dir() and not (path / "README.md").is_file():
            yield f"{path.relative_to(root)}: README.md is missing"


def short_files(root):
    for path in code_files(root, "src", "apps", "tests", "fuzz", "bench", "web/src"):
        lines = path.read_text(encoding="utf-8", errors="replace").count("\n")
        if lines > LONGEST:
            yield f"{path.relative_to(root)}: {lines} lines, at most {LONGEST}"


def finished(root):
    for path in code_files(root, "src", "apps", "tests", "fuzz", "bench", "web/src"):
        for number, line in enumerate(path.read_text(encoding="utf-8", errors="replace").splitlines(), 1):
            if MARK.search(line):
                yield f"{path.relative_to(root)}:{number}: unfinished by its own words"


def no_workplace(root):
    for path in tracked(root):
        for number, line in enumerate(path.read_text(encoding="utf-8", errors="ignore").splitlines(), 1):
            if WORKPLACE.search(line) and "WORKPLACE = " not in line:
                yield f"{path.relative_to(root)}:{number}: a path of somebody's machine"


def tracked(root):
    """The repository's files; outside of a clone everything but build folders."""
    listed = subprocess.run(["git", "-C", str(root), "ls-files", "-z"], capture_output=True, text=True, check=False)
    if listed.returncode == 0 and listed.stdout:
        names = [root / name for name in listed.stdout.split("\0") if name]
        return [path for path in names if path.is_file()]
    found = []
    for folder, below, names in os.walk(root):
        below[:] = [name for name in below if name not in ("build", ".git", "__pycache__")]
        found += [pathlib.Path(folder) / name for name in names]
    return sorted(found)


RULES = {rule.__name__: rule for rule in
         (include_rule, same_modules, module_readmes, short_files, finished, no_workplace)}
