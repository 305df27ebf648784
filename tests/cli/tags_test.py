"""merker tags: tag lists for other tools (docs/formats/tags.md)."""
import csv
import io
import json

from harness import GOOD, PROBLEMS, UNREADABLE, USAGE, Case

SOURCE = """DATA_BLOCK "Recipe"
STRUCT
  speed : INT; // mm/s
  text : STRING [4];
END_STRUCT
BEGIN
END_DATA_BLOCK
"""
SYMBOLS = """Start E 0.0 BOOL // push button; "green"
Wait T 5
Recipe DB 10
"""


class Tags(Case):
    def setUp(self):
        super().setUp()
        self.write("plant/merker.toml", "")
        self.write("plant/a.awl", SOURCE)
        self.write("plant/a.sym", SYMBOLS)

    def test_a_table(self):
        rows = list(csv.DictReader(io.StringIO(self.expect(GOOD, "tags", "plant").out)))
        self.assertEqual([row["name"] for row in rows], ["Start", "Wait", "Recipe.speed", "Recipe.text"])
        self.assertEqual([row["address"] for row in rows], ["E 0.0", "T 5", "DB10.DBW 0", "DB10.DBB 2"])
        self.assertEqual(rows[0]["comment"], 'push button; "green"')
        self.assertEqual(rows[2]["comment"], "mm/s")
        self.assertEqual(rows[3]["type"], "STRING[4]")
        english = self.expect(GOOD, "tags", "plant", "--mnemonics", "en", "--symbols-only").out
        self.assertIn("Start,I 0.0,BOOL", english)
        self.assertNotIn("Recipe", english)

    def test_a_file(self):
        out = self.expect(GOOD, "tags", "plant", "--format", "node-red", "-o", "tags.csv").out
        self.assertEqual(out, "tags.csv: 3 tags\n")
        text = (self.folder / "tags.csv").read_bytes().decode()
        self.assertEqual(text, "I0.0;Start\r\nDB10,INT0;Recipe.speed\r\nDB10,S2.4;Recipe.text\r\n")
        self.expect(UNREADABLE, "tags", "plant", "-o", "missing/tags.csv")

    def test_what_a_tool_cannot_have_is_named(self):
        run = self.expect(GOOD, "tags", "plant", "--format", "fuxa", "--device", "Press")
        self.assertEqual(run.err, "2 tags are left out, because fuxa has no address for them: Wait, Recipe.text\n")
        device = json.loads(run.out)[0]
        self.assertEqual(device["name"], "Press")
        self.assertEqual(sorted(device["tags"]), ["t_Recipe.speed", "t_Start"])

    def test_step5_has_its_assignment_list(self):
        self.write("p.s5", "OB 1\n U -START\n = A 1.0\n BE\n")
        self.write("pZ0.SEQ", "\tE 1.0\tSTART\tButton\r\n".encode("cp437"))
        self.assertIn("START,E 1.0,BOOL,RW,Button", self.expect(GOOD, "tags", "p.s5").out)

    def test_errors(self):
        self.expect(USAGE, "tags", "plant", "--format", "wincc")
        self.write("bad.awl", "FUNCTION FC 1 : VOID\nBEGIN\nQ 1\nEND_FUNCTION\n")
        self.expect(PROBLEMS, "tags", "bad.awl")
