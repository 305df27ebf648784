#!/usr/bin/env python3
"""The rules themselves: each finds what it is for in a small tree made for it, and nothing in a tree that is right."""
import pathlib
import tempfile
import unittest

from rules import LONGEST, MAY_ASK_FOR_THE_FAMILY, RULES

HEAD = "| module | responsibility | may include |\n|---|---|---|\n"
PICTURE = f"""
### [`ground`](../src/ground): first
{HEAD}| [`base`](../src/ground/base) | first | – |
| [`clock`](../src/ground/clock) | second | base |

### [`s7`](../src/s7): second
{HEAD}| [`cpu`](../src/s7/cpu) | third | clock |

### [`s5`](../src/s5): third
{HEAD}| [`mc5`](../src/s5/mc5) | fourth | clock |
"""
RIGHT = {
    "docs/architecture.md": PICTURE,
    "src/ground/README.md": "ground", "src/s7/README.md": "s7", "src/s5/README.md": "s5",
    "src/ground/base/README.md": "base", "src/ground/base/a.h": "#pragma once\n",
    "src/ground/clock/README.md": "clock", "src/ground/clock/b.h": '#include "base/a.h"\n',
    "src/s7/cpu/README.md": "cpu", "src/s7/cpu/c.cpp": '#include "base/a.h"\n#include "cpu/c.h"\n#include <vector>\n',
    "src/s7/cpu/CMakeLists.txt": "merker_module(cpu SOURCES c.cpp\n              USES clock fmt::fmt)\n",
    "src/s5/mc5/README.md": "mc5", "src/s5/mc5/d.h": '#include "clock/b.h"\n',
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
        self.assertTrue(self.findings("include_rule", {"src/ground/base/a.h": '#include "clock/b.h"\n'}))

    def test_what_a_module_stands_on_is_allowed_but_not_what_its_neighbour_uses(self):
        self.assertTrue(self.findings("include_rule", {"src/ground/clock/b.h": '#include "cpu/c.h"\n'}))

    def test_nobody_includes_the_program(self):
        self.assertTrue(self.findings("include_rule", {"src/s7/cpu/c.cpp": '#include "apps/merker/run.h"\n'}))
        self.assertTrue(self.findings("include_rule", {"src/s7/cpu/c.cpp": '#include "../apps/merker/run.h"\n'}))

    def test_a_library_uses_what_its_module_may_include(self):
        self.assertTrue(self.findings("link_rule", {"src/ground/clock/CMakeLists.txt": "merker_module(clock USES base cpu)\n"}))

    def test_neither_family_sees_the_other_one(self):
        allowing = PICTURE.replace("| fourth | clock |", "| fourth | cpu |")
        for changes in ({"src/s5/mc5/d.h": '#include "cpu/c.h"\n'}, {"src/s7/cpu/c.cpp": '#include "mc5/d.h"\n'},
                        {"src/s5/mc5/CMakeLists.txt": "merker_module(mc5 USES clock cpu)\n"}, {"docs/architecture.md": allowing}):
            self.assertTrue(self.findings("families_apart", changes), changes)
        # Nor if its row allows it: that rule alone would be content.
        both = {"docs/architecture.md": allowing, "src/s5/mc5/d.h": '#include "cpu/c.h"\n'}
        self.assertFalse(self.findings("include_rule", both))
        self.assertEqual(len(self.findings("families_apart", both)), 2)

    def test_nobody_asks_for_the_family_of_a_plc(self):
        for line in ("if (plc.isS7()) return;\n", "auto* s = dynamic_cast<station::Station*>(&plc);\n",
                     "auto& c = dynamic_cast<const cnc::Cnc&>(plc);\n", "static_cast<Cnc&>(plc).control();\n"):
            self.assertEqual(len(self.findings("family_question", {"apps/merker/a.cpp": line})), 1, line)
            self.assertEqual(len(self.findings("family_question", {"src/s7/cpu/c.cpp": line})), 1, line)
            self.assertFalse(self.findings("family_question", {MAY_ASK_FOR_THE_FAMILY[0]: line}), line)
        other = "auto* s = dynamic_cast<const StopScreens*>(&plc);  // isS7Like, Stationary\n"
        self.assertFalse(self.findings("family_question", {"apps/merker/a.cpp": other}))

    def test_nor_does_the_page(self):
        for line in ("{#if plc.project?.family === 'S7'}\n", "{#if !plc.isStep5}\n"):
            self.assertEqual(len(self.findings("family_question", {"web/src/cpu/Leds.svelte": line})), 1, line)
        self.assertFalse(self.findings("family_question", {"web/src/cpu/Leds.svelte": "font-family: sans;\n"}))

    def test_picture_and_folders_agree(self):
        def found(picture):
            return self.findings("same_modules", {"docs/architecture.md": picture})
        self.assertTrue(self.findings("same_modules", {"src/s7/jit/README.md": "jit"}))
        self.assertTrue(found(PICTURE + "| [`jit`](../src/s5/jit) | fifth | cpu |\n"))
        self.assertTrue(found(PICTURE.replace("| first | – |", "| first | cpu |")))
        self.assertTrue(found(PICTURE.replace("(../src/s7/cpu)", "(../src/s5/cpu)")))
        self.assertTrue(found(PICTURE.replace("(../src/s7):", "(../src/s5):")))

    def test_wings_are_in_order(self):
        ground, s7, s5 = PICTURE.split("\n### ")[1:]
        swapped = "\n### ".join(["", s7, ground, s5])
        self.assertEqual(self.findings("same_modules", {"docs/architecture.md": swapped}),
                         ["docs/architecture.md: cpu uses clock, which stands below it"])

    def test_a_name_stands_once(self):
        twice = PICTURE + "| [`cpu`](../src/s5/cpu) | fifth | clock |\n"
        self.assertTrue(self.findings("same_modules", {"docs/architecture.md": twice, "src/s5/cpu/README.md": "cpu"}))

    def test_code_stands_in_modules(self):
        self.assertTrue(self.findings("same_modules", {"src/s7/cpu/more/still/c.cpp": "\n"}))

    def test_a_folder_inside_a_module_keeps_to_the_rows_of_the_module(self):
        self.assertTrue(self.findings("include_rule", {"src/ground/base/more/c.cpp": '#include "cpu/x.h"\n'}))

    def test_each_wing_and_module_has_a_readme(self):
        self.assertTrue(self.findings("module_readmes", {"src/ground/base/README.md": None}))
        self.assertTrue(self.findings("module_readmes", {"src/ground/README.md": None}))

    def test_long_files(self):
        self.assertTrue(self.findings("short_files", {"src/s7/cpu/c.cpp": "\n" * (LONGEST + 1)}))
        self.assertFalse(self.findings("short_files", {"src/s7/cpu/c.cpp": "\n" * LONGEST}))

    def test_unfinished_code(self):
        self.assertTrue(self.findings("finished", {"src/s7/cpu/c.cpp": "// TO" "DO: later\n"}))

    def test_paths_of_a_machine(self):
        self.assertTrue(self.findings("no_workplace", {"docs/a.md": "see /ho" "me/me/project\n"}))


unittest.main()
