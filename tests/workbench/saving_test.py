"""The server is killed while it saves: a file is the old one or the new one, whole, and nothing else stands among the files."""
import json
import random
import re
import time
import unittest

from served import Served

LINES = 20_000
SYMBOLS = 500
ROUNDS = 8
SEED = 1991
TEMPORARY = ".merker-saving-*"


def text(mark, number):
    return f"{mark} {number}\n" * LINES


def rows(number):
    return [{"symbol": f"S{i}", "operand": f"M {i // 8}.{i % 8}", "type": "BOOL", "comment": str(number)} for i in range(SYMBOLS)]


class Saving(Served):
    def prepare(self):
        super().prepare()
        (self.project / "symbols.sym").write_text("", encoding="utf-8")
        for name in ("belt.vat", "notes.awl"):
            (self.project / name).write_text("", encoding="utf-8")
        self.chance = random.Random(SEED)
        self.sent = self.answered = 0

    def save(self, browser, wait=True):
        """One more version; without waiting the server is killed while it works on it."""
        self.sent += 1
        browser.last += 1
        request = {"id": browser.last, "revision": self.revision, **self.request(self.sent)}
        begin = time.monotonic()
        browser.send(json.dumps(request))
        if not wait:
            return self.kill()
        while (message := json.loads(browser.receive())).get("id") != browser.last:
            pass
        self.assertIn("result", message)
        self.revision = message["result"].get("revision")
        self.answered, self.needed = self.sent, time.monotonic() - begin
        return None

    def kill(self):
        # Any moment of the time that the last one needed: however fast the machine is.
        time.sleep(self.chance.random() * self.needed)
        self.process.kill()
        self.process.communicate(timeout=60)

    def rounds(self, read, look):
        """What stands in the file after each kill, and that it goes on."""
        for _ in range(ROUNDS):
            browser = self.browser()
            self.revision = browser.call(**read).get("revision") if read else None
            for _ in range(self.chance.randrange(1, 4)):
                self.save(browser)
            self.save(browser, wait=False)
            look()
            self.start()
            again = self.browser()
            self.assertEqual({row["path"] for row in again.call("files.list")["files"]}, self.names())
            self.assertEqual(self.errors(again), [])

    @staticmethod
    def errors(browser):
        return [problem for problem in browser.call("program.check")["problems"] if problem["severity"] == "error"]

    def names(self):
        return {path.name for path in self.project.iterdir() if not path.name.startswith(".")}

    def whole(self, name, pattern, count):
        """The one version that every line names, neither older than what was answered nor newer than what was sent."""
        found = re.findall(pattern, (self.project / name).read_text(encoding="utf-8"), re.M)
        self.assertEqual((len(found), len(set(found))), (count, 1), f"seed {SEED}")
        self.assertIn(int(found[0]), range(self.answered, self.sent + 1))

    def file(self, name, mark):
        self.request = lambda number: {"do": "files.write", "path": name, "text": self.begin + text(mark, number)}
        self.begin = (self.project / name).read_text(encoding="utf-8")
        self.rounds({"do": "files.read", "path": name}, lambda: self.whole(name, f"^{mark} (\\d+)$", LINES))
        browser = self.browser()
        self.revision = browser.call("files.read", path=name)["revision"]
        self.save(browser)
        self.assertEqual(list(self.project.glob(TEMPORARY)), [], "what a kill left goes with the next save")

    def test_a_source(self):
        self.file("notes.awl", "//")

    def test_a_variable_table(self):
        self.file("belt.vat", "//")

    def test_the_hardware(self):
        self.file("merker.toml", "#")

    def test_the_symbols(self):
        self.request = lambda number: {"do": "symbols.write", "rows": rows(number)}
        self.rounds({"do": "symbols.read"}, lambda: self.whole("symbols.sym", r"// (\d+)$", SYMBOLS))

    def test_a_new_file(self):
        self.request = lambda number: {"do": "files.create", "path": f"new{number}.awl", "text": text("//", number)}

        def look():
            for number in range(1, self.sent + 1):
                path = self.project / f"new{number}.awl"
                if number == self.sent and not path.exists():
                    self.sent -= 1
                else:
                    self.assertEqual(path.read_text(encoding="utf-8"), text("//", number), f"seed {SEED}")

        self.rounds(None, look)

    def test_the_state_of_the_cpu(self):
        self.request = lambda _: {"do": "cpu.save", "path": "now.state", "replace": True}
        self.rounds(None, lambda: json.loads((self.project / "now.state").read_text(encoding="utf-8")))
        self.browser().call("cpu.load", path="now.state")

    def test_what_a_kill_left_is_no_file_of_the_project(self):
        (self.project / ".merker-saving-half.awl").write_text("FUNCTION FC", encoding="utf-8")
        self.end()
        self.start()
        browser = self.browser()
        self.assertEqual({row["path"] for row in browser.call("files.list")["files"]}, self.names())
        self.assertEqual(self.errors(browser), [])
        self.assertEqual(browser.problems("files.read", path=".merker-saving-half.awl"), ["P1309"])


if __name__ == "__main__":
    unittest.main()
