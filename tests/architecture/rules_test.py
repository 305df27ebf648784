#!/usr/bin/env python3
"""The rules themselves: each finds what it is for in a small tree made for it, and nothing in a tree that is right."""
import pathlib
import tempfile
import unittest

from rules import LONGEST, RULES

PICTURE = """
| module | responsibility | may include |
|---|---|---|
| [`base`](../src/base) | first | – |
| [`clock`](../src/clock) | second | base |
| [`cpu`](../src/cpu) | third | clock |
"""
RIGHT = {
    "docs/architecture.md": PICTURE,
    "src/base/README.md": "base", "src/base/a.h": "#pragma once\n",
    "src/clock/README.md": "clock", "src/clock/b.h": '#include "base/a.h"\n',
    "src/cpu/README.md": "cpu", "src/cpu/c.cpp": '#include "base/a.h"\n#include "cpu/c.h"\n#include <vector>\n',
}


class Rules(unittest.TestCase):
    def findings(self, rule, changes):
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder)
            for name, text in {**RIGHT, **changes}.items():
                if text is not None:
                    (root / name).parent.mkdir(parents=True, exist_ok=True)
                    (root / name).write_text(text, encoding="utf-8")
            return list(RULES[rule](root))

    def test_a_right_tree_has_no_findings(self):
        for rule in RULES:
            self.assertEqual(self.findings(rule, {}), [], rule)

    def test_a_module_may_not_look_back(self):
        self.assertTrue(self.findings("include_rule", {"src/base/a.h": '#include "clock/b.h"\n'}))

    def test_what_a_module_stands_on_is_allowed_but_not_what_its_neighbour_uses(self):
        self.assertTrue(self.findings("include_rule", {"src/clock/b.h": '#include "cpu/c.h"\n'}))

    def test_nobody_includes_the_program(self):
        self.assertTrue(self.findings("include_rule", {"src/cpu/c.cpp": '#include "apps/merker/run.h"\n'}))
        self.assertTrue(self.findings("include_rule", {"src/cpu/c.cpp": '#include "../apps/merker/run.h"\n'}))

    def test_picture_and_folders_agree(self):
        self.assertTrue(self.findings("same_modules", {"src/jit/README.md": "jit"}))
        more = PICTURE + "| [`jit`](../src/jit) | fourth | cpu |\n"
        self.assertTrue(self.findings("same_modules", {"docs/architecture.md": more}))
        back = PICTURE.replace("| first | – |", "| first | cpu |")
        self.assertTrue(self.findings("same_modules", {"docs/architecture.md": back}))

    def test_each_module_has_a_readme(self):
        self.assertTrue(self.findings("module_readmes", {"src/base/README.md": None}))

    def test_long_files(self):
        self.assertTrue(self.findings("short_files", {"src/cpu/c.cpp": "\n" * (LONGEST + 1)}))
        self.assertFalse(self.findings("short_files", {"src/cpu/c.cpp": "\n" * LONGEST}))

    def test_unfinished_code(self):
        self.assertTrue(self.findings("finished", {"src/cpu/c.cpp": "// TO" "DO: later\n"}))

    def test_paths_of_a_machine(self):
        self.assertTrue(self.findings("no_workplace", {"docs/a.md": "see /ho" "me/me/project\n"}))


unittest.main()
