#!/usr/bin/env python3
"""usage: kill_test.py MERKER s7|step5 ROUNDS [SEED]

Starts `merker run --card`, ends it by SIGKILL at a random moment and looks at what the card has kept: ROUNDS times.
Each round downloads another program, and runs it in virtual time, where one transaction follows the other, or in real
time. What must hold each time (S7-MEM-02, S7-CPU-28, S7-LIM-04):
- all copies that the program wrote in one cycle are of the same cycle,
- no cycle is missing that was reported outside (a line of the trace), or that an earlier round had found,
- the blocks on the card are those of one download.
"""
import json
import os
import pathlib
import random
import select
import signal
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).parent
PROGRAM = (HERE / "kept.awl").read_text(encoding="utf-8")
LISTING = (HERE / "kept.s5").read_text(encoding="utf-8")
# Two blocks that change together.
VERSION = """
DATA_BLOCK DB 3
NON_RETAIN
STRUCT
  version : DWORD := DW#16#{0:X};
END_STRUCT
BEGIN
END_DATA_BLOCK
"""
LOOK = """
NETWORK
TITLE = The versions of OB 1 and of DB 3
      L     DW#16#{0:X};
      T     MD 20;
      L     DB3.version;
      T     MD 24;
END_ORGANIZATION_BLOCK
"""


class S7:
    """A station: retentive flags and counters beside the data blocks (S7-MEM-02, S7-CPU-28)."""
    name, count = "version.awl", "DB1.DBD 0"
    copies = ["DB1.DBD 0", "DB1.DBD 304", "DB1.DBD 908", "MD 0", "MD 12"]
    inverses = ["DB1.DBD 912", "MD 8"]
    versions = ["MD 20", "MD 24"]
    digits = ["Z 7"]  # the last three
    lines = 400  # of the trace, the most to wait for in real time

    @staticmethod
    def text(version):
        return VERSION.format(version) + PROGRAM.replace("END_ORGANIZATION_BLOCK", LOOK.format(version))


class Step5:
    """A SINUMERIK: its battery keeps data blocks and program (S5-MEM-09)."""
    name, count = "version.s5", "DB10.DD 0"
    copies = ["DB10.DD 0", "DB10.DD 130", "DB10.DD 254"]
    inverses = ["DB10.DD 128"]
    versions = ["MW 100", "MW 102"]
    digits = []
    lines = 12  # a cycle begins each 60 ms

    @staticmethod
    def text(version):
        return LISTING.format(version)


class Test:
    def __init__(self, merker, kind, folder, chance):
        self.merker, self.kind, self.folder, self.chance = merker, kind, folder, chance
        self.count = self.reported_rounds = 0
        self.card, self.trace = str(folder / "card"), str(folder / "trace")
        os.mkfifo(self.trace)

    def source(self, version):
        path = self.folder / self.kind.name
        path.write_text(self.kind.text(version), encoding="utf-8")
        return str(path)

    def run_and_kill(self, version):
        """The count of the last cycle that the process had reported; 0 if none."""
        reader = os.open(self.trace, os.O_RDONLY | os.O_NONBLOCK)
        # In real time it serves the workbench, too: at a port that no other test has.
        virtual = ["--for", "1000h"] if self.chance.random() < 0.7 else ["--port", "0"]
        process = subprocess.Popen([self.merker, "run", self.source(version), "--card", self.card, "--trace", self.trace,
                                    "--watch", self.kind.count, *virtual], stdout=subprocess.DEVNULL)
        seen = self.some_time(reader, process, 400 if "--for" in virtual else self.kind.lines)
        process.send_signal(signal.SIGKILL)
        process.wait()
        seen += self.rest(reader)
        os.close(reader)
        if process.returncode != -signal.SIGKILL:
            sys.exit(f"merker ended by itself with {process.returncode}")
        lines = seen.split(b"\n")[:-1]
        return int(lines[-1].rsplit(b"#", 1)[1], 16) if lines else 0

    def some_time(self, reader, process, most):
        """Until so many lines were read, or only for the moment in which the program starts; not beyond its end."""
        seen = b""
        if self.chance.random() < 0.25:
            select.select([], [], [], self.chance.random() * 0.03)
            return seen
        wanted = self.chance.randrange(1, most)
        while seen.count(b"\n") < wanted and process.poll() is None:
            if select.select([reader], [], [], 10)[0]:
                seen += self.read(reader)
        # The line that was read last woke this process up; without a moment more every kill would hit the same place.
        select.select([], [], [], self.chance.random() * 0.003)
        return seen

    @staticmethod
    def read(reader):
        try:
            return os.read(reader, 65536)
        except BlockingIOError:
            return b""

    def rest(self, reader):
        seen = b""
        while part := self.read(reader):
            seen += part
        return seen

    def look(self):
        """What is on the card, seen by another process one cycle later; None if there is no program yet."""
        kind = self.kind
        done = subprocess.run([self.merker, "run", "--card", self.card, "--cycles", "1", "--json", "--print",
                               ", ".join(kind.copies + kind.inverses + kind.digits + kind.versions)],
                              capture_output=True, encoding="utf-8", check=False)
        if done.returncode == 4 and "P1007" in done.stderr and self.count == 0:
            return None
        if done.returncode != 0:
            sys.exit(f"exit {done.returncode}: {done.stderr}")
        return json.loads(done.stdout)

    def round(self, number):
        reported = self.run_and_kill(number)
        self.reported_rounds += reported > 0
        kept = self.look()
        if kept is None and reported == 0:
            return []
        kind, count = self.kind, kept[self.kind.count]
        wrong = [name for name in kind.copies if kept[name] != count]
        wrong += [name for name in kind.inverses if kept[name] != 0xFFFFFFFF ^ count]
        wrong += [name for name in kind.digits if kept[name] != count % 1000]
        wrong += ["versions"] if kept[kind.versions[0]] != kept[kind.versions[1]] else []
        wrong += ["a reported cycle is missing"] if count < reported + 1 else []
        wrong += ["a cycle is missing"] if count < self.count + 1 else []
        self.count = count
        return [f"round {number}: {wrong}, reported {reported}: {kept}"] if wrong else []


def main():
    kind = {"s7": S7, "step5": Step5}[sys.argv[2]]
    rounds = int(sys.argv[3])
    seed = int(sys.argv[4]) if len(sys.argv) > 4 else 314
    print(f"seed {seed}")
    with tempfile.TemporaryDirectory(prefix="merker-kill-") as folder:
        test = Test(sys.argv[1], kind, pathlib.Path(folder), random.Random(seed))
        for number in range(1, rounds + 1):
            for finding in test.round(number):
                sys.exit(finding)
        print(f"{rounds} times killed, {test.reported_rounds} times after a reported cycle, {test.count} cycles")
        if test.reported_rounds < rounds // 2:
            sys.exit("too few rounds came to a cycle")


main()
