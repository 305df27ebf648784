"""The tests that may notice a mutant: those of ctest whose program contains the mutated module, the module's own first, then
those that notice most for their time."""
import dataclasses
import json
import os
import pathlib
import re
import subprocess
import time

from mutation.scratch import run

# Tests of documents, of the page and of broken emitters say nothing about a rule; pages need a browser.
LEFT_OUT = re.compile(r"documents_|architecture_|page_|browser_|card_kill")
# Fewer random cases, the same ones every time, and no test after the first that fails.
SHORT = {"GTEST_FAIL_FAST": "1", "GTEST_BRIEF": "1", "GTEST_FILTER": "-Mutation/*", "MERKER_DIFFERENTIAL": "1:1500",
         "RC_PARAMS": "seed=314 max_success=300", "PYTHONDONTWRITEBYTECODE": "1", "MERKER_FAIL_FAST": "1"}

# Long tests of something else than the module: they run for these only. Others run for every module they contain.
ENGINES = {"icode", "jit", "cpu", "block"}
ONLY = {"differential": ENGINES | {"lowering", "interpreter", "mc7", "station"},
        "conformance_jit": ENGINES | {"lowering", "station", "plc"},
        "scenarios_jit": ENGINES | {"lowering", "station", "plc"},
        "differential_step5": ENGINES | {"lowering5", "softplc", "control", "mc5", "plc"}}
LONG = 1  # seconds; a longer unit test of another module must use the mutated one directly


@dataclasses.dataclass
class Stage:
    name: str
    command: list
    environment: dict
    folder: str
    programs: list  # below the build folder


class Stages:
    def __init__(self, scratch, slowest):
        self.scratch, self.slowest = scratch, slowest
        self.file = scratch.tree / "mutation.json"
        known = json.loads(self.file.read_text(encoding="utf-8")) if self.file.exists() else {}
        self.kills, self.seconds = known.get("kills", {}), known.get("seconds", {})
        self.green = known.get("green", {}) if known.get("state") == scratch.state else {}
        self.all = list(self.read())
        self.trusted = {}  # (module, stage) to whether it passes with a file compiled as mutants are

    def read(self):
        listed = subprocess.run(["ctest", "--test-dir", self.scratch.build, "--show-only=json-v1"], check=True,
                                capture_output=True, encoding="utf-8").stdout
        for test in json.loads(listed)["tests"]:
            if LEFT_OUT.match(test["name"]) or "command" not in test:
                continue
            properties = {row["name"]: row["value"] for row in test.get("properties", [])}
            environment = dict(row.split("=", 1) for row in properties.get("ENVIRONMENT", [])) | SHORT
            command = test["command"] + (["--failfast"] if "unittest" in test["command"] else [])
            stage = Stage(test["name"], command, environment, properties.get("WORKING_DIRECTORY", str(self.scratch.build)), [])
            stage.programs = sorted(self.programs(stage))
            if stage.programs:
                yield stage
        merker = str(self.scratch.build / "merker")
        yield Stage("examples", [merker, "test", str(self.scratch.tree / "examples")], dict(SHORT), str(self.scratch.tree), ["merker"])

    def programs(self, stage):
        for text in (*stage.command, *stage.environment.values()):
            path = pathlib.Path(text)
            if path.is_absolute() and path.is_relative_to(self.scratch.build) and path.is_file() and os.access(path, os.X_OK):
                yield path.relative_to(self.scratch.build).as_posix()

    def save(self):
        self.file.write_text(json.dumps({"state": self.scratch.state, "kills": self.kills, "seconds": self.seconds,
                                         "green": self.green}), encoding="utf-8")

    def of(self, module):
        """In the order in which they run."""
        kills = self.kills.get(module, {})

        def rank(stage):
            guess = 1 if stage.name in stage.programs[0] else 20
            cost = self.seconds.get(stage.name, guess) + 0.5
            return stage.name != module, -(kills.get(stage.name, 0) + 0.1) / cost

        fitting = [s for s in self.all if any(self.scratch.holds(p, module) for p in s.programs) and self.concerns(s, module)]
        return sorted(fitting, key=rank)

    def concerns(self, stage, module):
        seconds = self.seconds.get(stage.name, 0)
        whole = re.sub(r"_\d+$", "", stage.name)  # of which it is a shard
        if seconds > self.slowest or module not in ONLY.get(whole, {module}):
            return False
        other = self.scratch.uses.get(stage.name)
        return stage.name == module or other is None or seconds <= LONG or module in other

    def is_green(self, stage):
        """Whether it passes without any mutant; what does not says nothing."""
        if stage.name not in self.green:
            begin = time.monotonic()
            code, output = self.start(stage, {}, 20 * self.slowest)
            if code != 0:  # a busy machine?
                code, output = self.start(stage, {}, 20 * self.slowest)
            self.seconds[stage.name] = time.monotonic() - begin
            self.green[stage.name] = code == 0
            if code != 0:
                print(f"left out: {stage.name} fails without a mutant\n{output[-1500:]}", flush=True)
            self.save()
        return self.green[stage.name] and self.seconds[stage.name] <= self.slowest

    def start(self, stage, mutated, seconds):
        """`mutated`: path of a program to the path of the one that runs in its place."""
        command = [mutated.get(word, word) for word in stage.command]
        environment = os.environ | {name: mutated.get(value, value) for name, value in stage.environment.items()}
        return run(command, seconds, stage.folder, environment)

    def linked(self, stage, module, target):
        """The stage's programs with this object file: the paths they replace to their own."""
        return {str(self.scratch.build / program): str(self.scratch.link(program, target))
                for program in stage.programs if self.scratch.holds(program, module)}

    def is_trusted(self, stage, module, mutant, patience):
        """Once for each module: a failure counts only where the unchanged file, compiled and linked the same way, passes."""
        key = module, stage.name
        if key not in self.trusted:
            target = self.scratch.compile(mutant, 10 * patience, changed=False)
            code, output = self.start(stage, self.linked(stage, module, target), max(patience, 5 * self.seconds[stage.name]))
            self.trusted[key] = code == 0
            if code != 0:
                print(f"left out for {module}: {stage.name} fails with the unchanged {mutant.file}\n{output[-1500:]}", flush=True)
        return self.trusted[key]

    def killer(self, module, mutant, target, patience):
        """The first stage that notices the mutant of this object file, or None."""
        for stage in self.of(module):
            if not self.is_green(stage) or not self.trusted.get((module, stage.name), True):
                continue
            code, _ = self.start(stage, self.linked(stage, module, target), max(patience, 5 * self.seconds[stage.name]))
            if code != 0 and self.is_trusted(stage, module, mutant, patience):
                kills = self.kills.setdefault(module, {})
                kills[stage.name] = kills.get(stage.name, 0) + 1
                return stage.name if code is not None else f"{stage.name} (no end)"
        return None
