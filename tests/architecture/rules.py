"""The rules of docs/architecture.md that a program can check. Each rule yields findings as text; none means it holds."""
import collections
import os
import pathlib
import re
import subprocess

INCLUDE = re.compile(r'^\s*#\s*include\s+"([a-z0-9_]+)/')
WING = re.compile(r"^### \[`(\w+)`\]\(\.\./src/(\w+)\)")
MODULE_ROW = re.compile(r"^\|\s*\[`(\w+)`\]\(\.\./src/(\w+)/(\w+)\)\s*\|[^|]*\|([^|]*)\|")
LIBRARIES = re.compile(r"\bUSES\b([^)]*)")
FAMILIES = ("s5", "s7")  # wings that never see each other
FAMILY_QUESTION = re.compile(r"\bisS7\b|\b(?:dynamic|static)_cast<[^>]*\b(?:Station|Cnc)\b")
PAGE_FAMILY_QUESTION = re.compile(r"\.family\b|\bisStep[57]\b")  # the page: its state has `can`
# The factory of monitors.
MAY_ASK_FOR_THE_FAMILY = ("src/tool/monitor/factory.cpp",)
MARK = re.compile(r"\b(?:TO" r"DO|FIX" r"ME|X" r"XX)\b")
WORKPLACE = re.compile(r"/(?:home|root|work|farm|Users)/|\b[A-Z]:\\Users\\")
CODE = (".cpp", ".h", ".ts", ".svelte", ".css", ".mjs")
LONGEST = 400


Module = collections.namedtuple("Module", "wing name uses")


def table(root):
    """The modules in the order of docs/architecture.md, and what is wrong with the tables: one for each wing."""
    rows, findings, wing = [], [], None
    for line in (root / "docs" / "architecture.md").read_text(encoding="utf-8").splitlines():
        heading, row = WING.match(line), MODULE_ROW.match(line)
        if heading:
            wing = heading.group(1)
        if heading and heading.group(2) != wing:
            findings.append(f"docs/architecture.md: the link of the wing {wing} leads to src/{heading.group(2)}")
        if row:
            name, link = row.group(1), "/".join(row.group(2, 3))
            rows.append(Module(wing, name, set(re.findall(r"\b[a-z][a-z0-9]+\b", row.group(4)))))
            if link != f"{wing}/{name}":
                findings.append(f"docs/architecture.md: the link of {name} leads to src/{link}, not to src/{wing}/{name}")
    return rows, findings


def allowed(rows):
    """Module to what it may include: itself, the modules of its row, and what those stand on."""
    uses, found = {row.name: row.uses for row in rows}, {}
    for name in uses:
        found[name], waiting = {name}, list(uses[name])
        while waiting:
            used = waiting.pop()
            if used not in found[name]:
                found[name].add(used)
                waiting += uses.get(used, ())
    return found


def code_files(root, *folders):
    for folder in folders:
        for path in sorted((root / folder).rglob("*")):
            if path.suffix in CODE and path.is_file():
                yield path


def module_folders(root):
    return sorted(path for path in (root / "src").glob("*/*") if path.is_dir())


def includes(root):
    """(place, module, line, included module or None) of each #include below src/."""
    for path in code_files(root, "src"):
        module = (path.relative_to(root / "src").parts + ("", ""))[1]
        for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
            if re.match(r"\s*#\s*include", line):
                used = INCLUDE.match(line)
                yield f"{path.relative_to(root)}:{number}", module, line, used and used.group(1)


def links(root):
    """(place, module, linked module) of each library that the CMakeLists.txt of a module names."""
    known = {path.name for path in module_folders(root)}
    for path in sorted((root / "src").glob("*/*/CMakeLists.txt")):
        named = {word for uses in LIBRARIES.findall(path.read_text(encoding="utf-8")) for word in uses.split()}
        for used in sorted(named & known):
            yield path.relative_to(root), path.parent.name, used


def include_rule(root):
    may = allowed(table(root)[0])
    for place, module, line, used in includes(root):
        if used and used not in may.get(module, ()):
            yield f"{place}: {module} may not include {used}"
        if re.match(r'\s*#\s*include\s+"[^"]*(?:\.\./|apps/)', line):
            yield f"{place}: includes name a module, never ../ or apps/"


def link_rule(root):
    """The folders in which the compiler looks for headers come with the libraries, so these keep to the same rows."""
    may = allowed(table(root)[0])
    for place, module, used in links(root):
        if used not in may.get(module, ()):
            yield f"{place}: {module} may not use {used}"


def families_apart(root):
    """s5 never sees s7, and s7 never s5: whatever the tables say."""
    wings = {path.name: path.parent.name for path in module_folders(root)}
    seen = [(place, module, used) for place, module, _, used in includes(root)]
    rows = [("docs/architecture.md", row.name, used) for row in table(root)[0] for used in sorted(row.uses)]
    for place, module, used in seen + rows + list(links(root)):
        if {wings.get(module), wings.get(used)} == set(FAMILIES):
            yield f"{place}: {module} is of {wings[module]} and may not see {used} of {wings[used]}"


def family_question(root):
    """A PLC is asked for what it can do (plc/capability.h), not for what it is."""
    for path in code_files(root, "src", "apps", "web/src"):
        place = path.relative_to(root).as_posix()
        if place.startswith(MAY_ASK_FOR_THE_FAMILY):
            continue
        page = place.startswith("web/")
        instead = "plc.can(...)" if page else "a capability (src/ground/plc/capability.h)"
        for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
            if (PAGE_FAMILY_QUESTION if page else FAMILY_QUESTION).search(line):
                yield f"{place}:{number}: asks for the family of a PLC; ask for {instead}"


def same_modules(root):
    """The picture is the code's: each folder has a row, each row a folder, and no row looks back in the order of wings and
    modules. A name stands once, since includes do not name the wing."""
    rows, findings = table(root)
    yield from findings
    named = {f"{row.wing}/{row.name}" for row in rows}
    folders = {path.relative_to(root / "src").as_posix() for path in module_folders(root)}
    yield from (f"src/{name}: not in the tables of docs/architecture.md" for name in sorted(folders - named))
    yield from (f"docs/architecture.md: there is no src/{name}" for name in sorted(named - folders))
    above = set()
    for row in rows:
        yield from (f"docs/architecture.md: {row.name} uses {late}, which stands below it" for late in sorted(row.uses - above))
        if row.name in above:
            yield f"docs/architecture.md: {row.name} is the name of two modules"
        above.add(row.name)
    for path in code_files(root, "src"):
        if len(path.relative_to(root / "src").parts) not in (3, 4):
            yield f"{path.relative_to(root)}: code must be in src/<wing>/<module> or one folder below"


def module_readmes(root):
    for path in sorted((root / "src").iterdir()) + module_folders(root):
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
         (include_rule, link_rule, families_apart, family_question, same_modules, module_readmes, short_files, finished, no_workplace)}
