"""Starts the program under test (environment variable MERKER) with its workbench on a free port."""
import os
import pathlib
import re
import signal
import subprocess
import tempfile
import unittest

from web_socket import Browser

# A 0.0 follows E 0.0, MW 20 counts cycles, E 0.7 leads to a fault.
PROGRAM = """ORGANIZATION_BLOCK OB 1
BEGIN
NETWORK
      U     E 0.0
      =     A 0.0
      L     MW 20
      +     1
      T     MW 20
      UN    E 0.7
      SPB   good
      L     W#16#FFFF
      BTI
good: NOP   0
END_ORGANIZATION_BLOCK
"""


class Served(unittest.TestCase):
    command = "run"
    arguments = ()

    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="merker-")
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.project = self.folder / "plant"
        self.prepare()
        self.start()

    def prepare(self):
        self.project.mkdir()
        (self.project / "merker.toml").write_text('[project]\nname = "Plant"\n', encoding="utf-8")
        (self.project / "main.awl").write_text(PROGRAM, encoding="utf-8")

    def start(self):
        self.process = subprocess.Popen(
            [os.environ["MERKER"], self.command, *self.target(), "--port", "0", *self.arguments], cwd=self.folder,
            text=True, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        self.addCleanup(self.end)
        line = self.process.stdout.readline()
        found = re.search(r"(https?)://[^:/]+:(\d+)/", line)
        if not found:
            self.fail(line + self.process.communicate(timeout=60)[1])
        self.port = int(found.group(2))

    def target(self):
        return ["plant"]

    def end(self):
        """Ctrl-C; output, errors and exit code."""
        if self.process.poll() is None:
            self.process.send_signal(signal.SIGINT)
        try:
            self.out, self.err = self.process.communicate(timeout=60)
        except ValueError:  # ended already
            pass
        return self.process.returncode

    def browser(self, **options):
        browser = Browser(self.port, **options)
        self.addCleanup(browser.close)
        return browser
