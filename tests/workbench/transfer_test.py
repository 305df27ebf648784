"""Import and download through the sockets: the PLC goes on, and nothing of what was sent stays."""
import base64
import io
import json
import os
import pathlib
import signal
import tempfile
import time
import unittest
import zipfile

from served import Served

MEGA = 1 << 20
BLOCK = "FUNCTION FC {0} : VOID\nBEGIN\nNETWORK\n      U     E 0.0;\n      =     M {0}.0;\nEND_FUNCTION\n"


def part(path, data):
    return {"path": path, "data": base64.b64encode(data).decode()}


class Transfer(Served):
    def prepare(self):
        super().prepare()
        temporary = tempfile.TemporaryDirectory(prefix="merker-sent-")
        self.addCleanup(temporary.cleanup)
        self.temporary = pathlib.Path(temporary.name)
        before = os.environ.get("TMPDIR")
        os.environ["TMPDIR"] = temporary.name
        self.addCleanup(lambda: os.environ.pop("TMPDIR") if before is None else os.environ.update(TMPDIR=before))
        self.arguments = ("--workspace", str(self.folder / "work"))

    def send(self, browser, path, data):
        for at in range(0, len(data), MEGA):
            browser.call("import.add", files=[part(path, data[at:at + MEGA])])

    def left(self):
        return [one.name for one in self.temporary.iterdir()]

    def gone(self):
        end = time.monotonic() + 60
        while self.left() and time.monotonic() < end:
            time.sleep(0.01)
        self.assertEqual(self.left(), [])

    def test_a_large_project_comes_while_the_plc_runs(self):
        packed = io.BytesIO()
        with zipfile.ZipFile(packed, "w") as archive:
            archive.writestr("merker.toml", '[project]\nname = "Large"\n')
            for number in range(1, 200):
                archive.writestr(f"fc{number}.awl", BLOCK.format(number))
            archive.writestr("notes.txt", os.urandom(20 * MEGA))
        browser, other = self.browser(), self.browser()
        browser.call("import.begin")
        self.send(browser, "large.zip", packed.getvalue())
        self.assertEqual(browser.call("import.look")["programs"], ["large"])
        before = other.call("variables.read", items=[{"operand": "MW 20"}])["items"][0]["raw"]
        result = browser.call("import.run", name="large")
        self.assertFalse(result["lost"], result)
        self.assertNotEqual(other.call("variables.read", items=[{"operand": "MW 20"}])["items"][0]["raw"], before)
        self.assertEqual(other.state["mode"], "RUN")
        self.assertEqual(len(list((self.folder / "work/large").glob("fc*.awl"))), 199)
        self.gone()

    def test_a_broken_connection_leaves_nothing(self):
        browser = self.browser()
        browser.call("import.begin")
        self.send(browser, "half.zip", b"PK\3\4" + bytes(3 * MEGA))
        self.assertEqual(len(self.left()), 1)
        browser.close()
        self.gone()
        self.assertFalse((self.folder / "work").exists())

    def test_what_was_added_to_the_open_project_is_taken_back(self):
        def cancel(browser):
            browser.send(json.dumps({"id": 1_000_000, "do": "import.cancel"}))

        before = sorted(self.project.iterdir())
        for ends in (cancel, lambda browser: browser.close()):
            browser = self.browser()
            browser.call("import.begin")
            browser.call("import.add", files=[part(f"fc{number}.awl", BLOCK.format(number).encode()) for number in range(1, 1001)])
            browser.send(json.dumps({"id": 999_999, "do": "import.run"}))
            while not any(self.project.glob("fc*.awl")):
                time.sleep(0.001)
            ends(browser)
            self.gone()
            self.assertEqual(sorted(self.project.iterdir()), before)

    def test_the_end_of_the_program_leaves_nothing(self):
        browser = self.browser()
        browser.call("import.begin")
        self.send(browser, "a.awl", BLOCK.format(1).encode())
        self.end()
        self.assertEqual(self.left(), [])

    def test_what_a_killed_program_left_is_deleted_by_the_next_one(self):
        browser = self.browser()
        browser.call("import.begin")
        self.send(browser, "a.awl", BLOCK.format(1).encode())
        self.process.kill()
        self.process.wait()
        self.assertEqual(len(self.left()), 1)
        self.start()
        self.assertEqual(self.left(), [])
        # One that is in use stays.
        second = self.browser()
        second.call("import.begin")
        self.send(second, "b.awl", BLOCK.format(2).encode())
        mine, first = self.left(), self.process
        self.start()
        self.assertEqual(self.left(), mine)
        self.assertEqual(second.call("import.look")["name"], "b")
        second.close()
        first.send_signal(signal.SIGINT)
        first.communicate(timeout=60)

    def test_many_files_into_the_open_project(self):
        browser = self.browser()
        browser.call("import.begin")
        for at in range(0, 3000, 1000):
            browser.call("import.add", files=[part(f"fc{number}.awl", BLOCK.format(number).encode())
                                              for number in range(at + 1, at + 1001)])
        result = browser.call("import.run")
        self.assertEqual(len(result["files"]), 3000)
        self.assertFalse(result["lost"], result["report"][:5])

    def test_the_zip_is_the_folder(self):
        browser = self.browser()
        begun = browser.call("download.begin")
        data = b""
        while len(data) < begun["size"]:
            piece = base64.b64decode(browser.call("download.piece", at=len(data))["data"])
            self.assertTrue(piece)
            data += piece
        with zipfile.ZipFile(io.BytesIO(data)) as archive:
            self.assertIsNone(archive.testzip())
            self.assertEqual(archive.namelist(), ["main.awl", "merker.toml"])
            self.assertEqual(archive.read("main.awl"), (self.project / "main.awl").read_bytes())


if __name__ == "__main__":
    unittest.main()
