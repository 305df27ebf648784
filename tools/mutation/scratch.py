"""A copy of the tree with a build folder of its own. A mutant is compiled beside it and linked in place of the file it stands
for; nothing in the copy changes, so that the next mutant finds everything built."""
import filecmp
import hashlib
import json
import os
import pathlib
import re
import resource
import shlex
import shutil
import signal
import subprocess

FLAGS = "-O1 -g0"
MEMORY = 8 << 30  # bytes that a program under test may ask for


def limited():
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))


def run(command, seconds, cwd, environment=None):
    """Exit code and output; None if it did not end in time."""
    process = subprocess.Popen(command, cwd=cwd, env=environment, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                               stderr=subprocess.STDOUT, start_new_session=True, preexec_fn=limited)
    try:
        output, _ = process.communicate(timeout=seconds)
        return process.returncode, output.decode("utf-8", "replace")
    except subprocess.TimeoutExpired:
        return None, f"no end within {seconds:.0f} s"
    finally:
        try:
            os.killpg(process.pid, signal.SIGKILL)  # with everything it has started
        except ProcessLookupError:
            pass
        process.wait()


def tracked(root):
    names = subprocess.run(["git", "-C", str(root), "ls-files", "-z", "--cached", "--others", "--exclude-standard"], check=True,
                           capture_output=True).stdout.decode().split("\0")
    return [name for name in names if name and (root / name).is_file()]


class DoesNotLink(Exception):
    """A mutant that compiles, but not into a program."""


class Scratch:
    def __init__(self, root, folder, build):
        self.tree, self.build, self.out = folder, folder / build, folder / "mutant"
        self.copy(root)

    def copy(self, root):
        """What git knows or would take, but only what is not the same yet, so that nothing else compiles again."""
        names = tracked(root)
        state = hashlib.sha256()
        for name in names:
            source, target = root / name, self.tree / name
            if not target.exists() or not filecmp.cmp(source, target, shallow=False):
                target.parent.mkdir(parents=True, exist_ok=True)
                shutil.copy(source, target)
            if name.split("/")[0] not in ("docs", "web", "tools"):
                state.update(f"{name} {hashlib.sha256(source.read_bytes()).hexdigest()}\n".encode())
        self.state = state.hexdigest()
        listed = self.tree / ".copied"
        gone = set(listed.read_text(encoding="utf-8").split("\0")) - set(names) if listed.exists() else ()
        for name in filter(None, gone):
            (self.tree / name).unlink(missing_ok=True)
        listed.write_text("\0".join(names), encoding="utf-8")

    def make(self, jobs):
        """Everything that is not mutated, compiled once."""
        if not (self.build / "CMakeCache.txt").exists():
            print(f"everything is compiled once in {self.build}: minutes, later runs only compile what changed", flush=True)
            options = ["-DCMAKE_BUILD_TYPE=Release", f"-DCMAKE_CXX_FLAGS_RELEASE={FLAGS}", "-DMERKER_PAGE=OFF",
                       "-DMERKER_BROWSER_TESTS=OFF"]
            if shutil.which("mold"):
                options.append("-DCMAKE_EXE_LINKER_FLAGS=-fuse-ld=mold")
            subprocess.run(["cmake", "-S", self.tree, "-B", self.build, "-G", "Ninja", *options], check=True,
                           stdout=subprocess.DEVNULL)
        made = subprocess.run(["cmake", "--build", self.build, "-j", str(jobs)], capture_output=True, encoding="utf-8", check=False)
        if made.returncode != 0:
            raise SystemExit(f"tools/mutate: the tree does not build\n{made.stdout[-4000:]}")
        self.rows = {row["file"]: row for row in json.loads((self.build / "compile_commands.json").read_text())}
        self.links = {}
        self.uses = {path.parent.name: self.used(path) | self.tested(path.parent.name)
                     for path in (self.tree / "src").glob("*/*/CMakeLists.txt")}
        self.out.mkdir(exist_ok=True)

    def used(self, path):
        """What a module uses directly."""
        uses = re.search(r"\bUSES\b([^)]*)", path.read_text(encoding="utf-8"))
        return set(uses.group(1).split()) if uses else set()

    def tested(self, module):
        """Whose headers the module's own test includes."""
        texts = [path.read_text(encoding="utf-8") for path in (self.tree / "tests" / "unit" / module).glob("*.*")]
        return set(re.findall(r'^#include "(\w+)/', "\n".join(texts), re.MULTILINE))

    def command(self, file):
        words = shlex.split(self.rows[str(self.tree / file)]["command"])
        return words[1:] if pathlib.Path(words[0]).name == "ccache" else words

    def prepared(self, file):
        """A header of all foreign headers the file's module includes, compiled once for all its mutants."""
        words = self.command(file)
        module = file.split("/")[2]
        flags = words[:words.index("-o")]
        header = self.out / f"{module}.h"
        text = "".join(f"#include <{name}>\n" for name in sorted(self.foreign(module)))
        compiled = header.with_suffix(".h.gch")
        if not compiled.exists() or not header.exists() or header.read_text(encoding="utf-8") != text:
            header.write_text(text, encoding="utf-8")
            subprocess.run([*flags, "-w", "-O0", "-x", "c++-header", header, "-o", compiled], cwd=self.build, check=False)
        return flags, header

    def foreign(self, module):
        found, waiting, seen = set(), list((self.tree / "src").glob(f"*/{module}/*.cpp")), set()
        while waiting:
            path = waiting.pop()
            if path in seen or not path.is_file():
                continue
            seen.add(path)
            for bracket, name in re.findall(r'^#include ([<"])([^>"]+)', path.read_text(encoding="utf-8"), re.MULTILINE):
                if bracket == "<":
                    found.add(name)
                else:
                    waiting += (self.tree / "src").glob(f"*/{name}")
        return found

    def compile(self, mutant, seconds, changed=True):
        """The object file of a mutant, or None if it is no C++; with `changed` off that of the file as it is."""
        flags, header = self.prepared(mutant.file)
        lines = (self.tree / mutant.file).read_text(encoding="utf-8").split("\n")
        if changed:
            lines[mutant.line - 1] = mutant.after
        name = "mutant" if changed else "unchanged"
        source, target = self.out / f"{name}.cpp", self.out / f"{name}.o"
        source.write_text("\n".join(lines), encoding="utf-8")
        target.unlink(missing_ok=True)
        code, _ = run([*flags, "-w", "-O0", "-include", str(header), "-o", str(target), "-c", str(source)], seconds, self.build)
        return target if code == 0 else None

    def link_command(self, program):
        """How a program of the build folder is linked."""
        if program not in self.links:
            done = subprocess.run(["ninja", "-t", "commands", "-s", program], cwd=self.build, check=True, capture_output=True,
                                  encoding="utf-8")
            self.links[program] = done.stdout.strip().splitlines()[-1]
        return self.links[program]

    def holds(self, program, module):
        return f"libmerker_{module}.a" in self.link_command(program)

    def link(self, program, target):
        """The program with the mutant's object file: the file it stands for is then never taken out of its library."""
        made = self.out / pathlib.Path(program).name
        made.unlink(missing_ok=True)
        command = self.link_command(program).replace(f" -o {program} ", f" -o {shlex.quote(str(made))} {shlex.quote(str(target))} ", 1)
        done = subprocess.run(["sh", "-c", command], cwd=self.build, capture_output=True, check=False)
        if done.returncode != 0:
            raise DoesNotLink(program)
        return made
