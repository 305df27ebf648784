"""Interpreter and compiled code put the same characters on the line at the same nanosecond: every scenario of the serial interface."""
import pathlib
import re

from harness import *

ROOT = pathlib.Path(__file__).resolve().parents[2]


def scenarios():
    """Project, file and name of each scenario of a project with a serial interface."""
    for folder in (ROOT / "tests/scenario/serial", ROOT / "examples/technology"):
        for toml in sorted(folder.rglob("merker.toml")):
            if "[module.serial]" not in toml.read_text(encoding="utf-8"):
                continue
            for file in sorted(toml.parent.glob("*.scn")):
                for name in re.findall(r'^scenario "(.*)"', file.read_text(encoding="utf-8"), re.MULTILINE):
                    yield toml.parent, file, name


class Engines(Case):
    def line(self, engine, project, file, name):
        self.expect(GOOD, "monitor", "serial", str(project), "--scenario", str(file), "--name", name, "--csv", "line.csv", "--engine", engine)
        return self.read("line.csv")

    def test_the_same_characters_at_the_same_time(self):
        characters = 0
        for where in scenarios():
            with self.subTest(name=where[2]):
                lines = [self.line(engine, *where) for engine in ("interpreter", "jit")]
                self.assertEqual(lines[0], lines[1])
                characters += lines[0].count("\n")
        self.assertGreater(characters, 5_000)

    def test_every_scenario_passes_with_compiled_code(self):
        self.expect(GOOD, "test", "--engine", "jit", str(ROOT / "tests/scenario/serial"), str(ROOT / "examples/technology"))


if __name__ == "__main__":
    unittest.main()
