import sqlite3

from harness import *

# MB 10 (retentive) says how OB 100 was called, MB 11 (retentive) which event stopped the CPU before.
COUNTING = """DATA_BLOCK DB 1
STRUCT
  count : INT := {start};
END_STRUCT
BEGIN
END_DATA_BLOCK
ORGANIZATION_BLOCK OB 100
BEGIN
NETWORK
      L     LB 1
      T     MB 10
END_ORGANIZATION_BLOCK
ORGANIZATION_BLOCK OB 1
BEGIN
NETWORK
      L     DB1.count
      L     {step}
      +I
      T     DB1.count
      UN    E 0.7
      SPB   good
      L     W#16#FFFF
      BTI
good: NOP   0
END_ORGANIZATION_BLOCK
"""
PRINT = ("--print", "DB1.DBW 0, MB 10", "--json")


class Card(Case):
    def setUp(self):
        super().setUp()
        self.program(start=5, step=1)

    def program(self, **values):
        self.write("a.awl", COUNTING.format(**values))

    def run_card(self, *arguments, code=GOOD):
        values = self.expect(code, "run", *arguments, "--card", "card", "--cycles", "3", *PRINT).json
        return values["DB1.DBW 0"], values["MB 10"]

    # S7-MEM-02, S7-CPU-28, S7-STATE-04: the end of the process is a power failure.
    def test_goes_on_after_a_power_failure(self):
        self.assertEqual(self.run_card("a.awl"), (8, 0x81))
        self.assertEqual(self.run_card("a.awl"), (11, 0x82))
        self.assertEqual(self.run_card(), (14, 0x82))

    def test_without_a_card_nothing_is_kept(self):
        for _ in range(2):
            call = self.expect(GOOD, "run", "a.awl", "--cycles", "3", *PRINT)
            self.assertEqual(call.json["DB1.DBW 0"], 8)

    # A CPU that was in STOP stays there when it is switched on; `run` then turns the switch.
    def test_after_a_fault_it_starts_by_hand(self):
        self.run_card("a.awl", "--set", "E 0.7 = 1", code=FAULT)
        self.assertEqual(self.run_card("a.awl"), (9, 0x81))

    # S7-MEM-04: only blocks that changed are loaded, and a data block then brings its values.
    def test_a_changed_program(self):
        self.run_card("a.awl")
        self.program(start=5, step=10)
        self.assertEqual(self.run_card("a.awl"), (38, 0x81))
        self.program(start=100, step=10)
        self.assertEqual(self.run_card("a.awl"), (130, 0x81))

    def test_another_cpu_begins_anew(self):
        self.run_card("a.awl")
        self.assertEqual(self.run_card("a.awl", "--cpu", "314C-2 DP"), (8, 0x81))
        self.assertEqual(self.run_card(), (11, 0x82))

    # S7-CPU-02: needed and free bytes, and the old program stays.
    def test_too_much_for_work_memory(self):
        self.run_card("a.awl")
        blocks = "".join(f"DATA_BLOCK DB {n}\nSTRUCT\n a : ARRAY [1..16000] OF BYTE;\nEND_STRUCT\nBEGIN\nEND_DATA_BLOCK\n"
                         for n in range(10, 14))
        self.write("big.awl", blocks + block("NOP 0"))
        call = self.expect(PROBLEMS, "run", "big.awl", "--card", "card", "--cycles", "1")
        self.assertRegex(call.err, r"big.awl: error: .* needs 64\d\d\d bytes .* 49152 bytes are free .*\[P1010\]")
        self.assertEqual(self.run_card(), (11, 0x82))
        self.write("fits.awl", blocks.replace("DB 13\n", "DB 13\nUNLINKED\n").replace("DB 12\n", "DB 12\nUNLINKED\n") + block("NOP 0"))
        self.expect(GOOD, "run", "fits.awl", "--cycles", "1")  # S7-MEM-03: these two stay in load memory

    # S7-MEM-04: the card has the values then, and a CPU that was never on brings them.
    def test_copy_ram_to_rom(self):
        self.run_card("a.awl", "--copy-ram-to-rom")
        card = sqlite3.connect(self.folder / "card" / "card.sqlite")
        card.execute("DELETE FROM page")
        card.execute("DELETE FROM area")
        card.execute("DELETE FROM setting WHERE name = 'contents'")
        card.execute("PRAGMA user_version = 1")  # of format 1, which does not say that there were areas
        card.commit()
        card.close()
        self.assertEqual(self.run_card(), (11, 0x81))
        self.expect(USAGE, "run", "a.awl", "--copy-ram-to-rom", "--cycles", "1")

    def refused(self, number, *arguments):
        call = self.expect(UNREADABLE, "run", *arguments, "--cycles", "1")
        self.assertIn(f"[{number}]", call.err)

    def test_what_is_no_card(self):
        self.write("foreign/card.sqlite", "this is text")
        self.write("file", "")
        self.refused("P1002", "a.awl", "--card", "foreign")
        self.assertEqual(self.read("foreign/card.sqlite"), "this is text")
        self.refused("P1002", "a.awl", "--card", "file")
        self.refused("P1007", "--card", "new")
        self.assertFalse((self.folder / "new").exists())

    def test_a_damaged_card(self):
        self.run_card("a.awl")
        card = self.folder / "card" / "card.sqlite"
        content = bytearray(card.read_bytes())
        content[1024:3000] = bytes(1976)
        card.write_bytes(content)
        self.refused("P1003", "a.awl", "--card", "card")
        self.assertEqual(card.read_bytes(), content)

    def test_a_card_in_use(self):
        self.run_card("a.awl")
        other = sqlite3.connect(self.folder / "card" / "card.sqlite", isolation_level=None)
        other.execute("PRAGMA locking_mode = EXCLUSIVE")
        other.execute("BEGIN EXCLUSIVE")
        self.refused("P1004", "a.awl", "--card", "card")
        other.close()
        self.assertEqual(self.run_card(), (11, 0x82))

    def test_without_program_and_card(self):
        self.assertIn("PATH", self.expect(USAGE, "run", "--cycles", "1").err)

    def test_a_project_brings_its_configuration(self):
        self.write("p/merker.toml", "[project]\nname = \"P\"\n[cpu]\nmodel = \"314C-2 DP\"\n")
        self.write("p/a.awl", self.read("a.awl"))
        self.run_card("p")
        self.assertEqual(self.run_card(), (11, 0x82))


class Memory(Case):
    DATA = "DATA_BLOCK DB {0}\n{1}STRUCT\n a : ARRAY [1..{2}] OF BYTE;\nEND_STRUCT\nBEGIN\nEND_DATA_BLOCK\n"

    def memory(self, text):
        self.write("a.awl", text + block("SE T 1\nSE T 3\nZV Z 1"))
        return self.expect(GOOD, "list", "a.awl", "--memory", "--json").json["memory"]

    def resource(self, memory, name):
        return next(r for r in memory["resources"] if r["name"] == name)

    # S7-MEM-03
    def test_what_is_not_linked_takes_no_work_memory(self):
        linked = self.memory(self.DATA.format(1, "", 1000))
        unlinked = self.memory(self.DATA.format(1, "UNLINKED\n", 1000))
        self.assertEqual(linked["work_bytes"] - unlinked["work_bytes"], 1000)
        self.assertEqual(linked["load_bytes"], unlinked["load_bytes"])
        self.assertEqual(linked["system_bytes"]["flags"], 256)

    # S7-CPU-23
    def test_above_80_percent_there_is_no_reserve(self):
        data = "".join(self.DATA.format(n, "", 13100) for n in (1, 2, 3))
        memory = self.memory(data)
        self.assertEqual((self.resource(memory, "timers")["used"], self.resource(memory, "counters")["used"]), (2, 1))
        work = self.resource(memory, "work memory")
        self.assertEqual((work["available"], work["percent"], work["no_reserve"]), (49152, 79, False))
        work = self.resource(self.memory(data + self.DATA.format(4, "", 1000)), "work memory")
        self.assertEqual((work["percent"], work["no_reserve"]), (82, True))
        self.assertRegex(self.expect(GOOD, "list", "a.awl", "--memory").out, r"work memory .* 82 %: no expansion reserve")
