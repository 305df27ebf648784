"""What the runs found: results.json, and docs/mutation.md that is printed from it."""
import json
import pathlib

from mutation.candidates import Mutant

HERE = pathlib.Path(__file__).resolve().parent
FILE = HERE / "results.json"
EQUIVALENT = HERE / "equivalent.txt"


def equivalents():
    """(file, before, after) to the reason why no test can see it. A record is four lines: file, "- " before, "+ " after, reason;
    an empty line ends it."""
    found = {}
    for record in EQUIVALENT.read_text(encoding="utf-8").split("\n\n"):
        lines = [line for line in record.splitlines() if line and not line.startswith("#")]
        if not lines:
            continue
        if len(lines) < 4 or not lines[1].startswith("- ") or not lines[2].startswith("+ "):
            raise SystemExit(f"{EQUIVALENT.name}: a record is a file, '- before', '+ after' and a reason:\n{record}")
        found[lines[0].strip(), lines[1][2:].strip(), lines[2][2:].strip()] = " ".join(lines[3:])
    return found


def load():
    return json.loads(FILE.read_text(encoding="utf-8")) if FILE.exists() else {}


def save(results):
    FILE.write_text(json.dumps(results, indent=1, sort_keys=True, ensure_ascii=False) + "\n", encoding="utf-8")


REQUIRED = 90  # percent


def rate(killed, survived):
    """In percent, rounded down: 90 means at least 90."""
    return 100 * killed // (killed + survived) if killed + survived else 100


def survivors(root, row):
    """The mutants of a module that survived its last run, where their lines still stand."""
    for file, before, after, turn in row["survived"]:
        same = same_lines(root / file, before)
        if turn < len(same):
            number, line = same[turn]
            yield Mutant(file, number, line, line[:len(line) - len(line.lstrip())] + after)


def same_lines(path, before):
    lines = path.read_text(encoding="utf-8").split("\n") if path.exists() else []
    return [(number, line) for number, line in enumerate(lines, 1) if line.strip() == before]


def survivor(root, mutant):
    """How a survivor is recorded: without the number of its line, but as the how manieth of the same lines (from 0)."""
    before = mutant.before.strip()
    turn = [number for number, _ in same_lines(root / mutant.file, before)].index(mutant.line)
    return [*mutant.key(), turn]


PAGE = """# Mutated rules

A test must be able to fail. `tools/mutate` changes one line of a rule under `src/` (a comparison, a number by one, a mask by a
bit, a condition, a sign, a statement that is left out, a value that is returned), compiles only that file, links it into the
tests in place of the original, and checks which test fails. A mutant that no test notices *survives* and is printed with its
line: a test is missing there.

```sh
tools/mutate --changed main          # the lines that are new since main, at most 40 mutants
tools/mutate --module plant --count 20 --seed 7
tools/mutate --module plant --list   # only show them
```

It works in a copy of the tree (`build/mutation`) with a build folder of its own; the first run compiles everything once. The
module's own test runs first, then all tests of ctest whose program contains the module, those that notice most for their time
first, until one fails; a test counts only if it passes with the unchanged file. Tests that take longer than a minute
(`--slowest`), browsers and documents are left out. A mutant that does not compile does not count; nor does one that no test can
see, which is listed with the reason in [tools/mutation/equivalent.txt](../tools/mutation/equivalent.txt). One that does not end is
noticed. The same seed gives the same mutants as long as their lines stay. The exit code is 1 below 90 % (`--required`).
`--record` writes [the results](../tools/mutation/results.json), `--again` tries only the recorded survivors, `--page write`
prints this page. Rules in headers and in `.inc` tables are not mutated: hundreds of files would compile for each.

At least 90 % of each module's mutants must be noticed; a test fails below that. The table shows few mutants of each module (up to
ten, seed 1), and tests were written for most of the first survivors: another seed will find more. The row of a module is updated by
a manual run; `--changed` checks changed lines.

| module | mutants | noticed | rate | equivalent |
|---|---|---|---|---|
"""


def page(results):
    lines, killed, survived, equal = [], 0, 0, 0
    for module, row in sorted(results.items()):
        left = len(row["survived"])
        percent = rate(row["killed"], left)
        shown = f"{percent} %" if percent >= REQUIRED else f"**{percent} %**"
        lines.append(f"| `{module}` | {row['killed'] + left} | {row['killed']} | {shown} | {row['equivalent']} |")
        killed, survived, equal = killed + row["killed"], survived + left, equal + row["equivalent"]
    lines.append(f"| all | {killed + survived} | {killed} | {rate(killed, survived)} % | {equal} |")
    return PAGE + "\n".join(lines) + "\n"
