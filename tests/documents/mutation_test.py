#!/usr/bin/env python3
"""tools/mutate: which mutants a line has, which lines have none, and that a seed always gives the same ones."""
import pathlib
import subprocess
import sys
import tempfile
import unittest

TOOLS = pathlib.Path(__file__).resolve().parents[2] / "tools"
sys.path.insert(0, str(TOOLS))
from mutation import candidates, results  # noqa: E402  (the path above)
from mutation.code import code_lines  # noqa: E402
from mutation.operators import mutants_of  # noqa: E402
from mutation.scratch import Scratch  # noqa: E402


def of(line, continues=False):
    return [after.strip() for _, after in mutants_of(line, code_lines(line)[0], continues)]


class Operators(unittest.TestCase):
    def test_comparison_and_condition(self):
        found = of("  if (a < 10 && b) return 3;")
        for mutant in ("if (a <= 10 && b) return 3;", "if (a < 10 || b) return 3;", "if (a < 11 && b) return 3;",
                       "if (a < 9 && b) return 3;", "if (a < 10 && b) return 4;", "if (!(a < 10 && b)) return 3;", ";"):
            self.assertIn(mutant, found)

    def test_sign_words_and_calls(self):
        self.assertIn("x = a - std::min(b, c);", of("x = a + std::min(b, c);"))
        self.assertIn("x = a + std::max(b, c);", of("x = a + std::min(b, c);"))
        self.assertIn("x = b;", of("x = !b;"))
        self.assertIn("on = false;", of("on = true;"))

    def test_masks_move_by_a_bit(self):
        self.assertIn("x = y & 0x1E;", of("x = y & 0x0F;"))
        self.assertIn("x = y & 0x7FFF;", of("x = y & 0xFFFF;"))
        self.assertIn("x = y | 0x0F;", of("x = y & 0x0F;"))

    def test_statements_and_results(self):
        self.assertIn(";", of("  total.add(x);"))
        self.assertIn("return {};", of("  return a.b(c);"))
        self.assertNotIn(";", of("  int total = sum(x);"))
        self.assertNotIn(";", of("  add(x);", continues=True))
        self.assertEqual(of("  return {};"), [])

    def test_templates_pointers_and_references_are_no_operators(self):
        for line in ("  std::vector<int> list(const T& a, T* b, T&& c);", "template <int N>", "#include <a/b>", "// a + b == 1",
                     'static_assert(sizeof(x) == 4);', "using A = B<3>;"):
            self.assertEqual(of(line), [], line)

    def test_texts_and_comments_stay(self):
        for mutant in of('say("1 < 2", \'7\', x);  // 3 + 4'):
            self.assertTrue(mutant.startswith(";  //") or mutant.startswith('say("1 < 2", \'7\', x)'), mutant)
        self.assertEqual(code_lines("a /* 1\n2 */ 1'000 b"), ["a     ", "     1'000 b"])


class Sample(unittest.TestCase):
    def lines(self, text):
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder)
            (root / "src" / "w" / "m").mkdir(parents=True)
            (root / "src" / "w" / "m" / "a.cpp").write_text(text, encoding="utf-8")
            return list(candidates.of_module(root, "m"))

    def test_the_same_seed_the_same_mutants(self):
        text = "".join(f"int f{i}(int a) {{\n  return a + {i + 5};\n}}\n" for i in range(9))
        first = [m.key() for m in candidates.sample(self.lines(text), 1)]
        self.assertEqual(first, [m.key() for m in candidates.sample(self.lines(text), 1)])
        self.assertNotEqual(first, [m.key() for m in candidates.sample(self.lines(text), 2)])
        self.assertEqual(first, [m.key() for m in candidates.sample(self.lines("int other;\n" + text), 1)])
        self.assertEqual(len({m[1] for m in first[:9]}), 9, "one of each line first")

    def test_changed_lines_alone(self):
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder)
            file = root / "src" / "w" / "m" / "a.cpp"
            file.parent.mkdir(parents=True)

            def git(*words):
                subprocess.run(["git", "-C", folder, "-c", "user.name=a", "-c", "user.email=a@b", *words], check=True,
                               capture_output=True)
            git("init", "-q")
            file.write_text("int f(int a) {\n  return a + 1;\n}\n", encoding="utf-8")
            git("add", ".")
            git("commit", "-qm", "one")
            file.write_text("int f(int a) {\n  a *= 2;\n  return a + 1;\n}\n", encoding="utf-8")
            found = candidates.sample(candidates.of_changes(root, "HEAD"), 1)
            self.assertEqual({m.before for m in found}, {"  a *= 2;"})
            (file.parent / "new.cpp").write_text("int g(int a) {\n  return a - 1;\n}\n", encoding="utf-8")
            found = candidates.sample(candidates.of_changes(root, "HEAD"), 1)
            self.assertEqual({m.before for m in found}, {"  a *= 2;", "  return a - 1;"})
            with self.assertRaises(SystemExit):
                candidates.changed_lines(root, "nothing")


class Tests(unittest.TestCase):
    def test_a_test_belongs_to_the_modules_whose_headers_it_includes(self):
        with tempfile.TemporaryDirectory() as folder:
            scratch = Scratch.__new__(Scratch)  # without the tree
            scratch.tree = pathlib.Path(folder)
            place = scratch.tree / "tests" / "unit" / "station"
            place.mkdir(parents=True)
            (place / "a_test.cpp").write_text('#include "cpu/cpu.h"\n#include "program.h"\n#include <io/x>\n', encoding="utf-8")
            (place / "program.h").write_text('  // #include "jit/x.h"\n#include "station/station.h"\n', encoding="utf-8")
            self.assertEqual(scratch.tested("station"), {"cpu", "station"})
            self.assertEqual(scratch.tested("none"), set())


class Results(unittest.TestCase):
    def test_rate_is_rounded_down(self):
        self.assertEqual(results.rate(9, 1), 90)
        self.assertEqual(results.rate(899, 101), 89)
        self.assertEqual(results.rate(0, 0), 100)

    def test_survivors_are_found_again(self):
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder)
            (root / "a.cpp").write_text("x();\n  f();\ny();\n    f();\n", encoding="utf-8")
            mutant = candidates.Mutant("a.cpp", 4, "    f();", "    ;")
            row = {"survived": [results.survivor(root, mutant)]}
            self.assertEqual(list(results.survivors(root, row)), [mutant])
            (root / "a.cpp").write_text("f();\n", encoding="utf-8")
            self.assertEqual(list(results.survivors(root, row)), [])

    def test_equivalents_name_lines_that_stand_there(self):
        root = TOOLS.parent
        for (file, before, after), reason in results.equivalents().items():
            lines = [line.strip() for line in (root / file).read_text(encoding="utf-8").splitlines()]
            self.assertIn(before, lines, file)
            self.assertNotEqual(before, after)
            self.assertGreater(len(reason), 20, before)


class Command(unittest.TestCase):
    def test_list_changes_nothing_and_a_wrong_module_is_told(self):
        def run(*words):
            return subprocess.run([sys.executable, "-B", str(TOOLS / "mutate"), *words], capture_output=True, encoding="utf-8", check=False)
        done = run("--module", "clock", "--list")
        self.assertNotEqual(done.returncode, 0)
        self.assertIn("there is no", done.stderr)
        done = run("--module", "signal", "--list", "--count", "3")
        self.assertEqual((done.returncode, done.stdout.count("src/field/signal/")), (0, 3))


unittest.main()
