"""The mutants of files, in an order that a seed decides and that stays when other lines change."""
import collections
import dataclasses
import hashlib
import re
import subprocess

from mutation.code import code_lines
from mutation.operators import mutants_of

BEGINS_AFTER = re.compile(r"(?:[;{})]|\belse|:)\s*$")


@dataclasses.dataclass(frozen=True)
class Mutant:
    file: str  # below the root, with "/"
    line: int  # from 1 on
    before: str
    after: str

    def key(self):
        """What it is wherever the line stands."""
        return self.file, self.before.strip(), self.after.strip()


def of_file(root, file):
    """The mutants of a file, a list for each line that has any."""
    text = (root / file).read_text(encoding="utf-8")
    lines, continues = text.split("\n"), False
    for number, (line, code) in enumerate(zip(lines, code_lines(text)), 1):
        found = [Mutant(file, number, line, after) for _, after in mutants_of(line, code, continues)]
        if found:
            yield list(dict.fromkeys(found))
        if code.strip():
            continues = not BEGINS_AFTER.search(code.rstrip())


def files_of(root, module):
    return sorted(path.relative_to(root).as_posix() for path in (root / "src").glob(f"*/{module}/*.cpp"))


def modules(root):
    return sorted(path.name for path in (root / "src").glob("*/*") if path.is_dir() and files_of(root, path.name))


def number(seed, *parts):
    return hashlib.sha256("\0".join((str(seed), *parts)).encode()).hexdigest()


def sample(lines, seed):
    """All mutants, one of each line first, then a second one, and so on."""
    seen, ordered = collections.Counter(), []
    for mutants in lines:
        place = (mutants[0].file, mutants[0].before)
        seen[place] += 1
        mixed = sorted(mutants, key=lambda m: number(seed, m.file, m.before, m.after))
        ordered += [(turn, number(seed, *place, str(seen[place])), m) for turn, m in enumerate(mixed)]
    return [mutant for _, _, mutant in sorted(ordered, key=lambda row: row[:2])]


def git(root, *words):
    done = subprocess.run(["git", "-C", str(root), *words], capture_output=True, encoding="utf-8", check=False)
    if done.returncode != 0:
        raise SystemExit(f"tools/mutate: git {words[0]}: {done.stderr.strip()}")
    return done.stdout


def changed_lines(root, base):
    """(file, line) of each line under src/ that is new since `base`, committed or not, and of files git does not know yet."""
    found, file = set(), None
    for name in git(root, "ls-files", "--others", "--exclude-standard", "--", "src").splitlines():
        found |= {(name, n) for n, _ in enumerate((root / name).read_text(encoding="utf-8").split("\n"), 1)}
    for line in git(root, "diff", "-U0", "--no-color", base, "--", "src").splitlines():
        if line.startswith("+++ "):
            file = line[6:] if line.startswith("+++ b/") else None
        hunk = re.match(r"@@ -\S+ \+(\d+)(?:,(\d+))? @@", line)
        if hunk and file:
            first, count = int(hunk.group(1)), int(hunk.group(2) or 1)
            found |= {(file, n) for n in range(first, first + count)}
    return found


def of_changes(root, base):
    """Lines of mutants of what is new since `base`."""
    wanted = changed_lines(root, base)
    for file in sorted({file for file, _ in wanted if file.endswith(".cpp")}):
        for mutants in of_file(root, file):
            if (file, mutants[0].line) in wanted:
                yield mutants


def of_module(root, module):
    for file in files_of(root, module):
        yield from of_file(root, file)
